// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "fairway/core/math.hpp"

namespace fairway {

/// A vector in metres or metres per second. The frame is local NED (x north, y east, z down)
/// unless the name carries a frame suffix: `v_b` is in body axes (forward, starboard, down).
using Vec3 = Eigen::Vector3d;

/// A vector in the horizontal plane: north and east, or ahead and to starboard.
using Vec2 = Eigen::Vector2d;

/// A covariance in NED, or any other matrix of three by three.
using Mat3 = Eigen::Matrix3d;

inline bool is_finite(const Vec3& a) {
  return 0.0 * a.x() + 0.0 * a.y() + 0.0 * a.z() == 0.0;  // NaN and infinities times zero are NaN
}

/// Positive if `b` points to starboard of `a`: the sine of the angle between them times their lengths.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// `a` turned by a quarter to starboard.
inline Vec2 starboard_of(const Vec2& a) { return {-a.y(), a.x()}; }

/// The unit vector of a course [rad, clockwise from north].
inline Vec2 unit_at(double course) {
  const auto [sine, cosine] = math::sin_cos(course);
  return {cosine, sine};
}

/// `a` turned to starboard by `angle` [rad].
inline Vec2 turned(const Vec2& a, double angle) {
  const auto [sine, cosine] = math::sin_cos(angle);
  return cosine * a + sine * starboard_of(a);
}

/// `a` scaled to unit length, or zero if it has none.
inline Vec3 unit(const Vec3& a) {
  const double length = a.norm();
  return length > 0.0 ? Vec3{a / length} : Vec3{Vec3::Zero()};
}

/// Length of the north-east part.
inline double horizontal_norm(const Vec3& a) { return std::sqrt(a.x() * a.x() + a.y() * a.y()); }

/// `a` shortened to `limit` where it is longer, its direction kept.
inline Vec3 clamp_norm(const Vec3& a, double limit) {
  const double length = a.norm();
  return length > limit ? Vec3{(limit / length) * a} : a;
}

}  // namespace fairway
