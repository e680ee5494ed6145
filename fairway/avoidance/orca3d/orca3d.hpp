// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/orca_params.hpp"
#include "fairway/avoidance/velocity_program/velocity_program.hpp"

namespace fairway {

/// ORCA in three dimensions: each neighbour forbids a half-space of velocities, such that two who both
/// keep to theirs do not collide within the time horizon; of what is left, the velocity nearest to the
/// preferred one (van den Berg, Guy, Lin, Manocha 2011; raja2024, section II-B, eqs. 5-10, but for the sign
/// that eq. 7 prints where v lies in the velocity obstacle: see README.md). The optimisation velocity is the
/// present one; neighbours and static obstacles are spheres.
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
      .needs_sway = true,
  };

  using Params = OrcaParams;
  using Memory = NoMemory;

  Params params;

  /// Mode::cruise if nobody is in range; Mode::avoid if somebody is; Mode::infeasible if no velocity
  /// keeps clear of all, with the velocity of least violation. In range, stern first is allowed.
  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;

  /// Whether both, side by side, decide as each alone: the same parameters, and nothing that is drawn.
  bool decides_with(const Orca3d& other) const noexcept;

  /// As `decide` of each, to the bit, in the lanes of the processor's registers where nobody meets an
  /// obstacle and all have the same period (lanes/kernel.hpp).
  void decide_many(std::span<const Situation* const> situations,
                   std::span<Command* const> commands) const noexcept;

  /// Those in range come first. What is symmetric is asked of all of them.
  std::size_t most_tracks() const noexcept {
    const bool asks_all = params.symmetry != Symmetry::none;
    return asks_all ? std::numeric_limits<std::size_t>::max()
                    : static_cast<std::size_t>(params.max_neighbours_count);
  }

  double farthest_obstacle() const noexcept { return params.crit_dist_m; }
};

static_assert(AvoidanceAlgorithm<Orca3d>);

}  // namespace fairway
