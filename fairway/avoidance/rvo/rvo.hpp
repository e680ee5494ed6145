// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/velocity_obstacle/decision.hpp"

namespace fairway {

/// The reciprocal velocity obstacle: as Vo, but whoever reacts does half of what is to be done, so the
/// obstacle's apex is the mean of the two velocities (van den Berg, Lin, Manocha 2008; cao2022, eq. 7).
/// Tracks that do not react are velocity obstacles as in Vo. Symbols as there.
struct Rvo {
  static constexpr AlgorithmInfo info{
      .name = "rvo",
      .title = "Reciprocal velocity obstacles",
      .source = "van den Berg, Lin, Manocha 2008; cao2022, eq. 7",
      .planar = true,
      .handed = true,
      .needs_sway = true,
  };

  using Params = velocity_obstacle::Params;
  using Memory = NoMemory;

  Params params;

  Command decide(const Situation& s, Memory&, Context& context) const noexcept {
    return velocity_obstacle::decide(s, params, velocity_obstacle::Responsibility::shared, context);
  }
};

static_assert(AvoidanceAlgorithm<Rvo>);

}  // namespace fairway
