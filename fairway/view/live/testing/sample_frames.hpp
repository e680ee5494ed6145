// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/record/frame.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway::testing {

/// A scenario of one vehicle, and frames of it at 10 Hz without a simulation.
struct SampleFrames {
  Scenario scenario = parse_scenario(R"(fairway: 1
name: sample
duration_s: 600
vehicles:
  - name: alone
    model: kinematic
    avoider: {algorithm: direct}
    start: {position_m: [0, 0, 5], yaw_deg: 0}
    mission: [{transit: {position_m: [30, 0, 5]}}]
)",
                                     "sample.yaml");
  std::array<VehicleFrame, 1> vehicles{};

  /// The frame of tick `k`. Valid while this lives.
  Frame at(int k) const {
    return {
        .tick = Tick{k}, .time = seconds(Tick{k}, 0.1), .period = 0.1, .vehicles = vehicles, .flights = {}};
  }
};

}  // namespace fairway::testing
