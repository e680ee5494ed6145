// SPDX-License-Identifier: Apache-2.0
// The same meeting as in ../embed, by a program in C++17: two vehicles head on, and ours decides ten times a
// second. The method and its settings are words, as they would come of a file.
#include <cmath>
#include <cstdio>
#include <exception>

#include "fairway/embed/avoider.hpp"

using namespace fairway::embed;

namespace {

double distance(const Triple& a, const Triple& b) {
  const double north = a[0] - b[0], east = a[1] - b[1], down = a[2] - b[2];
  return std::sqrt(north * north + east * east + down * down);
}

/// Runs the meeting, in which nothing throws or allocates.
void meet(Avoider& avoider) {
  Track other;
  other.id = 1;
  other.velocity = {-0.5, 0, 0};

  Situation situation;
  situation.period = 0.1;
  situation.own.position = {0, 0, 5};  // north, east, down
  situation.own.velocity = {0.5, 0, 0};
  situation.goal.position = {50, 0, 5};
  situation.goal.cruise_speed = 0.5;
  situation.limits.max_speed = 0.5;
  situation.tracks = &other;
  situation.track_count = 1;

  double nearest = 1e9;
  for (int tick = 0; tick < 1000; ++tick) {
    situation.time = tick * situation.period;
    other.position = {50 - 0.5 * situation.time, 0.5, 5};
    const Command command = avoider.decide(situation);

    Ownship& own = situation.own;
    own.velocity = command.velocity;  // your vehicle goes here; this one follows at once
    for (std::size_t axis = 0; axis < 3; ++axis) {
      own.position[axis] += situation.period * own.velocity[axis];
    }
    nearest = std::fmin(nearest, distance(own.position, other.position));
  }
  std::printf("passed at %.2f m between centres, %.2f m from the goal\n", nearest,
              distance(situation.goal.position, situation.own.position));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    Avoider avoider{argc > 1 ? argv[1] : "orca3d", {argc > 2 ? argv[2] : "time_horizon_s=10"}, {}, 1};
    meet(avoider);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "embed17: %s\n", error.what());
    return 2;
  }
}
