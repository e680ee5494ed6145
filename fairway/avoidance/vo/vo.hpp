// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/velocity_obstacle/decision.hpp"

namespace fairway {

/// The velocity obstacle: of what own ship can do within an interval, the velocity nearest to the preferred
/// one that meets nobody within the horizon, if all the others keep theirs (Fiorini, Shiller 1998; cao2022,
/// eqs. 2-6). See velocity_obstacle::decide.
///
///     paper            here
///     v_u, P_u         own.velocity, own.position
///     v_o, P_o, R_o    of a track
///     v_d (5)          preferred_velocity()
///     RV, RAV (3, 4)   velocity_obstacle::ReachableSet, choose()
///     delta t          planning_interval_s
struct Vo {
  static constexpr AlgorithmInfo info{
      .name = "vo",
      .title = "Velocity obstacles",
      .source = "Fiorini, Shiller 1998; cao2022, eqs. 2-6",
      .planar = true,
      .handed = true,
      .needs_sway = true,
  };

  using Params = velocity_obstacle::Params;
  using Memory = NoMemory;

  Params params;

  Command decide(const Situation& s, Memory&, Context& context) const noexcept {
    return velocity_obstacle::decide(s, params, velocity_obstacle::Responsibility::all, context);
  }
};

static_assert(AvoidanceAlgorithm<Vo>);

}  // namespace fairway
