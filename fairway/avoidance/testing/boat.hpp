// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

/// Vehicles that must turn in order to go elsewhere, for tests of what follows for methods.
namespace fairway::encounters {

/// Of a boat that makes 2 m/s, turns by 0.5 rad/s and slips in turns.
inline Envelope of_a_boat() {
  return {.ahead = 2.0,
          .astern = 1.0,
          .acceleration = 0.5,
          .deceleration = 0.5,
          .surge_lag = 0.5,
          .turn_acceleration = 0.5,
          .turn_lag = 0.5,
          .pivot = 0.3,
          .sway_lag = 1.0,
          .turn_rates = {0.5, 0.5, 0.5, 0.5},
          .following_errors = {0.3, 1.0, 2.0, 3.0, 4.0, 5.0}};
}

/// The same with a least speed.
inline Envelope of_a_torpedo() {
  Envelope envelope = of_a_boat();
  envelope.least = 1.0;
  envelope.astern = 0.0;
  return envelope;
}

inline Obstacle buoy(double north, double east, double radius = 0.5) {
  return {.kind = Obstacle::Kind::sphere, .position = {north, east, 50.0}, .radius = radius};
}

/// Under way northwards at 1 m/s, at a depth of 50 m.
inline OwnedSituation under_way(const Envelope& envelope) {
  OwnedSituation e = open_water();
  e.situation.own.velocity = {1.0, 0.0, 0.0};
  e.situation.own.yaw = 0.0;
  e.situation.envelope = &envelope;
  e.situation.limits.min_speed = envelope.least;
  e.situation.limits.sternway = envelope.astern > 0.0;
  e.situation.limits.sway = false;
  return e;
}

/// Sails under `avoider` as the envelope says, exactly and without slip, for `duration` [s].
struct Sailed {
  double clearance = 1e9;
  int infeasible = 0;
  Vec2 end = Vec2::Zero();
};
inline Sailed sail(OwnedSituation e, Avoider avoider, double duration) {
  Sailed sailed;
  const Envelope& can = *e.situation.envelope;
  const double h = e.situation.period;
  double yaw = e.situation.own.yaw, rate = 0.0, speed = e.situation.own.velocity.norm();
  for (double time = 0.0; time < duration; time += h) {
    const Command command = avoider.decide(e);
    sailed.infeasible += command.mode == Mode::infeasible ? 1 : 0;
    const double surge = std::cos(yaw) * command.velocity.x() + std::sin(yaw) * command.velocity.y();
    rate += std::clamp((command.turn_rate.value_or(0.0) - rate) * h / can.turn_lag,
                       -h * can.turn_acceleration, h * can.turn_acceleration);
    speed += std::clamp((surge - speed) * h / can.surge_lag, -h * can.deceleration, h * can.acceleration);
    yaw += h * rate;
    Ownship& own = e.situation.own;
    own.velocity = {speed * std::cos(yaw), speed * std::sin(yaw), 0.0};
    own.position += h * own.velocity;
    own.yaw = yaw;
    own.yaw_rate = rate;
    for (Track& t : e.tracks) t.position += h * t.velocity;
    for (const Obstacle& o : e.obstacles)
      sailed.clearance = std::min(sailed.clearance, nearest_point(o, own.position).distance - own.radius);
    for (const Track& t : e.tracks)
      sailed.clearance =
          std::min(sailed.clearance, (t.position - own.position).norm() - t.radius - own.radius);
  }
  sailed.end = e.situation.own.position.head<2>();
  return sailed;
}

}  // namespace fairway::encounters
