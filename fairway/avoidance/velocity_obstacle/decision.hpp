// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/symmetry.hpp"

namespace fairway::velocity_obstacle {

/// What VO, RVO and HRVO have in common.
struct Params {
  double time_horizon_s = 5.0;
  double obstacle_time_horizon_s = 5.0;
  double planning_interval_s = 1.0;
  double crit_dist_m = 20.0;
  int max_neighbours_count = 50;
  double starboard_bias_ratio = 1e-3;
  double collision_weight_m = 10.0;
  Symmetry symmetry = Symmetry::none;

  static consteval auto fields() {
    return std::tuple{
        field<&Params::time_horizon_s>({0.01, 10000},
                                       "T_h: velocities that meet a vehicle within it are avoided"),
        field<&Params::obstacle_time_horizon_s>({0.01, 10000}, "the same for what does not move"),
        field<&Params::planning_interval_s>(
            {0.01, 100},
            "dt of the reachable velocities, where acceleration or turn rate is "
            "limited; who overlaps is to be apart after it"),
        field<&Params::crit_dist_m>({0.1, 10000},
                                    "range within which neighbours count, centre to centre; "
                                    "to the surface of an obstacle"),
        field<&Params::max_neighbours_count>({0, 50}, "how many of them, the nearest first"),
        field<&Params::starboard_bias_ratio>(
            {0, 1}, "a deviation to port of the preferred course counts as so much larger"),
        field<&Params::collision_weight_m>(
            {0, 10000}, "w of w / t_c, weighed against the deviation where no velocity is clear"),
        field<&Params::symmetry>(symmetry_meaning),
    };
  }
};

/// Who gives way to a vehicle that reacts.
enum class Responsibility {
  all,      ///< own ship alone: VO
  shared,   ///< each one half: RVO
  by_side,  ///< RVO on the side where the two pass each other, VO on the other: HRVO
};

/// Mode::cruise with the preferred velocity if nobody is in range; Mode::avoid with the nearest velocity to
/// it in RAV if somebody is; Mode::infeasible if RAV is empty. Thinks in the horizontal plane. Stern first is
/// allowed where turns are not limited; where they are, who has to stand is told to head for where it would
/// go if it could turn at once. Acceleration and turns are no limits to who is followed by its envelope,
/// unless it must turn, something stands near, and nobody leads past that.
Command decide(const Situation& s, const Params& params, Responsibility responsibility,
               const Context& context) noexcept;

}  // namespace fairway::velocity_obstacle
