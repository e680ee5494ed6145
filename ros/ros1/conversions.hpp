// SPDX-License-Identifier: Apache-2.0
// Messages of ROS 1 from the bridge's plain values and back. C++17.
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>

#include <cmath>
#include <string>

#include "ros/bridge/frames.hpp"

namespace fairway::ros1 {

using bridge::BodyVelocity;
using bridge::Frame;
using bridge::Motion;
using bridge::Quaternion;
using bridge::Triple;

/// To the nearest nanosecond; zero for what a stamp cannot hold: NaN, what is before 0 or after 2106.
inline ros::Time stamp_of(double seconds) {
  if (!(seconds >= 0.0 && seconds < 4294967295.0)) return {};
  const double whole = std::floor(seconds);
  const auto nanoseconds = static_cast<std::uint32_t>(std::lround((seconds - whole) * 1e9));
  const auto second = static_cast<std::uint32_t>(whole);
  return nanoseconds == 1000000000U ? ros::Time{second + 1U, 0U} : ros::Time{second, nanoseconds};
}

/// [s]
inline double seconds_of(const ros::Time& stamp) {
  return static_cast<double>(stamp.sec) + static_cast<double>(stamp.nsec) / 1e9;
}

inline geometry_msgs::Point point_of(const Triple& v) {
  geometry_msgs::Point point;
  point.x = v[0], point.y = v[1], point.z = v[2];
  return point;
}

inline geometry_msgs::Vector3 vector_of(const Triple& v) {
  geometry_msgs::Vector3 vector;
  vector.x = v[0], vector.y = v[1], vector.z = v[2];
  return vector;
}

inline geometry_msgs::Quaternion orientation_of(const Quaternion& q) {
  geometry_msgs::Quaternion orientation;
  orientation.w = q[0], orientation.x = q[1], orientation.y = q[2], orientation.z = q[3];
  return orientation;
}

/// The numbers of a Point or a Vector3.
template <class Message>
Triple triple_of(const Message& v) {
  return {v.x, v.y, v.z};
}

inline Quaternion quaternion_of(const geometry_msgs::Quaternion& q) { return {q.w, q.x, q.y, q.z}; }

/// A place [m, NED] in the graph's frame.
inline geometry_msgs::Point place_of(const Triple& position_n, Frame frame) {
  return point_of(world_in(frame, position_n));
}

/// A place of the graph. [m, NED]
inline Triple place_of(const geometry_msgs::Point& point, Frame frame) {
  return world_in(frame, triple_of(point));
}

/// Pose in `world`, twist in `child`'s body axes. Nothing is said of how sure it is: the covariances are 0.
inline nav_msgs::Odometry odometry_of(const Motion& motion, Frame frame, const std::string& world,
                                      const std::string& child) {
  const Motion shown = motion_in(frame, motion);
  nav_msgs::Odometry odometry;
  odometry.header.stamp = stamp_of(motion.time);
  odometry.header.frame_id = world;
  odometry.child_frame_id = child;
  odometry.pose.pose.position = point_of(shown.position_n);
  odometry.pose.pose.orientation = orientation_of(shown.q_nb);
  odometry.twist.twist.linear = vector_of(shown.v_b);
  odometry.twist.twist.angular = vector_of(shown.omega_b);
  return odometry;
}

/// Its numbers as they are, usable or not: whoever takes them judges.
inline Motion motion_of(const nav_msgs::Odometry& odometry, Frame frame) {
  const Motion shown{seconds_of(odometry.header.stamp), triple_of(odometry.pose.pose.position),
                     quaternion_of(odometry.pose.pose.orientation), triple_of(odometry.twist.twist.linear),
                     triple_of(odometry.twist.twist.angular)};
  return motion_in(frame, shown);
}

inline geometry_msgs::TransformStamped transform_of(const Motion& motion, Frame frame,
                                                    const std::string& world, const std::string& child) {
  const Motion shown = motion_in(frame, motion);
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = stamp_of(motion.time);
  transform.header.frame_id = world;
  transform.child_frame_id = child;
  transform.transform.translation = vector_of(shown.position_n);
  transform.transform.rotation = orientation_of(shown.q_nb);
  return transform;
}

/// A velocity for the vehicle's own controller, in body axes: forward-left-up with `enu`,
/// forward-starboard-down with `ned`. Stamped with the time of the navigation that it answers.
inline geometry_msgs::TwistStamped twist_of(const BodyVelocity& request, double time, Frame frame,
                                            const std::string& child) {
  geometry_msgs::TwistStamped twist;
  twist.header.stamp = stamp_of(time);
  twist.header.frame_id = child;
  twist.twist.linear = vector_of(body_in(frame, {request.surge_mps, request.sway_mps, request.heave_mps}));
  twist.twist.angular = vector_of(body_in(frame, {0.0, 0.0, request.yaw_rate_radps}));
  return twist;
}

/// The velocity of a twist; its roll and pitch rates are not used.
inline BodyVelocity body_velocity_of(const geometry_msgs::TwistStamped& twist, Frame frame) {
  const Triple linear = body_in(frame, triple_of(twist.twist.linear));
  return {linear[0], linear[1], linear[2], body_in(frame, triple_of(twist.twist.angular))[2]};
}

/// A place to go to; its attitude says nothing.
inline geometry_msgs::PoseStamped goal_of(const Triple& position_n, double time, Frame frame,
                                          const std::string& world) {
  geometry_msgs::PoseStamped goal;
  goal.header.stamp = stamp_of(time);
  goal.header.frame_id = world;
  goal.pose.position = place_of(position_n, frame);
  goal.pose.orientation.w = 1.0;
  return goal;
}

}  // namespace fairway::ros1
