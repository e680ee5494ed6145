// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <vector>

#include "ros/bridge/fleet_host.hpp"

namespace fairway::bridge {

/// A fleet to look at: the hulls, the spheres of raja2024 in the colours that `fairway view` gives them,
/// goals, the ways so far, and what stands in the water.
class FleetMarks {
 public:
  explicit FleetMarks(const FleetHost& fleet) : trails_(fleet.size()) {}

  /// Notes where everyone is: every step.
  void see(const FleetHost& fleet);
  /// As of the instant that is seen.
  std::vector<Mark> draw(const FleetHost& fleet) const;

 private:
  std::vector<std::vector<Triple>> trails_;  // by vehicle [m, NED]
};

}  // namespace fairway::bridge
