// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

namespace fairway {

inline constexpr double pi = std::numbers::pi;

constexpr double radians(double degrees) { return degrees * (pi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / pi); }

/// The same direction in [-pi, pi].
inline double wrap_angle(double angle) {
  const double size = std::fabs(angle);
  if (size <= pi) return angle;
  if (size < 9.0) return std::copysign(1.0, angle) * (size - 2.0 * pi);  // exact, as the remainder is
  return std::remainder(angle, 2.0 * pi);
}

}  // namespace fairway
