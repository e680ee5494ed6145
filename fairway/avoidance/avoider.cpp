// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoider.hpp"

#include <algorithm>

#include "fairway/avoidance/ability.hpp"

namespace fairway {
namespace {

/// `v` within speed and climb limits, and not through floor or ceiling before the next decision.
Vec3 within(const Situation& s, Vec3 v) noexcept {
  const Limits& limits = s.limits;
  v = clamp_norm(v, limits.max_speed);
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

Command Avoider::held(const Situation& s, Command command) noexcept {
  command.velocity = within(s, command.velocity);
  command.astern = command.astern && s.limits.sternway;

  const Shortfall beyond = shortfall(s.limits, command, s.own.yaw);
  if (command.note.empty() || tells_shortfall(command.note)) command.note = words_of(beyond);
  if (beyond != Shortfall::none && command.mode == Mode::avoid) command.mode = Mode::infeasible;
  return command;
}

}  // namespace fairway
