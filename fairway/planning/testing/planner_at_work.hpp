// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/rng.hpp"

namespace fairway {

/// A planner with its memory, asked again and again.
template <class Algorithm>
struct PlannerAtWork {
  Algorithm algorithm{};
  typename Algorithm::Memory memory{};
  Rng rng{3};
  Context context{rng};

  PlannerAtWork() = default;
  PlannerAtWork(const PlannerAtWork&) = delete;  // the context is of this one's randomness
  PlannerAtWork& operator=(const PlannerAtWork&) = delete;

  Command decide_at(encounters::OwnedSituation& e, double time) {
    e.situation.time = time;
    return algorithm.decide(e, memory, context);
  }
  /// The plan that it has then.
  auto plan_at(encounters::OwnedSituation& e, double time) {
    (void)decide_at(e, time);
    return memory.plan;
  }
};

}  // namespace fairway
