// SPDX-License-Identifier: Apache-2.0
// Messages of ROS 2 from the bridge's plain values and back.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "ros/bridge/frames.hpp"
#include "ros/ros2/memory.hpp"
#include "ros/ros2/messages.hpp"

namespace fairway::ros2 {

using bridge::BodyVelocity;
using bridge::Frame;
using bridge::Mark;
using bridge::Motion;
using bridge::Triple;

/// To the nearest nanosecond; zero for what a stamp cannot hold: NaN, what is before 0 or after 2038.
Time stamp_of(double seconds);
/// [s]
double seconds_of(const Time& stamp);

/// A place [m, NED] in the graph's frame.
Point place_of(const Triple& position_n, Frame frame);
/// A place of the graph. [m, NED]
Triple place_of(const Point& point, Frame frame);

/// Pose in `world`, twist in `child`'s body axes. Nothing is said of how sure it is: the covariances are 0.
Odometry odometry_of(const Motion& motion, Frame frame, const std::string& world, const std::string& child,
                     Memory& memory);
/// Its numbers as they are, usable or not: whoever takes them judges.
Motion motion_of(const Odometry& odometry, Frame frame);

TransformStamped transform_of(const Motion& motion, Frame frame, const std::string& world,
                              const std::string& child, Memory& memory);

/// A velocity for the vehicle's own controller, in body axes: forward-left-up with `enu`,
/// forward-starboard-down with `ned`. Stamped with the time of the navigation that it answers.
TwistStamped twist_of(const BodyVelocity& request, double time, Frame frame, const std::string& child,
                      Memory& memory);
/// The velocity of a twist; its roll and pitch rates are not used.
BodyVelocity body_velocity_of(const TwistStamped& twist, Frame frame);

/// A place to go to; its attitude says nothing.
PoseStamped goal_of(const Triple& position_n, double time, Frame frame, const std::string& world,
                    Memory& memory);

/// What was drawn, after a marker that clears what `space` showed before.
MarkerArray markers_of(const std::vector<Mark>& marks, double time, Frame frame, const std::string& world,
                       const std::string& space, Memory& memory);

}  // namespace fairway::ros2
