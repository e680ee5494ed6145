// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/symmetry.hpp"

namespace fairway {

/// What ORCA in space and in the plane have in common: all that can be chosen of them.
struct OrcaParams {
  double time_horizon_s = 5.0;
  double obstacle_time_horizon_s = 5.0;
  double planning_interval_s = 0.0;
  double crit_dist_m = 20.0;
  int max_neighbours_count = 500;
  double responsibility_ratio = 0.5;
  Symmetry symmetry = Symmetry::none;

  /// dt of a situation [s].
  double interval(const Situation& s) const noexcept {
    return planning_interval_s > 0.0 ? planning_interval_s : s.period;
  }

  friend bool operator==(const OrcaParams&, const OrcaParams&) = default;

  static consteval auto fields() {
    return std::tuple{
        field<&OrcaParams::time_horizon_s>({0.01, 10000},
                                           "how long the velocities of two vehicles stay safe"),
        field<&OrcaParams::obstacle_time_horizon_s>({0.01, 10000}, "the same for what does not move"),
        field<&OrcaParams::planning_interval_s>(
            {0, 100}, "dt: who overlaps is to be apart after it; 0: the time between decisions"),
        field<&OrcaParams::crit_dist_m>({0.1, 10000},
                                        "range within which neighbours count, centre to centre; "
                                        "to the surface of an obstacle"),
        field<&OrcaParams::max_neighbours_count>({0, 500}, "how many of them, the nearest first"),
        field<&OrcaParams::responsibility_ratio>({0, 1},
                                                 "own share in avoiding a vehicle: 0.5 reciprocal, 1 all"),
        field<&OrcaParams::symmetry>(symmetry_meaning),
    };
  }
};

}  // namespace fairway
