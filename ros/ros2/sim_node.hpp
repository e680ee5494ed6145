// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "ros/bridge/fleet_node.hpp"
#include "ros/ros2/middleware.hpp"

namespace fairway::ros2 {

/// `fairway_sim_ros2`: a scenario as a live fleet in a ROS 2 graph. Topics and settings are on docs/ros2.md.
class SimNode final : public bridge::FleetNode<Middleware> {
 public:
  /// Throws std::runtime_error, in one line, for a scenario that cannot be used.
  SimNode(const bridge::FleetNodeSettings& settings, const GraphOptions& options);

 private:
  void deliver_goals() override;
  void warn(const std::string& words) override;
};

}  // namespace fairway::ros2
