// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

#include "fairway/avoidance/avoa/protective_zones.hpp"

/// Eqs. 1 and 2 of campos2019 as they stand, one velocity at a time, for tests.
namespace fairway::avoa {

/// When the ray t w, t >= 0, first meets the circle, seen from outside of it.
inline std::optional<double> ray_meets_circle(const Vec2& w, const Vec2& centre, double radius) {
  // |t w - c|^2 = r^2
  const double a = w.squaredNorm();
  const double half_b = -w.dot(centre);
  const double c = centre.squaredNorm() - radius * radius;
  const double discriminant = half_b * half_b - a * c;
  if (a == 0.0 || discriminant < 0.0 || half_b > 0.0) return std::nullopt;
  return (-half_b - std::sqrt(discriminant)) / a;
}

/// Whether a disc forbids the velocity `v`: in PZ and not in PZ_H. Inside of the disc, whether v leads
/// further in.
inline bool forbids(const MovingDisc& disc, const Vec2& v, double window, TimeToContact contact) {
  const Vec2 w = v - disc.velocity;
  const double gap = disc.position.norm() - disc.radius;
  if (gap <= 0.0) return w.dot(disc.position.norm() > 0.0 ? disc.position : disc.inward) > 0.0;

  const std::optional<double> time = ray_meets_circle(w, disc.position, disc.radius);
  if (!time) return false;
  return contact == TimeToContact::bound ? w.norm() > gap / window : *time <= window;
}

}  // namespace fairway::avoa
