// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/foresight_error.hpp"

#include <algorithm>

#include "fairway/avoidance/situation.hpp"
#include "fairway/avoidance/trackable/foresight.hpp"
#include "fairway/core/angles.hpp"

namespace fairway {
namespace {

using trackable::Foresight;
using trackable::Plan;
using trackable::TurnLaw;

constexpr double tried_hold = 0.8;    // of a foresight that is tried [s]
constexpr double tried_window = 8.0;  // likewise [s]

Foresight foresight_of(const Craft& craft, const TurnLaw& law) {
  Situation s;
  s.own.velocity = craft.vehicle.state().v_n();
  s.own.yaw = craft.yaw();
  s.own.yaw_rate = craft.turn_rate();
  return {law, s, unit_at(s.own.yaw), {.hold = tried_hold, .window = tried_window}};
}

/// The greatest of what `measure` makes of the way from where it is foreseen to where it gets [m].
template <class Measure>
double error_of(Craft craft, const TurnLaw& law, const Plan& plan, Measure measure) {
  const Vec2 from = craft.place();
  const Foresight at_first = foresight_of(craft, law);
  const Foresight::Path path = at_first.path(plan);
  double greatest = 0.0, time = 0.0;
  for (std::size_t k = 0; k < path.count; ++k) {
    while (time < static_cast<double>(k + 1) * at_first.step()) {
      const trackable::TurnOrder order = foresight_of(craft, law).order(plan);
      craft.obey({.surge_mps = order.surge, .yaw_rate_radps = order.turn_rate});
      time += craft.step;
    }
    greatest = std::max(greatest, measure(craft.place() - from - path.points[k]));
  }
  return greatest;
}

/// The greatest of what `error` makes of a vehicle at `speed` [m/s] that has gone straight on, and after
/// turns of various lengths, as tight as the law orders.
template <class Error>
double worst_after_turns(Craft steady, const TurnLaw& law, double speed, Error error) {
  steady.settle({.surge_mps = speed}, [](const Craft& craft) { return craft.surge(); });
  const BodyRequest turn{.surge_mps = speed, .yaw_rate_radps = law.greatest_turn_rate(speed)};
  double worst = 0.0;
  for (const double lags : {0.0, 0.5, 1.0, 2.0}) {
    Craft turned = steady;
    double time = 0.0;
    while (time < lags * law.envelope().turn_lag) {
      turned.obey(turn);
      time += turned.step;
    }
    worst = std::max(worst, error(turned));
  }
  return worst;
}

/// Told to stop, straight on or with the bow turned.
double error_of_stops(const Craft& craft, const TurnLaw& law) {
  const Vec2 ahead = unit_at(craft.yaw());
  const auto farther = [&](const Vec2& from_foreseen) { return ahead.dot(from_foreseen); };
  double worst = 0.0;
  for (const double bow : {0.0, 0.5 * pi, 0.95 * pi})
    worst = std::max(worst, error_of(craft, law, {.direction = unit_at(craft.yaw() + bow)}, farther));
  return worst;
}

/// Told another course at `speed` [m/s].
double error_of_turns(const Craft& craft, const TurnLaw& law, double speed) {
  const auto apart = [](const Vec2& from_foreseen) { return from_foreseen.norm(); };
  double worst = 0.0;
  for (const double change : {0.25 * pi, 0.5 * pi, -0.25 * pi, -0.5 * pi}) {
    const Plan plan{.direction = unit_at(craft.yaw() + change), .speed = speed};
    worst = std::max(worst, error_of(craft, law, plan, apart));
  }
  return worst;
}

}  // namespace

double foresight_error(const Craft& under_way, const Envelope& envelope, double max_turn_rate) {
  const TurnLaw law{envelope, max_turn_rate};
  const double fastest = envelope.ahead;
  if (envelope.least > 0.0)
    return worst_after_turns(under_way, law, fastest,
                             [&](const Craft& craft) { return error_of_turns(craft, law, fastest); });
  const auto stops = [&](const Craft& craft) { return error_of_stops(craft, law); };
  return std::max(worst_after_turns(under_way, law, 0.5 * fastest, stops),
                  worst_after_turns(under_way, law, fastest, stops));
}

}  // namespace fairway
