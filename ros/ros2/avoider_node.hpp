// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "ros/bridge/avoider_node.hpp"
#include "ros/ros2/middleware.hpp"

namespace fairway::ros2 {

/// `fairway_avoider_ros2`: the avoider of one vehicle in a ROS 2 graph. Topics and settings are on
/// docs/ros2.md.
class AvoiderNode final : public bridge::AvoiderNode<Middleware> {
 public:
  /// In the vehicle's namespace. Throws std::runtime_error, in one line, for settings that cannot be used.
  AvoiderNode(const bridge::AvoiderNodeSettings& settings, const GraphOptions& options);

 private:
  std::optional<double> now() const override;
  void warn(const std::string& words) override;

  bool simulated_;
  std::atomic<double> simulated_now_;  // of /clock [s]; NaN before the first
};

}  // namespace fairway::ros2
