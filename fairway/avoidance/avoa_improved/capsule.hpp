// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "fairway/avoidance/situation.hpp"

namespace fairway::avoa_improved {

/// All points within `radius` of a segment: a buoy (both ends at one place), a wall, an edge of a pier, a
/// vessel. It moves at a constant velocity. [m, m/s, NED, horizontal]
struct Capsule {
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
  double radius{};
  Vec2 velocity = Vec2::Zero();

  bool is_disc() const noexcept { return from == to; }
};

/// From a point to the middle line of the solid, where that is at time 0 [m]. O(1).
double distance_to_axis(const Capsule& solid, const Vec2& p) noexcept;

/// From the segment `p` to `q` to the middle line of the solid [m]. O(1).
double distance_to_axis(const Capsule& solid, const Vec2& p, const Vec2& q) noexcept;

/// Up to `capacity` solids, nearest first as long as they are added by `add_near`. A value without an
/// allocation.
class Capsules {
 public:
  static constexpr std::size_t capacity = 64;

  /// Keeps the nearest to `own`; of equals those added first. O(capacity).
  void add_near(const Capsule& solid, const Vec2& own) noexcept;

  std::span<const Capsule> view() const noexcept { return {all_.data(), count_}; }
  std::span<Capsule> view() noexcept { return {all_.data(), count_}; }

 private:
  std::array<Capsule, capacity> all_{};
  std::array<double, capacity> gaps_{};
  std::size_t count_ = 0;
};

/// Calls `take` with the solids that an obstacle consists of: one, or one for each edge of a polygon.
template <class Take>
void for_each_solid(const Obstacle& obstacle, Take take) noexcept {
  const auto flat = [](const Vec3& p) { return Vec2{p.head<2>()}; };
  switch (obstacle.kind) {
    case Obstacle::Kind::sphere:
      take(Capsule{flat(obstacle.position), flat(obstacle.position), obstacle.radius});
      return;
    case Obstacle::Kind::segment:
      take(Capsule{flat(obstacle.from), flat(obstacle.to), 0.0});
      return;
    case Obstacle::Kind::polygon:
      for (std::size_t i = 0; i < obstacle.vertices.size(); ++i) {
        const Vec3& next = obstacle.vertices[(i + 1) % obstacle.vertices.size()];
        take(Capsule{flat(obstacle.vertices[i]), flat(next), 0.0});
      }
  }
}

/// What moves, or might: the tracks nearest to own ship.
Capsules movers(const Situation& s) noexcept;

/// Depths between which a vehicle goes [m, NED].
struct DepthRange {
  double shallowest = -std::numeric_limits<double>::infinity();
  double deepest = std::numeric_limits<double>::infinity();

  /// Whether an obstacle comes within `distance` of it [m]. Segments and polygons count at all depths, as
  /// they do for `trackable`.
  bool is_met_by(const Obstacle& obstacle, double distance) const noexcept {
    if (obstacle.kind != Obstacle::Kind::sphere) return true;
    const double depth = obstacle.position.z(), reach = obstacle.radius + distance;
    return depth + reach >= shallowest && depth - reach <= deepest;
  }
};

/// What does not move, as far as it has been seen.
class Chart {
 public:
  /// Enters what is in sight and comes within `kept` of these depths. What was in sight before is kept if
  /// `remembers`, unless something in sight now lies within `same_place` of it and is taken to be it [m].
  /// O(seen x known).
  void enter(const Situation& s, bool remembers, double same_place, const DepthRange& depths = {},
             double kept = 0.0) noexcept;

  std::span<const Capsule> view() const noexcept { return known_.view(); }

 private:
  Capsules known_;
};

}  // namespace fairway::avoa_improved
