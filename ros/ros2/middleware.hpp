// SPDX-License-Identifier: Apache-2.0
// What ROS 2 has of its own, for the nodes and messages of ros/bridge.
#pragma once

#include <string>

#include "ros/bridge/messages.hpp"
#include "ros/ros2/graph.hpp"
#include "ros/ros2/memory.hpp"

namespace fairway::ros2 {

struct Middleware {
  using Clock = ros2::Clock;
  using DiagnosticArray = ros2::DiagnosticArray;
  using MarkerArray = ros2::MarkerArray;
  using Odometry = ros2::Odometry;
  using Path = ros2::Path;
  using PoseStamped = ros2::PoseStamped;
  using String = ros2::String;
  using TFMessage = ros2::TFMessage;
  using TransformStamped = ros2::TransformStamped;
  using TwistStamped = ros2::TwistStamped;
  using UInt8MultiArray = ros2::UInt8MultiArray;
  using Graph = ros2::Graph;
  template <class Message>
  using Publisher = ros2::Publisher<Message>;

  using Memory = ros2::Memory;
  template <class List>
  static auto elements(const List& list) {
    return ros2::elements(list);
  }

  static constexpr double end_of_time = 2147483647.0;  // [s]
  static Time stamp(std::int64_t nanoseconds) {
    return {static_cast<std::int32_t>(nanoseconds / 1000000000),
            static_cast<std::uint32_t>(nanoseconds % 1000000000)};
  }
  static std::int64_t nanoseconds(const Time& stamp) {
    return std::int64_t{stamp.sec} * 1000000000 + stamp.nanosec;
  }

  static std::string name_space(const std::string& space) { return space; }
};

using Writer = bridge::Writer<Middleware>;

}  // namespace fairway::ros2
