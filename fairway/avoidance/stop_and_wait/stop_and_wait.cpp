// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/stop_and_wait/stop_and_wait.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "fairway/avoidance/label.hpp"

namespace fairway {

const Track* StopAndWait::waits_for(const Situation& s) const noexcept {
  const auto own_rank = std::tuple{s.own.priority, number(s.own.id)};
  const double range2 = params.crit_dist_m * params.crit_dist_m;
  const auto found = std::ranges::find_if(s.tracks, [&](const Track& track) {
    const bool is_near = (track.position - s.own.position).squaredNorm() <= range2;
    return is_near && own_rank > std::tuple{track.priority, number(track.id)};
  });
  return found == s.tracks.end() ? nullptr : &*found;
}

Command StopAndWait::decide(const Situation& s, Avoider& inner, Memory&, Context& context) const noexcept {
  const Command command = inner.decide_usable(s, context.sketch);
  const Track* const first = waits_for(s);
  if (context.sketch) {
    context.sketch->sphere(s.own.position, params.crit_dist_m, "stop-and-wait range");
    if (first != nullptr)
      context.sketch->path(std::array{s.own.position, first->position}, Label{"waits for", first->id});
  }
  return first == nullptr ? command : Command{.mode = Mode::hold};
}

}  // namespace fairway
