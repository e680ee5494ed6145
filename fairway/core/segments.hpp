// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "fairway/core/vec.hpp"

namespace fairway {

/// The point of the segment from `a` to `b` nearest to `p`, in a plane or in space.
template <class V>
V nearest_on_segment(const V& a, const V& b, const V& p) noexcept {
  const V ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return a + t * ab;
}

/// How far `p` is from the segment from `a` to `b`.
template <class V>
double distance_to_segment(const V& a, const V& b, const V& p) noexcept {
  return (p - nearest_on_segment(a, b, p)).norm();
}

/// True if the segments from `a` to `b` and from `c` to `d` cross at a point inside both.
inline bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) noexcept {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0.0 && cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
}

/// The least distance of an end of one segment from the other: theirs, unless they are nearest inside both.
template <class V>
double distance_by_ends(const V& a, const V& b, const V& c, const V& d) noexcept {
  return std::min({distance_to_segment(c, d, a), distance_to_segment(c, d, b), distance_to_segment(a, b, c),
                   distance_to_segment(a, b, d)});
}

/// How far the segments from `a` to `b` and from `c` to `d` are from each other: 0 where they cross.
inline double distance_between(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) noexcept {
  return cross_each_other(a, b, c, d) ? 0.0 : distance_by_ends(a, b, c, d);
}

/// The same in space. Where they are almost parallel it is right to 1e-8 of their length.
inline double distance_between(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept {
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  const double by_ends = distance_by_ends(a, b, c, d);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0.0)) return by_ends;
  // of the lines that they lie on
  const double s = (uv * vw - vv * uw) / determinant;
  const double t = (uu * vw - uv * uw) / determinant;
  const bool inside_both = s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0;
  return inside_both ? std::min(by_ends, (w + s * u - t * v).norm()) : by_ends;
}

}  // namespace fairway
