// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/orca_params.hpp"

namespace fairway {

/// ORCA in the horizontal plane: each neighbour forbids a half-plane of velocities, such that two who both
/// keep to theirs do not collide within the time horizon; walls, shores and discs forbid theirs whatever
/// the neighbours ask; of what is left, the velocity nearest to the preferred one (van den Berg, Guy,
/// Lin, Manocha 2011). The optimisation velocity is the present one. Depth is neither read nor written: a
/// segment or a polygon is a line, a sphere is a disc. O(vertices + tracks + walls in range squared) and a
/// plane program. No memory.
///
///     paper      here
///     tau        time_horizon_s, obstacle_time_horizon_s
///     p, v       relative position p_B - p_A and velocity v_A - v_B
///     r_A + r_B  R, own.radius + track.radius
///     v_opt      own.velocity
///     1/2        responsibility_ratio; 1 for tracks that do not react
///     dt         planning_interval_s, or situation.period: who overlaps already is apart by then
struct Orca2d {
  static constexpr AlgorithmInfo info{
      .name = "orca2d",
      .title = "Optimal reciprocal collision avoidance in the horizontal plane, with walls",
      .source = "van den Berg, Guy, Lin, Manocha 2011, sections 4 and 5",
      .planar = true,
      .needs_sway = true,
  };

  using Params = OrcaParams;
  using Memory = NoMemory;

  Params params;

  /// Mode::cruise if nothing in range asks for anything; Mode::avoid if something does; Mode::infeasible if
  /// no velocity keeps clear of all, with the velocity of least violation: of the neighbours, and of walls
  /// and discs first if these contradict each other. In range, stern first is allowed.
  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;
};

static_assert(AvoidanceAlgorithm<Orca2d>);

}  // namespace fairway
