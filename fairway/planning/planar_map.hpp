// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "fairway/core/shapes.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

inline Vec2 seen_from_above(const Vec3& p) { return p.head<2>(); }

/// Obstacles seen from above, each grown by the size of who has to pass: a planner's world, in which the
/// vehicle is a point. A sphere is a disc of its radius whatever its depth, a polygon is solid. Where
/// obstacles overlap they are a union.
///
/// A value that owns what it holds: a copy outlives the situation that it was made of. All lengths in metres,
/// all points north and east. Queries are O(obstacles), of a polygon O(vertices), and allocate nothing.
class PlanarMap {
 public:
  /// Throws InputError if `inflation_m` is negative or an obstacle is not finite or has no extent to speak
  /// of: a negative radius, fewer than three vertices.
  PlanarMap(std::span<const Obstacle> obstacles, double inflation_m);

  /// Distance of `p` from the nearest obstacle less the inflation: exact outside of obstacles, and inside
  /// negative, with the depth below the surface of the one that `p` is deepest in. Infinite in open water.
  double clearance(const Vec2& p) const noexcept;

  /// Distance of the straight line from `a` to `b` from the nearest obstacle, less the inflation; a line that
  /// meets an obstacle is at distance 0 from it. Exact.
  double clearance(const Vec2& a, const Vec2& b) const noexcept;

  /// True if a point may be there, or go straight from `a` to `b`: no clearance is missing, and nothing is
  /// touched where there is no inflation.
  bool is_free(const Vec2& p) const noexcept { return has_room(clearance(p)); }
  bool is_free(const Vec2& a, const Vec2& b) const noexcept { return has_room(clearance(a, b)); }

  /// Unit vector along which clearance at `p` grows fastest; north in open water and where all ways are
  /// alike.
  Vec2 outward(const Vec2& p) const noexcept;

  /// The smallest box, north and east, around the inflated obstacles; empty in open water.
  const Eigen::AlignedBox2d& bounds() const noexcept { return bounds_; }

  double inflation() const noexcept { return inflation_; }

  /// The same obstacles, inflated by `more_m` >= 0 more.
  PlanarMap grown(double more_m) const;

  friend bool operator==(const PlanarMap& a, const PlanarMap& b) {
    return a.inflation_ == b.inflation_ && a.solids_ == b.solids_;
  }

 private:
  /// An obstacle at depth 0 with vertices of its own.
  struct FlatObstacle {
    Obstacle::Kind kind{};
    Vec3 position = Vec3::Zero();
    double radius{};
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
    std::vector<Vec3> vertices;

    SurfacePoint nearest(const Vec2& p) const noexcept;
    double distance(const Vec2& a, const Vec2& b) const noexcept;
    Eigen::AlignedBox2d bounds() const;

    friend bool operator==(const FlatObstacle&, const FlatObstacle&) = default;
  };

  static FlatObstacle flattened(const Obstacle& obstacle);

  bool has_room(double clearance) const noexcept { return clearance >= 0.0 && clearance > -inflation_; }

  std::vector<FlatObstacle> solids_;
  double inflation_;
  Eigen::AlignedBox2d bounds_;
};

/// Length of the way along `points` [m].
double length_of(std::span<const Vec2> points) noexcept;

}  // namespace fairway
