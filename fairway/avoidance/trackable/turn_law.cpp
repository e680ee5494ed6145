// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/trackable/turn_law.hpp"

#include <algorithm>

namespace fairway::trackable {
namespace {

constexpr double loop_gain = 0.4;              // k T_r
constexpr double least_lag_s = 0.2;            // so that the gain stays finite
constexpr double share_of_turn_rate = 0.9;     // the rest is left to the autopilot
constexpr double below_rounding = 1.0 - 1e-9;  // of the table's straight lines
constexpr double shared_braking = 0.45;        // who loses more of the deceleration in a turn brakes first
constexpr double has_braked = 0.1;             // of the greatest speed: slower has
constexpr double creeps = 0.1;                 // [m/s]: faster it has not, whatever its greatest speed

static_assert(Law::rates == Envelope::turn_rate_count);

}  // namespace

TurnLaw::TurnLaw(const Envelope& envelope, double max_turn_rate) noexcept
    : envelope_{&envelope},
      law_{.gain = loop_gain / std::max(envelope.turn_lag, least_lag_s),
           .turn_share = share_of_turn_rate,
           .max_turn_rate = max_turn_rate,
           .least = envelope.least,
           .ahead = envelope.ahead} {
  std::ranges::copy(envelope.turn_rates, law_.turn_rates);
  const auto [slowest, quickest] = std::ranges::minmax(envelope.turn_rates);
  law_.sure_turn_rate = below_rounding * std::min(share_of_turn_rate * slowest, max_turn_rate);
  law_.top_turn_rate = std::min(share_of_turn_rate * quickest, max_turn_rate);
  if (envelope.deceleration_lost > shared_braking * envelope.deceleration)
    law_.brakes_first_above = std::max(std::min(has_braked * envelope.ahead, creeps), envelope.least);
}

}  // namespace fairway::trackable
