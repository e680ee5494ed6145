// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <deque>
#include <vector>

#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/core/shapes.hpp"

namespace fairway {

/// Obstacles of every kind, strewn over a square: small ones and some as long as it, some twice at one place,
/// some at whole metres so that several are equally far, some charted. Not to be copied: they point into it.
struct RandomObstacles {
  std::deque<std::vector<Vec3>> vertices;
  std::vector<Obstacle> all;

  RandomObstacles(std::size_t count, double size, Rng rng) {
    for (std::size_t i = 0; i < count; ++i) {
      all.push_back(i % 7 == 6 ? all.back() : one(size, rng));
      all.back().charted = rng.index(2) == 0;
    }
  }
  RandomObstacles(const RandomObstacles&) = delete;
  RandomObstacles& operator=(const RandomObstacles&) = delete;

  static Vec3 place(double size, Rng& rng) {
    const Vec3 p{rng.uniform(-0.5, 0.5) * size, rng.uniform(-0.5, 0.5) * size, rng.uniform(0.0, 0.1) * size};
    return rng.index(3) == 0 ? Vec3{p.array().round()} : p;
  }

 private:
  Obstacle one(double size, Rng& rng) {
    const double extent = rng.index(20) == 0 ? size : rng.uniform(0.0, 0.02) * size;
    const Vec3 at = place(size, rng);
    switch (rng.index(3)) {
      case 0:
        return {.kind = Obstacle::Kind::sphere, .position = at, .radius = 0.5 * extent};
      case 1:
        return {.kind = Obstacle::Kind::segment, .from = at, .to = at + extent * place(1.0, rng)};
      default:
        break;
    }
    std::vector<Vec3>& corners = vertices.emplace_back();
    for (int i = 0; i < 5; ++i) {
      const double angle = 2.0 * pi * i / 5.0;
      corners.push_back(at + extent * rng.uniform(0.1, 0.5) * Vec3{std::cos(angle), std::sin(angle), 0.0});
    }
    return {.kind = Obstacle::Kind::polygon, .vertices = corners};
  }
};

}  // namespace fairway
