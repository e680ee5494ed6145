// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "fairway/core/vec.hpp"

namespace fairway::velocity_obstacle {

/// `a` turned to starboard by the angle of that cosine and sine.
inline Vec2 turned(const Vec2& a, double cosine, double sine) { return cosine * a + sine * starboard_of(a); }

/// What a set of velocities ends at: a whole line or a whole circle. [m/s]
struct Boundary {
  Vec2 point;      ///< on the line, or the circle's centre
  Vec2 direction;  ///< of the line, unit; zero for a circle
  double radius;   ///< of the circle

  static Boundary line(const Vec2& point, const Vec2& direction) { return {point, direction, 0.0}; }
  static Boundary circle(const Vec2& centre, double radius) { return {centre, Vec2::Zero(), radius}; }
  bool is_line() const { return direction != Vec2::Zero(); }
};

/// A part of a line, by how far its ends are from the line's point along its direction [m/s].
struct Stretch {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();

  bool is_empty() const { return !(from < to); }
  /// Cuts off where `offset` + `slope` t is not positive.
  void keep_positive(double offset, double slope) noexcept;
  /// Cuts off what is outside of a disc.
  void keep_disc(const Boundary& line, const Vec2& centre, double radius) noexcept;
};

/// None, one or two points where boundaries meet.
struct Crossings {
  std::array<Vec2, 2> points;
  std::size_t count = 0;

  void add(const Vec2& point) { points[count++] = point; }
  const Vec2* begin() const { return points.data(); }
  const Vec2* end() const { return points.data() + count; }
};

/// The velocity on the boundary that is nearest to `v`; any of a circle's if `v` is its centre. O(1).
Vec2 nearest(const Boundary& boundary, const Vec2& v) noexcept;

/// Where two boundaries meet; nowhere if they are parallel, concentric or the same. A touch that rounding
/// parts by less than 1e-12 of the lengths counts. O(1).
Crossings crossings(const Boundary& a, const Boundary& b) noexcept;

}  // namespace fairway::velocity_obstacle
