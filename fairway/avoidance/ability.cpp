// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/ability.hpp"

#include <cmath>

#include "fairway/core/math.hpp"

namespace fairway {
namespace {

/// Less is rounding [m/s].
constexpr double slack = 1e-6;

struct Needs {
  bool way_ahead;
  bool way_along;
};

Needs needs_of(const Limits& limits, const Command& command) noexcept {
  const bool says_heading = command.heading || command.turn_rate;
  const bool turns_first = !says_heading && !command.astern && !only_goes_ahead(limits);
  return {.way_ahead = !limits.sternway && !turns_first, .way_along = !limits.sway && says_heading};
}

}  // namespace

std::optional<Shortfall> shortfall_on_any_heading(const Limits& limits, const Command& command) noexcept {
  const double speed = command.mode == Mode::hold ? 0.0 : horizontal_norm(command.velocity);
  if (speed < limits.min_speed - slack) return Shortfall::too_slow;
  if (speed <= slack) return Shortfall::none;
  const Needs needs = needs_of(limits, command);
  if (needs.way_ahead || needs.way_along) return {};
  return Shortfall::none;
}

Shortfall shortfall(const Limits& limits, const Command& command, double yaw) noexcept {
  if (const auto on_any = shortfall_on_any_heading(limits, command)) return *on_any;
  const Vec3& v = command.velocity;
  const Needs needs = needs_of(limits, command);
  const double bow = command.turn_rate ? yaw : command.heading.value_or(yaw);
  const auto [sine, cosine] = math::sin_cos(bow);
  const double ahead = cosine * v.x() + sine * v.y();
  const double across = cosine * v.y() - sine * v.x();
  if (needs.way_ahead && ahead < -slack) return Shortfall::astern;
  if (needs.way_along && std::abs(across) > std::abs(ahead) + slack) return Shortfall::sideways;
  return Shortfall::none;
}

std::string_view words_of(Shortfall shortfall) noexcept {
  switch (shortfall) {
    case Shortfall::none:
      return {};
    case Shortfall::too_slow:
      return "commanded slower than the vehicle can go; where it is to stop, it circles";
    case Shortfall::astern:
      return "commanded astern, which the vehicle cannot go: it has to turn round first";
    case Shortfall::sideways:
      return "commanded across its heading, which the vehicle cannot go";
  }
  return {};
}

}  // namespace fairway
