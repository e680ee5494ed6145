// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include "ros/bridge/fleet_node.hpp"
#include "ros/ros1/middleware.hpp"

namespace fairway::ros1 {

/// `fairway_sim`: a scenario as a live fleet in a ROS graph. Topics, services and parameters are on
/// docs/ros.md.
class SimNode final : public bridge::FleetNode<Middleware> {
 public:
  /// Throws std::runtime_error, in one line, for a scenario that cannot be used.
  explicit SimNode(const bridge::FleetNodeSettings& settings);

  /// Until the run is done, if it is to end with it, or until ROS is shut down. The exit code of the program:
  /// as of FleetDuty::run().
  int run();

 private:
  void offer_services();
  void deliver_goals() override;
  void warn(const std::string& words) override;
};

}  // namespace fairway::ros1
