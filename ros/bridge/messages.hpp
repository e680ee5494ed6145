// SPDX-License-Identifier: Apache-2.0
// C++17. The numbers of messages, whose members have the same names in ROS 1 and ROS 2, from the bridge's
// plain values and back. Stamps, texts and lists differ and stay with the nodes.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "ros/bridge/frames.hpp"

namespace fairway::bridge {

/// To the nearest nanosecond, as in a stamp.
inline std::int64_t nanoseconds_of(double seconds) {
  const double whole = std::floor(seconds);
  return static_cast<std::int64_t>(whole) * 1000000000 + std::llround((seconds - whole) * 1e9);
}

/// The stamp of a time [s]: zero for what it cannot hold, that is NaN, what is before 0 or not before `end`.
template <class Stamp>
Stamp stamp_before(double end, double seconds) {
  Stamp stamp{};
  if (!(seconds >= 0.0 && seconds < end)) return stamp;
  const std::int64_t ns = nanoseconds_of(seconds);
  auto& [whole, rest] = stamp;
  whole = static_cast<std::remove_reference_t<decltype(whole)>>(ns / 1000000000);
  rest = static_cast<std::uint32_t>(ns % 1000000000);
  return stamp;
}

/// The numbers of a Point or a Vector3.
template <class Message>
Triple triple_in(const Message& v) {
  return {v.x, v.y, v.z};
}

template <class Message>
void put(Message& to, const Triple& v) {
  to.x = v[0], to.y = v[1], to.z = v[2];
}

template <class Message>
void put(Message& to, const Quaternion& q) {
  to.w = q[0], to.x = q[1], to.y = q[2], to.z = q[3];
}

/// A place of the graph. [m, NED]
template <class Point>
Triple place_of(const Point& point, Frame frame) {
  return world_in(frame, triple_in(point));
}

/// Pose in the world, twist in the body's axes. Nothing is said of how sure it is: covariances stay 0.
template <class Odometry>
void put_motion(Odometry& odometry, const Motion& motion, Frame frame) {
  const Motion shown = motion_in(frame, motion);
  put(odometry.pose.pose.position, shown.position_n);
  put(odometry.pose.pose.orientation, shown.q_nb);
  put(odometry.twist.twist.linear, shown.v_b);
  put(odometry.twist.twist.angular, shown.omega_b);
}

/// Its numbers as they are, usable or not: whoever takes them judges. `time` [s].
template <class Odometry>
Motion motion_of(const Odometry& odometry, double time, Frame frame) {
  const auto& q = odometry.pose.pose.orientation;
  return motion_in(frame, {time,
                           triple_in(odometry.pose.pose.position),
                           {q.w, q.x, q.y, q.z},
                           triple_in(odometry.twist.twist.linear),
                           triple_in(odometry.twist.twist.angular)});
}

template <class Transform>
void put_transform(Transform& transform, const Motion& motion, Frame frame) {
  const Motion shown = motion_in(frame, motion);
  put(transform.translation, shown.position_n);
  put(transform.rotation, shown.q_nb);
}

/// A velocity for the vehicle's own controller, in body axes: forward-left-up with `enu`,
/// forward-starboard-down with `ned`.
template <class Twist>
void put_velocity(Twist& twist, const BodyVelocity& request, Frame frame) {
  put(twist.linear, body_in(frame, {request.surge_mps, request.sway_mps, request.heave_mps}));
  put(twist.angular, body_in(frame, {0.0, 0.0, request.yaw_rate_radps}));
}

/// The velocity of a twist; its roll and pitch rates are not used.
template <class Twist>
BodyVelocity velocity_of(const Twist& twist, Frame frame) {
  const Triple linear = body_in(frame, triple_in(twist.linear));
  return {linear[0], linear[1], linear[2], body_in(frame, triple_in(twist.angular))[2]};
}

/// A marker's name space, of what `space` shows; `space` may be empty.
inline std::string name_space(const std::string& space, const Mark& mark) {
  return space.empty() || mark.meaning.empty() ? space + mark.meaning : space + "/" + mark.meaning;
}

inline constexpr int delete_all_markers = 3;  ///< of visualization_msgs/Marker, before those that are shown

/// All of a marker but its header, texts and, where it has them, points.
template <class Marker>
void put_mark(Marker& marker, const Mark& mark, int id, Frame frame) {
  using Kind = Mark::Kind;
  marker.id = id;
  marker.type = static_cast<int>(mark.kind);
  marker.color.r = mark.colour[0], marker.color.g = mark.colour[1];
  marker.color.b = mark.colour[2], marker.color.a = mark.colour[3];
  marker.pose.orientation.w = 1.0;
  const double diameter = 2.0 * mark.radius;
  put(marker.scale, mark.kind == Kind::sphere  ? Triple{diameter, diameter, diameter}
                    : mark.kind == Kind::line  ? Triple{mark.width, 0.0, 0.0}
                    : mark.kind == Kind::words ? Triple{0.0, 0.0, mark.width}
                                               : Triple{1.0, 1.0, 1.0});
  if (mark.kind == Kind::sphere || mark.kind == Kind::words)
    put(marker.pose.position, world_in(frame, mark.points.front()));
}

/// Whether the marker of a mark has its points; the others have one place.
inline bool has_points(const Mark& mark) {
  return mark.kind == Mark::Kind::line || mark.kind == Mark::Kind::triangles;
}

}  // namespace fairway::bridge
