// SPDX-License-Identifier: Apache-2.0
// Messages of ROS 1 from the bridge's plain values and back. C++17.
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "ros/bridge/messages.hpp"

namespace fairway::ros1 {

using bridge::BodyVelocity;
using bridge::Frame;
using bridge::Mark;
using bridge::Motion;
using bridge::place_of;
using bridge::Triple;
using bridge::triple_in;

/// To the nearest nanosecond; zero for what a stamp cannot hold: NaN, what is before 0 or after 2106.
inline ros::Time stamp_of(double seconds) {
  struct Stamp {
    std::uint32_t seconds, nanoseconds;
  };
  const auto [whole, rest] = bridge::stamp_before<Stamp>(4294967295.0, seconds);
  return {whole, rest};
}

/// [s]
inline double seconds_of(const ros::Time& stamp) {
  return static_cast<double>(stamp.sec) + static_cast<double>(stamp.nsec) / 1e9;
}

inline std_msgs::Header header_of(double time, const std::string& frame_id) {
  std_msgs::Header header;
  header.stamp = stamp_of(time);
  header.frame_id = frame_id;
  return header;
}

/// Pose in `world`, twist in `child`'s body axes.
inline nav_msgs::Odometry odometry_of(const Motion& motion, Frame frame, const std::string& world,
                                      const std::string& child) {
  nav_msgs::Odometry odometry;
  odometry.header = header_of(motion.time, world);
  odometry.child_frame_id = child;
  put_motion(odometry, motion, frame);
  return odometry;
}

inline Motion motion_of(const nav_msgs::Odometry& odometry, Frame frame) {
  return bridge::motion_of(odometry, seconds_of(odometry.header.stamp), frame);
}

inline geometry_msgs::TransformStamped transform_of(const Motion& motion, Frame frame,
                                                    const std::string& world, const std::string& child) {
  geometry_msgs::TransformStamped transform;
  transform.header = header_of(motion.time, world);
  transform.child_frame_id = child;
  put_transform(transform.transform, motion, frame);
  return transform;
}

/// Stamped with the time of the navigation that it answers.
inline geometry_msgs::TwistStamped twist_of(const BodyVelocity& request, double time, Frame frame,
                                            const std::string& child) {
  geometry_msgs::TwistStamped twist;
  twist.header = header_of(time, child);
  put_velocity(twist.twist, request, frame);
  return twist;
}

inline BodyVelocity body_velocity_of(const geometry_msgs::TwistStamped& twist, Frame frame) {
  return bridge::velocity_of(twist.twist, frame);
}

/// A place to go to; its attitude says nothing.
inline geometry_msgs::PoseStamped goal_of(const Triple& position_n, double time, Frame frame,
                                          const std::string& world) {
  geometry_msgs::PoseStamped goal;
  goal.header = header_of(time, world);
  bridge::put(goal.pose.position, world_in(frame, position_n));
  goal.pose.orientation.w = 1.0;
  return goal;
}

/// What was drawn, after a marker that clears what was shown before. Name spaces are the meanings.
inline visualization_msgs::MarkerArray markers_of(const std::vector<Mark>& marks, double time, Frame frame,
                                                  const std::string& world) {
  visualization_msgs::MarkerArray array;
  array.markers.resize(marks.size() + 1);
  array.markers.front().header = header_of(time, world);
  array.markers.front().action = bridge::delete_all_markers;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    visualization_msgs::Marker& marker = array.markers[i + 1];
    marker.header = array.markers.front().header;
    marker.ns = bridge::name_space("", marks[i]);
    marker.text = marks[i].words;
    put_mark(marker, marks[i], static_cast<int>(i), frame);
    if (!has_points(marks[i])) continue;
    marker.points.resize(marks[i].points.size());
    for (std::size_t k = 0; k < marker.points.size(); ++k)
      bridge::put(marker.points[k], world_in(frame, marks[i].points[k]));
  }
  return array;
}

}  // namespace fairway::ros1
