// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <vector>

#include "ros/bridge/fleet_host.hpp"
#include "ros/ros1/markers.hpp"

namespace fairway::ros1 {

/// A fleet for RViz: vehicles to scale, the spheres of raja2024 in the colours that `fairway view` gives
/// them, goals, the ways so far, and what stands in the water. Name spaces: vehicles, detection, safety,
/// goals, trails, names, and the obstacles' meanings.
class FleetMarkers {
 public:
  FleetMarkers(const bridge::FleetHost& fleet, Frame frame, const std::string& world);

  /// Notes where everyone is: every step.
  void see(const bridge::FleetHost& fleet);
  /// As of the instant that is seen.
  const visualization_msgs::MarkerArray& draw(const bridge::FleetHost& fleet);

 private:
  void draw(const bridge::FleetHost& fleet, std::size_t index);

  MarkerSet markers_;
  std::vector<std::vector<geometry_msgs::Point>> hulls_;  // by vehicle, in body axes of the graph
  std::vector<std::vector<Triple>> trails_;               // by vehicle [m, NED]
  double size_{};                                         // of words and goals [m]
};

}  // namespace fairway::ros1
