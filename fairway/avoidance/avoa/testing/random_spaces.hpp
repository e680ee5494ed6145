// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoa/velocity_space.hpp"
#include "fairway/core/rng.hpp"

/// Velocity spaces as a Zarco may meet them, for tests.
namespace fairway::avoa {

inline constexpr KinematicZone zarco{.alpha = 1.0,
                                     .beta = 3.0,
                                     .turn_gain = 0.5,
                                     .max_turn_rate = 0.3751,
                                     .thruster_speed = 1.5,
                                     .max_speed = 1.5};

/// One to `most` discs between 1.5 and 14 m away, half of them under way, on the grid of 101 x 101.
inline void fill(VelocitySpace& space, int most, Rng rng) {
  space.begin({101, 1.5}, zarco, 0.2);
  const auto count = 1 + rng.index(static_cast<std::uint64_t>(most));
  for (std::uint64_t i = 0; i < count; ++i) {
    const PolarVelocity range{rng.uniform(1.5, 14.0), rng.uniform(-pi, pi)};
    const PolarVelocity course{i % 2 == 0 ? rng.uniform(0.0, 1.0) : 0.0, rng.uniform(-pi, pi)};
    space.zones().add(
        {.position = range.cartesian(), .radius = rng.uniform(0.8, 1.5), .velocity = course.cartesian()}, 8.0,
        TimeToContact::bound);
  }
  space.finish(0.3);
}

/// Ahead of the beam, at 0.5 to 1.5 m/s.
inline PolarVelocity any_desired(Rng rng) { return {rng.uniform(0.5, 1.5), rng.uniform(-pi / 2, pi / 2)}; }

}  // namespace fairway::avoa
