// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include "ros/bridge/avoider_node.hpp"
#include "ros/ros1/middleware.hpp"

namespace fairway::ros1 {

/// `fairway_avoider`: the avoider of one vehicle in a ROS graph. Topics, services and parameters are on
/// docs/ros_avoider.md.
class AvoiderNode final : public bridge::AvoiderNode<Middleware> {
 public:
  /// In the program's namespace, which is the vehicle's. Throws std::runtime_error, in one line, for settings
  /// that cannot be used.
  explicit AvoiderNode(const bridge::AvoiderNodeSettings& settings);

  /// Until ROS is shut down.
  void run();

 private:
  void offer_services();
  std::optional<double> now() const override;
  void warn(const std::string& words) override;
};

}  // namespace fairway::ros1
