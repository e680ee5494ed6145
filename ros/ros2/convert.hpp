// SPDX-License-Identifier: Apache-2.0
// Messages of ROS 2 from the bridge's plain values and back.
#pragma once

#include <string>
#include <vector>

#include "ros/bridge/messages.hpp"
#include "ros/ros2/memory.hpp"
#include "ros/ros2/messages.hpp"

namespace fairway::ros2 {

using bridge::BodyVelocity;
using bridge::Frame;
using bridge::Mark;
using bridge::Motion;
using bridge::place_of;
using bridge::Triple;

/// To the nearest nanosecond; zero for what a stamp cannot hold: NaN, what is before 0 or after 2038.
Time stamp_of(double seconds);
/// [s]
double seconds_of(const Time& stamp);

/// Pose in `world`, twist in `child`'s body axes.
Odometry odometry_of(const Motion& motion, Frame frame, const std::string& world, const std::string& child,
                     Memory& memory);
Motion motion_of(const Odometry& odometry, Frame frame);

TransformStamped transform_of(const Motion& motion, Frame frame, const std::string& world,
                              const std::string& child, Memory& memory);

/// Stamped with the time of the navigation that it answers.
TwistStamped twist_of(const BodyVelocity& request, double time, Frame frame, const std::string& child,
                      Memory& memory);
BodyVelocity body_velocity_of(const TwistStamped& twist, Frame frame);

/// A place to go to; its attitude says nothing.
PoseStamped goal_of(const Triple& position_n, double time, Frame frame, const std::string& world,
                    Memory& memory);

/// What was drawn, after a marker that clears what `space` showed before.
MarkerArray markers_of(const std::vector<Mark>& marks, double time, Frame frame, const std::string& world,
                       const std::string& space, Memory& memory);

}  // namespace fairway::ros2
