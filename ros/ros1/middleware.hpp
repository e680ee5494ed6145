// SPDX-License-Identifier: Apache-2.0
// What ROS 1 has of its own, for the nodes and messages of ros/bridge. C++17.
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ros/time.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/String.h>
#include <std_msgs/UInt8MultiArray.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "ros/ros1/graph.hpp"

namespace fairway::ros1 {

struct Middleware {
  using Clock = rosgraph_msgs::Clock;
  using DiagnosticArray = diagnostic_msgs::DiagnosticArray;
  using MarkerArray = visualization_msgs::MarkerArray;
  using Odometry = nav_msgs::Odometry;
  using Path = nav_msgs::Path;
  using PoseStamped = geometry_msgs::PoseStamped;
  using String = std_msgs::String;
  using TFMessage = tf2_msgs::TFMessage;
  using TransformStamped = geometry_msgs::TransformStamped;
  using TwistStamped = geometry_msgs::TwistStamped;
  using UInt8MultiArray = std_msgs::UInt8MultiArray;
  using Graph = ros1::Graph;
  template <class Message>
  using Publisher = ros1::Publisher<Message>;

  /// Messages own their texts and lists.
  struct Memory {
    static const std::string& text(const std::string& words) { return words; }
    template <class List>
    static List& room(List& list, std::size_t count) {
      list.resize(count);
      return list;
    }
  };
  template <class List>
  static const List& elements(const List& list) {
    return list;
  }

  static constexpr double end_of_time = 4294967295.0;  // [s]
  static ros::Time stamp(std::int64_t nanoseconds) {
    return ros::Time{}.fromNSec(static_cast<std::uint64_t>(nanoseconds));
  }
  static std::int64_t nanoseconds(const ros::Time& stamp) {
    return static_cast<std::int64_t>(stamp.toNSec());
  }

  /// A marker's name space is its meaning alone.
  static std::string name_space(const std::string&) { return {}; }
};

using Writer = bridge::Writer<Middleware>;

}  // namespace fairway::ros1
