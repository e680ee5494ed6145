// SPDX-License-Identifier: Apache-2.0
// COLA2's navigation and body velocity requests from the bridge's plain values and back, for whatever message
// types have its fields: COLA2 itself is not needed to read this or to test it. C++17.
#pragma once

#include <ros/time.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "ros/bridge/plain.hpp"
#include "ros/ros1/middleware.hpp"

namespace fairway::ros1::cola2 {

/// Which of the vehicle's axes the avoider steers; the others are left to whoever else asks for them.
struct SteeredAxes {
  bool surge{true}, sway{true}, heave{true}, yaw{true};
};

/// The attitude of roll, pitch and yaw [rad], turned in the order yaw, pitch, roll.
inline bridge::Quaternion attitude_of(double roll, double pitch, double yaw) {
  const double cr = std::cos(roll / 2), sr = std::sin(roll / 2);
  const double cp = std::cos(pitch / 2), sp = std::sin(pitch / 2);
  const double cy = std::cos(yaw / 2), sy = std::sin(yaw / 2);
  return {cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
          cr * cp * sy - sr * sp * cy};
}

/// A navigation message: NED position, body velocity, attitude and its rates. What it says of angular rates
/// is taken as body rates. Unusable numbers are passed on: the avoider judges them.
template <class Navigation>
bridge::Motion motion_from(const Navigation& navigation) {
  bridge::Motion motion;
  motion.time = bridge::seconds_of(Middleware::nanoseconds(navigation.header.stamp));
  motion.position_n = {navigation.position.north, navigation.position.east, navigation.position.depth};
  motion.q_nb =
      attitude_of(navigation.orientation.roll, navigation.orientation.pitch, navigation.orientation.yaw);
  motion.v_b = {navigation.body_velocity.x, navigation.body_velocity.y, navigation.body_velocity.z};
  motion.omega_b = {navigation.orientation_rate.roll, navigation.orientation_rate.pitch,
                    navigation.orientation_rate.yaw};
  return motion;
}

/// A request for the vehicle's controller, on the steered axes.
template <class Request>
Request request_of(const bridge::BodyVelocity& velocity, const SteeredAxes& axes,
                   const std::string& requester, int priority, const ros::Time& stamp) {
  Request request;
  request.header.stamp = stamp;
  request.goal.requester = requester;
  request.goal.priority = static_cast<decltype(request.goal.priority)>(priority);
  request.twist.linear.x = velocity.surge_mps;
  request.twist.linear.y = velocity.sway_mps;
  request.twist.linear.z = velocity.heave_mps;
  request.twist.angular.z = velocity.yaw_rate_radps;
  request.disable_axis.x = !axes.surge;
  request.disable_axis.y = !axes.sway;
  request.disable_axis.z = !axes.heave;
  request.disable_axis.roll = true;
  request.disable_axis.pitch = true;
  request.disable_axis.yaw = !axes.yaw;
  return request;
}

/// The last command, repeated for a controller that forgets quickly, until it is too old to be meant.
class CommandKeeper {
 public:
  /// `timeout`: how old a command may be by when it came [s].
  explicit CommandKeeper(double timeout) : timeout_{timeout} {}

  /// One that is not finite is none.
  void hear(const bridge::BodyVelocity& command, double now) {
    if (bridge::is_finite(command)) command_ = command, heard_ = now;
  }

  /// What to ask for at `now` [s]; nothing without a fresh command, and the controller's own rules apply.
  std::optional<bridge::BodyVelocity> at(double now) const {
    const double age = now - heard_;
    return command_ && age >= 0.0 && age <= timeout_ ? command_ : std::nullopt;
  }

 private:
  double timeout_;
  std::optional<bridge::BodyVelocity> command_;
  double heard_{};
};

/// "surge heave yaw"; none for a name that is none of surge, sway, heave, yaw.
inline std::optional<SteeredAxes> axes_of(const std::string& words) {
  SteeredAxes axes{false, false, false, false};
  std::size_t begin = 0;
  while (begin < words.size()) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    const std::string word = words.substr(begin, end - begin);
    begin = end + 1;
    if (word.empty()) continue;
    bool* axis = word == "surge"   ? &axes.surge
                 : word == "sway"  ? &axes.sway
                 : word == "heave" ? &axes.heave
                 : word == "yaw"   ? &axes.yaw
                                   : nullptr;
    if (axis == nullptr) return std::nullopt;
    *axis = true;
  }
  return axes;
}

}  // namespace fairway::ros1::cola2
