// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "fairway/core/vec.hpp"

namespace fairway {

/// What an algorithm draws of its own thinking, for the viewer and `fairway explain`; null in a
/// campaign. `meaning` is a short label such as "half-space of robot 3".
class Sketch {
 public:
  virtual ~Sketch() = default;

  /// A point or arrow in velocity space, relative to own position when drawn [m/s, NED].
  virtual void velocity(const Vec3& v, std::string_view meaning) = 0;
  /// Velocities v with (v - point) . normal >= 0 are allowed [m/s, NED].
  virtual void half_space(const Vec3& point, const Vec3& normal, std::string_view meaning) = 0;
  /// A line through positions [m, NED].
  virtual void path(std::span<const Vec3> points, std::string_view meaning) = 0;
  /// A ball of positions [m, NED].
  virtual void sphere(const Vec3& centre, double radius, std::string_view meaning) = 0;
};

}  // namespace fairway
