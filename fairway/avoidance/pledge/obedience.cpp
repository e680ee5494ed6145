// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/obedience.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::pledge {
namespace {

constexpr double to_and_fro = 3.0;                                   // of waves [s]
constexpr double slow_share = 0.16;                                  // of the speed at which it is to go
constexpr double turn_share = 0.2;                                   // of its fastest turn
constexpr double heave_lag = 3.0;                                    // of a hull that climbs or dives [s]
constexpr double at_once = std::numeric_limits<double>::infinity();  // as a change [1/s]

double ahead_of(const Situation& s, const Vec3& velocity) noexcept {
  return (velocity - s.current).head<2>().dot(unit_at(s.own.yaw));
}

double down_of(const Situation& s, const Vec3& velocity) noexcept { return (velocity - s.current).z(); }

}  // namespace

void Obedience::Axis::see(double does, double least, double greatest, double lag, double up, double down,
                          double period) noexcept {
  const double change =
      (std::clamp(asked, least, greatest) - expected) * math::fmin(1.0, period / math::fmax(lag, period));
  expected += std::clamp(change, -period * down, period * up);
  lacks += math::fmin(1.0, period / to_and_fro) * (expected - does - lacks);
}

void Obedience::look(const Situation& s) noexcept {
  if (s.envelope == nullptr) return;
  const Envelope& can = *s.envelope;
  const double surge = ahead_of(s, s.own.velocity), heave = down_of(s, s.own.velocity), turn = s.own.yaw_rate;
  if (!has_begun_) {
    surge_ = {surge, surge, 0.0};
    heave_ = {heave, heave, 0.0};
    turn_ = {turn, turn, 0.0};
    has_begun_ = true;
  }
  surge_.see(surge, -can.astern, can.ahead, can.surge_lag,
             math::fmin(can.acceleration, s.limits.max_acceleration), can.deceleration, s.period);
  const bool floats = can.up <= 0.0 && can.down <= 0.0;
  if (!floats) heave_.see(heave, -can.up, can.down, heave_lag, at_once, at_once, s.period);
  // at whatever speed
  const double most = math::fmin(*std::ranges::min_element(can.turn_rates), s.limits.max_turn_rate);
  turn_.see(turn, -most, most, can.turn_lag + can.turn_tail, can.turn_acceleration, can.turn_acceleration,
            s.period);
  const double slow = slow_share * math::fmin(s.goal.cruise_speed, can.ahead);
  is_lacking_ =
      surge_.lacks > slow || std::fabs(heave_.lacks) > slow || std::fabs(turn_.lacks) > turn_share * most;
}

void Obedience::ask(const Situation& s, const Command& command) noexcept {
  surge_.asked = ahead_of(s, command.velocity);
  heave_.asked = down_of(s, command.velocity);
  turn_.asked = command.turn_rate.value_or(0.0);
}

}  // namespace fairway::pledge
