// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "fairway/avoidance/velocity_obstacle/choice.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/core/segments.hpp"

namespace fairway::velocity_obstacle {

inline Vec2 any_direction(Rng& rng) {
  const double angle = rng.uniform(-pi, pi);
  return {std::cos(angle), std::sin(angle)};
}

/// A disc that moves, own ship being outside.
inline RelativeCapsule any_disc(Rng& rng) {
  RelativeCapsule solid;
  solid.radius = rng.uniform(0.5, 3.0);
  solid.from = solid.to = solid.radius * (1.0 + std::pow(10.0, rng.uniform(-3.0, 1.0))) * any_direction(rng);
  solid.velocity = rng.uniform(0.0, 1.2) * any_direction(rng);
  return solid;
}

/// A wall that stands, own ship being clear of it.
inline RelativeCapsule any_wall(Rng& rng) {
  RelativeCapsule solid;
  do {
    solid.radius = rng.uniform(0.0, 2.0);
    solid.from = rng.uniform(0.1, 15.0) * any_direction(rng);
    solid.to = solid.from + rng.uniform(0.0, 15.0) * any_direction(rng);
  } while (nearest_on_segment<Vec2>(solid.from, solid.to, Vec2::Zero()).norm() <= solid.radius * 1.001);
  return solid;
}

}  // namespace fairway::velocity_obstacle
