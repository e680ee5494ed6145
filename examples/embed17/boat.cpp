// SPDX-License-Identifier: Apache-2.0
// A boat that must turn in order to go elsewhere, between two buoys and a third. What it can do is given as
// numbers, as they come of trials of one's own or of `fairway describe zarco`, and "+trackable" asks of it
// only what it can follow.
#include <cmath>
#include <cstdio>
#include <exception>

#include "fairway/embed/avoider.hpp"

using namespace fairway::embed;

namespace {

Obstacle buoy(double north, double east) {
  Obstacle obstacle;
  obstacle.position = {north, east, 0};
  obstacle.radius = 0.5;
  return obstacle;
}

/// Sails for a minute, in which nothing throws or allocates.
void sail(Avoider& avoider, const Envelope& envelope) {
  const Obstacle buoys[] = {buoy(20, 0.3), buoy(20, -2.5), buoy(32, -1)};
  Situation situation;
  situation.period = 0.2;
  situation.own.radius = 0.75;
  situation.goal.position = {60, 0, 0};
  situation.goal.cruise_speed = 1.2;
  situation.limits.max_speed = 1.5;
  situation.limits.sway = false;
  situation.envelope = &envelope;
  situation.obstacles = buoys;
  situation.obstacle_count = std::size(buoys);

  double nearest = 1e9, speed = 0;
  for (int tick = 0; tick < 300; ++tick) {
    situation.time = tick * situation.period;
    const Command command = avoider.decide(situation);

    // your autopilot goes here; this one has the lags of the envelope
    Ownship& own = situation.own;
    const double ahead[] = {std::cos(own.yaw), std::sin(own.yaw)};
    const double surge = command.velocity[0] * ahead[0] + command.velocity[1] * ahead[1];
    speed += situation.period / envelope.surge_lag * (surge - speed);
    own.yaw_rate += situation.period / envelope.turn_lag * (command.turn_rate - own.yaw_rate);
    own.yaw += situation.period * own.yaw_rate;
    own.velocity = {speed * std::cos(own.yaw), speed * std::sin(own.yaw), 0};
    for (std::size_t axis = 0; axis < 2; ++axis) own.position[axis] += situation.period * own.velocity[axis];
    for (const Obstacle& other : buoys) {
      const double north = own.position[0] - other.position[0], east = own.position[1] - other.position[1];
      nearest = std::fmin(nearest, std::sqrt(north * north + east * east) - other.radius - own.radius);
    }
  }
  std::printf("passed the buoys at %.2f m, %.0f m north after a minute\n", nearest,
              situation.own.position[0]);
}

}  // namespace

int main() {
  try {
    const Envelope boat = envelope_of({"ahead_mps=1.6", "acceleration_mps2=0.3", "deceleration_mps2=0.2",
                                       "surge_lag_s=0.8", "turn_acceleration_radps2=0.4", "turn_lag_s=0.6",
                                       "turn_rates_radps=0.2, 0.3, 0.4, 0.4"});
    Avoider avoider{"orca2d+trackable", {"margin_m=0.3"}};
    sail(avoider, boat);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "boat17: %s\n", error.what());
    return 2;
  }
}
