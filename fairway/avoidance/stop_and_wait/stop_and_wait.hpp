// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"

namespace fairway {

/// Stop-and-wait around another avoider: whoever has the highest priority among those close to each
/// other moves as the inner avoider says, everybody else holds position until it has gone
/// (raja2024, section III-D). O(tracks) besides the inner avoider.
struct StopAndWait {
  static constexpr AlgorithmInfo info{
      .name = "stop_and_wait",
      .title = "Stop and wait for vehicles of higher priority",
      .source = "raja2024, section III-D",
      .ignores_obstacles = true,
      .needs_stopping = true,
  };

  struct Params {
    double crit_dist_m = 6.0;

    static consteval auto fields() {
      return std::tuple{
          field<&Params::crit_dist_m>({0.1, 10000},
                                      "wait while a vehicle of higher priority is this close, "
                                      "centre to centre"),
      };
    }
  };

  using Memory = NoMemory;

  Params params;

  /// The inner avoider is asked on every call, waiting or not, so that its memory never falls behind.
  Command decide(const Situation& s, Avoider& inner, Memory& memory, Context& context) const noexcept;

  double farthest_obstacle(const Avoider& inner) const noexcept { return inner.farthest_obstacle(); }

  /// Whoever is nearest of those within `crit_dist_m` that have the right of way: a smaller priority number,
  /// or the same number and a smaller id. Null if nobody has.
  const Track* waits_for(const Situation& s) const noexcept;
};

static_assert(AvoidanceWrapper<StopAndWait>);

}  // namespace fairway
