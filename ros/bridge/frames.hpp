// SPDX-License-Identifier: Apache-2.0
// C++17. The one place where NED and ENU meet.
#pragma once

#include <string>

#include "ros/bridge/plain.hpp"

namespace fairway::bridge {

/// How the messages of a ROS graph are to be read.
enum class Frame {
  enu,  ///< REP 103: world east-north-up, body forward-left-up
  ned,  ///< world north-east-down, body forward-starboard-down, as vehicles of the sea often publish
};

/// "enu" or "ned". Throws std::runtime_error for anything else.
Frame frame_of(const std::string& name);

/// World vectors: east-north-up of north-east-down and back. Exact.
constexpr Triple flip_world(const Triple& v) { return {v[1], v[0], -v[2]}; }
/// Body vectors: forward-left-up of forward-starboard-down and back. Exact.
constexpr Triple flip_body(const Triple& v) { return {v[0], -v[1], -v[2]}; }
/// Attitudes: of the body forward-left-up in east-north-up, of that of the body forward-starboard-down in
/// north-east-down; and back. To rounding.
Quaternion flip_attitude(const Quaternion& q);

/// From fairway's frame to that of the graph or back: each way is its own inverse, and with `ned` nothing
/// changes, not a bit.
constexpr Triple world_in(Frame frame, const Triple& v) { return frame == Frame::enu ? flip_world(v) : v; }
constexpr Triple body_in(Frame frame, const Triple& v) { return frame == Frame::enu ? flip_body(v) : v; }
inline Quaternion attitude_in(Frame frame, const Quaternion& q) {
  return frame == Frame::enu ? flip_attitude(q) : q;
}
Motion motion_in(Frame frame, const Motion& motion);

}  // namespace fairway::bridge
