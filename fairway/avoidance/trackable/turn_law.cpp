// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/trackable/turn_law.hpp"

#include <algorithm>

namespace fairway::trackable {
namespace {

constexpr double loop_gain = 0.4;    // k T_r
constexpr double least_lag_s = 0.2;  // so that the gain stays finite
constexpr double turn_share = 0.9;   // of the greatest turn rate

}  // namespace

TurnLaw::TurnLaw(const Envelope& envelope, double max_turn_rate) noexcept
    : envelope_{&envelope},
      max_turn_rate_{max_turn_rate},
      gain_{loop_gain / std::max(envelope.turn_lag, least_lag_s)} {}

double TurnLaw::greatest_turn_rate(double speed) const noexcept {
  return std::min(turn_share * envelope_->turn_rate(speed), max_turn_rate_);
}

double TurnLaw::turn_rate(double error, double speed) const noexcept {
  const double most = greatest_turn_rate(speed);
  return std::clamp(gain_ * error, -most, most);
}

double TurnLaw::surge(double wanted, double along) const noexcept {
  const double share = std::max(0.0, along);
  return std::max(wanted * share * share, envelope_->least);
}

}  // namespace fairway::trackable
