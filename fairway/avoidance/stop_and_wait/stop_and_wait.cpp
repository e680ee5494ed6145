// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/stop_and_wait/stop_and_wait.hpp"

#include <algorithm>
#include <tuple>

namespace fairway {

bool StopAndWait::may_move(const Situation& s) const noexcept {
  const auto own_rank = std::tuple{s.own.priority, number(s.own.id)};
  const double range2 = params.crit_dist_m * params.crit_dist_m;
  return std::ranges::all_of(s.tracks, [&](const Track& track) {
    const bool is_near = (track.position - s.own.position).squaredNorm() <= range2;
    return !is_near || own_rank < std::tuple{track.priority, number(track.id)};
  });
}

Command StopAndWait::decide(const Situation& s, Avoider& inner, Memory&, Context& context) const noexcept {
  const Command command = inner.decide(s, context.sketch);
  if (context.sketch) context.sketch->sphere(s.own.position, params.crit_dist_m, "stop-and-wait range");
  return may_move(s) ? command : Command{.mode = Mode::hold};
}

}  // namespace fairway
