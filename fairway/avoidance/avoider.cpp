// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoider.hpp"

#include <algorithm>

#include "fairway/avoidance/ability.hpp"

namespace fairway {
namespace {

/// Stands in for a speed limit that is not set [m/s], as in `orca3d`: nothing that these methods are for goes
/// so fast, and what a program without that limit comes to does.
constexpr double fastest_of_all = 1000.0;

/// `v` within speed and climb limits, and not through floor or ceiling before the next decision.
Vec3 within(const Situation& s, Vec3 v) noexcept {
  const Limits& limits = s.limits;
  v = clamp_norm(v, limit_or(limits.max_speed, fastest_of_all));
  v.z() = std::max(-limits.max_climb_rate, std::min(limits.max_climb_rate, v.z()));

  // outside the depth band the way back stays open
  const double depth = s.own.position.z();
  const double slowest = std::min(0.0, (limits.min_depth - depth) / s.period);
  const double fastest = std::max(0.0, (limits.max_depth - depth) / s.period);
  v.z() = std::max(slowest, std::min(fastest, v.z()));
  return v;
}

/// Whether the note is what was said of the command before a wrapper changed it.
bool tells_shortfall(std::string_view note) noexcept {
  constexpr std::array all{Shortfall::too_slow, Shortfall::astern, Shortfall::sideways};
  return std::ranges::any_of(all, [&](Shortfall shortfall) { return note == words_of(shortfall); });
}

}  // namespace

void Avoider::decide_many(std::span<Avoider* const> avoiders, std::span<const Situation> situations,
                          std::span<Command> commands) noexcept {
  std::array<const Situation*, most_together> asked;
  std::array<Command*, most_together> answers;
  for (std::size_t next = 0; next < avoiders.size();) {
    const std::size_t first = next;
    Interface& algorithm = *avoiders[first]->self_;
    std::size_t count = 0;
    for (; next < avoiders.size() && count < most_together; ++next) {
      if (!algorithm.decides_with(*avoiders[next]->self_)) break;
      const std::string_view trouble = why_unusable(situations[next]);
      if (!trouble.empty()) {
        commands[next] = {.mode = Mode::infeasible, .note = trouble};
        continue;
      }
      asked[count] = &situations[next];
      answers[count++] = &commands[next];
    }
    if (next == first) {
      commands[first] = avoiders[first]->decide(situations[first]);
      ++next;
      continue;
    }
    algorithm.decide_many(std::span{asked}.first(count), std::span{answers}.first(count));
    for (std::size_t i = 0; i < count; ++i) hold(*asked[i], *answers[i]);
  }
}

void Avoider::hold(const Situation& s, Command& command) noexcept {
  if (!is_finite(command)) {
    command = {.mode = Mode::infeasible, .note = "the method's answer is not finite"};
    return;
  }
  command.velocity = within(s, command.velocity);
  command.astern = command.astern && s.limits.sternway;

  const Shortfall beyond = shortfall(s.limits, command, s.own.yaw);
  if (command.note.empty() || tells_shortfall(command.note)) command.note = words_of(beyond);
  if (beyond != Shortfall::none && command.mode == Mode::avoid) command.mode = Mode::infeasible;
}

}  // namespace fairway
