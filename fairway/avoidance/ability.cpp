// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/ability.hpp"

#include <cmath>

namespace fairway {
namespace {

/// Less is rounding [m/s].
constexpr double slack = 1e-6;

}  // namespace

Shortfall shortfall(const Limits& limits, const Command& command, double yaw) noexcept {
  const Vec3& v = command.velocity;
  const double speed = command.mode == Mode::hold ? 0.0 : horizontal_norm(v);
  if (speed < limits.min_speed - slack) return Shortfall::too_slow;
  if (speed <= slack) return Shortfall::none;

  const bool says_heading = command.heading || command.turn_rate;
  const bool turns_first = !says_heading && !command.astern && !only_goes_ahead(limits);
  const bool needs_way_ahead = !limits.sternway && !turns_first;
  const bool needs_way_along = !limits.sway && says_heading;
  if (!needs_way_ahead && !needs_way_along) return Shortfall::none;

  const double bow = command.turn_rate ? yaw : command.heading.value_or(yaw);
  const double ahead = std::cos(bow) * v.x() + std::sin(bow) * v.y();
  const double across = std::cos(bow) * v.y() - std::sin(bow) * v.x();
  if (needs_way_ahead && ahead < -slack) return Shortfall::astern;
  if (needs_way_along && std::abs(across) > std::abs(ahead) + slack) return Shortfall::sideways;
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
