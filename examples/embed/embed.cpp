// SPDX-License-Identifier: Apache-2.0
// The avoidance library by itself: two vehicles meet head on, and ours decides ten times a second.
#include <cmath>
#include <cstdio>

#include "fairway/avoidance/orca3d/orca3d.hpp"

using namespace fairway;

int main() {
  double nearest = 1e9;

  // [readme]
  Avoider avoider{Orca3d{{.time_horizon_s = 10}}, Rng{1}};
  Ownship own{.id = VehicleId{0}, .position = {0, 0, 5}, .velocity = {0.5, 0, 0}};  // north, east, down
  const Goal goal{.position = {50, 0, 5}, .cruise_speed = 0.5};
  for (int tick = 0; tick < 1000; ++tick) {
    const double period = 0.1, time = tick * period;
    const Track other{.id = TrackId{1}, .position = {50 - 0.5 * time, 0.5, 5}, .velocity = {-0.5, 0, 0}};
    const Command command = avoider.decide({.time = time,
                                            .period = period,
                                            .own = own,
                                            .goal = goal,
                                            .limits = {.max_speed = 0.5},
                                            .tracks = {&other, 1}});
    own.velocity = command.velocity;  // your vehicle goes here; this one follows at once
    own.position += period * own.velocity;
    nearest = std::fmin(nearest, (own.position - other.position).norm());
  }
  // [readme end]

  std::printf("passed at %.2f m between centres, %.2f m from the goal\n", nearest,
              (goal.position - own.position).norm());
}
