// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/velocity_program/velocity_program.hpp"

namespace fairway {

/// ORCA in three dimensions: each neighbour forbids a half-space of velocities, such that two who both
/// keep to theirs do not collide within the time horizon; of what is left, the velocity nearest to the
/// preferred one (van den Berg, Guy, Lin, Manocha 2011; raja2024, section II-B, eqs. 5-10). The
/// optimisation velocity is the present one; neighbours and static obstacles are spheres.
/// O(neighbours + obstacle vertices) and a velocity program. No memory.
///
///     paper      here
///     tau        time_horizon_s
///     p, v       relative position p_B - p_A and velocity v_A - v_B
///     r_A + r_B  R, own.radius + track.radius
///     v_opt      own.velocity
///     1/2        responsibility_ratio; 1 for tracks that do not react
struct Orca3d {
  static constexpr AlgorithmInfo info{
      .name = "orca3d",
      .title = "Optimal reciprocal collision avoidance in three dimensions",
      .source = "van den Berg, Guy, Lin, Manocha 2011, sections 4 and 5; raja2024, eqs. 5-10",
  };

  struct Params {
    double time_horizon_s = 5.0;
    double obstacle_time_horizon_s = 5.0;
    double crit_dist_m = 20.0;
    int max_neighbours_count = 500;
    double responsibility_ratio = 0.5;

    static consteval auto fields() {
      return std::tuple{
          field<&Params::time_horizon_s>({0.01, 10000}, "how long the velocities of two vehicles stay safe"),
          field<&Params::obstacle_time_horizon_s>({0.01, 10000}, "the same for what does not move"),
          field<&Params::crit_dist_m>({0.1, 10000},
                                      "range within which neighbours count, centre to centre; "
                                      "to the surface of an obstacle"),
          field<&Params::max_neighbours_count>({0, 500}, "how many of them, the nearest first"),
          field<&Params::responsibility_ratio>({0, 1},
                                               "own share in avoiding a vehicle: 0.5 reciprocal, 1 all"),
      };
    }
  };

  using Memory = NoMemory;

  Params params;

  /// Mode::cruise if nobody is in range; Mode::avoid if somebody is; Mode::infeasible if no velocity
  /// keeps clear of all, with the velocity of least violation. In range, stern first is allowed.
  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;
};

static_assert(AvoidanceAlgorithm<Orca3d>);

}  // namespace fairway
