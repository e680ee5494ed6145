// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/boundary.hpp"

#include <algorithm>

namespace fairway::velocity_obstacle {
namespace {

/// Relative to the squares of the lengths.
constexpr double touch = 1e-12;

Crossings line_with_line(const Boundary& a, const Boundary& b) {
  Crossings found;
  const double sine = cross(a.direction, b.direction);
  if (sine != 0.0) found.add(a.point + (cross(b.point - a.point, b.direction) / sine) * a.direction);
  return found;
}

/// The two points `half` to either side of `middle` along `direction`, given half^2; one where they touch.
Crossings either_side(const Vec2& middle, const Vec2& direction, double half2, double scale2) {
  Crossings found;
  if (half2 < -touch * scale2) return found;
  const double half = std::sqrt(std::max(half2, 0.0));
  found.add(middle + half * direction);
  if (half > 0.0) found.add(middle - half * direction);
  return found;
}

Crossings line_with_circle(const Boundary& line, const Boundary& circle) {
  const Vec2 foot = nearest(line, circle.point);
  const double radius2 = circle.radius * circle.radius;
  return either_side(foot, line.direction, radius2 - (foot - circle.point).squaredNorm(), radius2);
}

Crossings circle_with_circle(const Boundary& a, const Boundary& b) {
  const Vec2 between = b.point - a.point;
  const double d2 = between.squaredNorm();
  if (d2 == 0.0) return {};
  const double d = std::sqrt(d2);
  const double radius2 = a.radius * a.radius;
  const double along = (d2 + (a.radius - b.radius) * (a.radius + b.radius)) / (2.0 * d);
  const Vec2 axis = between / d;
  return either_side(a.point + along * axis, starboard_of(axis), radius2 - along * along, radius2);
}

}  // namespace

void Stretch::keep_positive(double offset, double slope) noexcept {
  const double end = -offset / slope;
  if (slope > 0.0) {
    from = std::max(from, end);
  } else if (slope < 0.0) {
    to = std::min(to, end);
  } else if (!(offset > 0.0)) {
    to = from;
  }
}

void Stretch::keep_disc(const Boundary& line, const Vec2& centre, double radius) noexcept {
  const Vec2 out = centre - line.point;
  const double along = out.dot(line.direction);
  const double across = cross(line.direction, out);
  const double half2 = radius * radius - across * across;
  const double half = radius > 0.0 && half2 > 0.0 ? std::sqrt(half2) : 0.0;
  from = std::max(from, along - half);
  to = std::min(to, along + half);
}

Vec2 nearest(const Boundary& boundary, const Vec2& v) noexcept {
  const Vec2 out = v - boundary.point;
  if (boundary.is_line()) return boundary.point + out.dot(boundary.direction) * boundary.direction;
  const double distance = out.norm();
  const Vec2 outward = distance > 0.0 ? Vec2{out / distance} : Vec2{Vec2::UnitX()};
  return boundary.point + boundary.radius * outward;
}

Crossings crossings(const Boundary& a, const Boundary& b) noexcept {
  if (a.is_line()) return b.is_line() ? line_with_line(a, b) : line_with_circle(a, b);
  return b.is_line() ? line_with_circle(b, a) : circle_with_circle(a, b);
}

}  // namespace fairway::velocity_obstacle
