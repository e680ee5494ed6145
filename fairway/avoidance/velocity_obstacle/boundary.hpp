// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
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

inline void Stretch::keep_positive(double offset, double slope) noexcept {
  const double end = -offset / slope;
  if (slope > 0.0) {
    from = std::max(from, end);
  } else if (slope < 0.0) {
    to = std::min(to, end);
  } else if (!(offset > 0.0)) {
    to = from;
  }
}

inline void Stretch::keep_disc(const Boundary& line, const Vec2& centre, double radius) noexcept {
  const Vec2 out = centre - line.point;
  const double along = out.dot(line.direction);
  const double across = cross(line.direction, out);
  const double half2 = radius * radius - across * across;
  const double half = radius > 0.0 && half2 > 0.0 ? std::sqrt(half2) : 0.0;
  from = std::max(from, along - half);
  to = std::min(to, along + half);
}

/// The point of the segment from `a` to `b` that is nearest to `v`.
inline Vec2 nearest_on_segment(const Vec2& a, const Vec2& b, const Vec2& v) noexcept {
  const Vec2 ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((v - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return a + t * ab;
}

/// The velocity on the boundary that is nearest to `v`; any of a circle's if `v` is its centre. O(1).
inline Vec2 nearest(const Boundary& boundary, const Vec2& v) noexcept {
  const Vec2 out = v - boundary.point;
  if (boundary.is_line()) return boundary.point + out.dot(boundary.direction) * boundary.direction;
  const double distance = out.norm();
  const Vec2 outward = distance > 0.0 ? Vec2{out / distance} : Vec2{Vec2::UnitX()};
  return boundary.point + boundary.radius * outward;
}

/// Relative to the squares of the lengths.
inline constexpr double touch = 1e-12;

inline Crossings line_with_line(const Boundary& a, const Boundary& b) {
  Crossings found;
  const double sine = cross(a.direction, b.direction);
  if (sine != 0.0) found.add(a.point + (cross(b.point - a.point, b.direction) / sine) * a.direction);
  return found;
}

/// The two points `half` to either side of `middle` along `direction`, given half^2; one where they touch.
inline Crossings either_side(const Vec2& middle, const Vec2& direction, double half2, double scale2) {
  Crossings found;
  if (half2 < -touch * scale2) return found;
  const double half = std::sqrt(std::max(half2, 0.0));
  found.add(middle + half * direction);
  if (half > 0.0) found.add(middle - half * direction);
  return found;
}

inline Crossings line_with_circle(const Boundary& line, const Boundary& circle) {
  const Vec2 foot = nearest(line, circle.point);
  const double radius2 = circle.radius * circle.radius;
  return either_side(foot, line.direction, radius2 - (foot - circle.point).squaredNorm(), radius2);
}

inline Crossings circle_with_circle(const Boundary& a, const Boundary& b) {
  const Vec2 between = b.point - a.point;
  const double d2 = between.squaredNorm();
  if (d2 == 0.0) return {};
  const double d = std::sqrt(d2);
  const double radius2 = a.radius * a.radius;
  const double along = (d2 + (a.radius - b.radius) * (a.radius + b.radius)) / (2.0 * d);
  const Vec2 axis = between / d;
  return either_side(a.point + along * axis, starboard_of(axis), radius2 - along * along, radius2);
}

/// Where two boundaries meet; nowhere if they are parallel, concentric or the same. A touch that rounding
/// parts by less than 1e-12 of the lengths counts. O(1).
inline Crossings crossings(const Boundary& a, const Boundary& b) noexcept {
  if (a.is_line()) return b.is_line() ? line_with_line(a, b) : line_with_circle(a, b);
  return b.is_line() ? line_with_circle(b, a) : circle_with_circle(a, b);
}

}  // namespace fairway::velocity_obstacle
