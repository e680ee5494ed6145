// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/obedience.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::pledge {
namespace {

constexpr double to_and_fro = 3.0;   // of waves [s]
constexpr double slow_share = 0.16;  // of the speed at which it is to go
constexpr double turn_share = 0.2;   // of its fastest turn

double ahead_of(const Situation& s, const Vec3& velocity) noexcept {
  return (velocity - s.current).head<2>().dot(unit_at(s.own.yaw));
}

/// Towards what is asked as quickly as it can [1/s2].
double followed(double from, double asked, double lag, double up, double down, double period) noexcept {
  const double change = (asked - from) * math::fmin(1.0, period / math::fmax(lag, period));
  return from + std::clamp(change, -period * down, period * up);
}

}  // namespace

void Obedience::look(const Situation& s) noexcept {
  if (s.envelope == nullptr) return;
  const Envelope& can = *s.envelope;
  const double surge = ahead_of(s, s.own.velocity), turn = s.own.yaw_rate;
  if (!has_begun_) {
    surge_ = {surge, surge, 0.0};
    turn_ = {turn, turn, 0.0};
    has_begun_ = true;
  }
  const double most = math::fmin(*std::ranges::min_element(can.turn_rates), s.limits.max_turn_rate);
  const double quickest = can.turn_acceleration;
  surge_.expected =
      followed(surge_.expected, std::clamp(surge_.asked, -can.astern, can.ahead), can.surge_lag,
               math::fmin(can.acceleration, s.limits.max_acceleration), can.deceleration, s.period);
  turn_.expected = followed(turn_.expected, std::clamp(turn_.asked, -most, most),
                            can.turn_lag + can.turn_tail, quickest, quickest, s.period);
  const double share = math::fmin(1.0, s.period / to_and_fro);
  surge_.lacks += share * (surge_.expected - surge - surge_.lacks);
  turn_.lacks += share * (turn_.expected - turn - turn_.lacks);
  is_lacking_ = surge_.lacks > slow_share * math::fmin(s.goal.cruise_speed, can.ahead) ||
                std::fabs(turn_.lacks) > turn_share * most;
}

void Obedience::ask(const Situation& s, const Command& command) noexcept {
  surge_.asked = ahead_of(s, command.velocity);
  turn_.asked = command.turn_rate.value_or(0.0);
}

}  // namespace fairway::pledge
