// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"

/// Situations of the horizontal plane, with walls and shores.
namespace fairway::flat_scenes {

/// Any horizontal direction.
inline Vec3 bearing(Rng& rng) {
  const double angle = rng.uniform(-pi, pi);
  return {std::cos(angle), std::sin(angle), 0.0};
}

/// A situation whose polygons are its own.
struct Waters {
  encounters::OwnedSituation encounter;
  std::vector<std::vector<Vec3>> outlines;  ///< of the first obstacles

  Waters() = default;
  Waters(const Waters&) = delete;  // the obstacles look at the outlines
  Waters& operator=(const Waters&) = delete;
  Waters(Waters&&) = default;
  Waters& operator=(Waters&&) = default;
};

/// `count` others placed between `nearest` and `farthest` [m] of own ship, who wants to go anywhere.
inline void add_tracks(encounters::OwnedSituation& e, int count, double nearest, double farthest, Rng rng) {
  for (int i = 0; i < count; ++i) {
    const Vec3 at = e.situation.own.position + rng.uniform(nearest, farthest) * bearing(rng);
    e.tracks.push_back(
        encounters::track(static_cast<std::uint32_t>(i + 1), at, rng.uniform(0.0, 1.0) * bearing(rng)));
  }
  e.sorted();
}

/// Room to pass for even `index`, none for odd.
inline encounters::OwnedSituation swarm(std::uint64_t index, int count) {
  Rng rng = Rng{5}.stream("swarm", index);
  encounters::OwnedSituation e = encounters::open_water();
  e.situation.own.velocity = rng.uniform(0.0, 1.0) * bearing(rng);
  e.situation.goal.position = e.situation.own.position + 40.0 * bearing(rng);
  add_tracks(e, count, index % 2 == 0 ? 2.5 : 1.0, index % 2 == 0 ? 15.0 : 4.0, rng.stream("tracks"));
  return e;
}

/// Two solid polygons, often with reflex corners, and two walls, 1 to 9 m away at random, and `count` others;
/// own ship's goal lies anywhere. All of it moved by `offset`.
inline Waters waters(std::uint64_t index, int count = 0, const Vec3& offset = Vec3::Zero()) {
  Rng rng = Rng{3}.stream("waters", index);
  Waters w;
  encounters::OwnedSituation& e = w.encounter;
  e = encounters::shifted(encounters::open_water(), offset);
  const Vec3 own = e.situation.own.position;
  e.situation.own.radius = rng.uniform(0.2, 1.2);
  e.situation.own.velocity = rng.uniform(0.0, 1.5) * bearing(rng);
  e.situation.goal.position = own + 40.0 * bearing(rng);
  for (int k = 0; k < 2; ++k) {
    const Vec3 middle = own + rng.uniform(3.0, 9.0) * bearing(rng);
    const double size = rng.uniform(0.5, 4.0);
    const std::uint64_t corners = 5 + rng.index(6);
    std::vector<Vec3>& outline = w.outlines.emplace_back();
    for (std::uint64_t c = 0; c < corners; ++c) {
      const double angle =
          2.0 * pi * (static_cast<double>(c) + rng.uniform(0.1, 0.9)) / static_cast<double>(corners);
      outline.push_back(middle + size * rng.uniform(0.3, 1.0) * Vec3{std::cos(angle), std::sin(angle), 0.0});
    }
  }
  for (const std::vector<Vec3>& outline : w.outlines)
    e.obstacles.push_back({.kind = Obstacle::Kind::polygon, .vertices = outline});
  for (int k = 0; k < 2; ++k) {
    const Vec3 from = own + rng.uniform(1.0, 9.0) * bearing(rng);
    e.obstacles.push_back(
        {.kind = Obstacle::Kind::segment, .from = from, .to = from + rng.uniform(0.5, 9.0) * bearing(rng)});
  }
  add_tracks(e, count, 1.0, 9.0, rng.stream("tracks"));
  return w;
}

}  // namespace fairway::flat_scenes
