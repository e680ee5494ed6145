// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <vector>

#include "ros/bridge/fleet_host.hpp"

namespace fairway::bridge {

/// A fleet to look at: vehicles to scale, the spheres of raja2024 in the colours that `fairway view` gives
/// them, goals, the ways so far, names, and what stands in the water. Meanings: vehicles, detection, safety,
/// goals, trails, names, and those of the obstacles.
class FleetMarks {
 public:
  explicit FleetMarks(const FleetHost& fleet);

  /// Notes where everyone is: every step.
  void see(const FleetHost& fleet);
  /// As of the instant that is seen.
  std::vector<Mark> draw(const FleetHost& fleet) const;

 private:
  std::vector<std::vector<Triple>> hulls_;   // by vehicle: triangles in body axes [m]
  std::vector<std::vector<Triple>> trails_;  // by vehicle [m, NED]
};

}  // namespace fairway::bridge
