// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"

namespace fairway {

/// Direct: the preferred velocity, whoever is in the way. The baseline that every avoider must beat
/// on safety and cannot beat on distance. O(1), no memory.
struct Direct {
  static constexpr AlgorithmInfo info{
      .name = "direct",
      .title = "Straight to the goal, avoiding nobody",
      .source = "Baseline; no paper.",
      .ignores_obstacles = true,
      .ignores_movers = true,
  };

  using Params = NoParams;
  using Memory = NoMemory;

  Params params;

  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;
};

static_assert(AvoidanceAlgorithm<Direct>);

}  // namespace fairway
