// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/trackable/turn_law.hpp"

#include <algorithm>

namespace fairway::trackable {
namespace {

constexpr double loop_gain = 0.4;    // k T_r
constexpr double least_lag_s = 0.2;  // so that the gain stays finite

}  // namespace

TurnLaw::TurnLaw(const Envelope& envelope, double max_turn_rate) noexcept
    : envelope_{&envelope},
      max_turn_rate_{max_turn_rate},
      gain_{loop_gain / std::max(envelope.turn_lag, least_lag_s)} {}

}  // namespace fairway::trackable
