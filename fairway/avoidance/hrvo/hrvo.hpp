// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/velocity_obstacle/decision.hpp"

namespace fairway {

/// The hybrid reciprocal velocity obstacle: as Rvo on the side where the two pass each other, and as Vo on
/// the other, so that they do not dance from side to side (Snape, van den Berg, Guy, Manocha 2011, section
/// IV). Tracks that do not react are velocity obstacles as in Vo. Symbols as there.
struct Hrvo {
  static constexpr AlgorithmInfo info{
      .name = "hrvo",
      .title = "Hybrid reciprocal velocity obstacles",
      .source = "Snape, van den Berg, Guy, Manocha 2011, sections IV and V",
      .planar = true,
      .handed = true,
      .needs_sway = true,
  };

  using Params = velocity_obstacle::Params;
  using Memory = NoMemory;

  Params params;

  Command decide(const Situation& s, Memory&, Context& context) const noexcept {
    return velocity_obstacle::decide(s, params, velocity_obstacle::Responsibility::by_side, context);
  }
};

static_assert(AvoidanceAlgorithm<Hrvo>);

}  // namespace fairway
