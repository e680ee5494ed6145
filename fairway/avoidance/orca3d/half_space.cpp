// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/orca3d/half_space.hpp"

#include <limits>

namespace fairway::orca {
namespace {

/// Below this sine a relative velocity points along the axis of the cone: no position is known better.
constexpr double on_axis = 1e-9;

/// Across the axis e of the cone, when the relative velocity does not tell: to starboard of the line
/// of sight, which is to starboard for both; if that is vertical, any fixed linear function of e.
Vec3 starboard_of(const Vec3& p) {
  const double horizontal = horizontal_norm(p);
  if (horizontal > on_axis * std::fabs(p.z())) return {-p.y() / horizontal, p.x() / horizontal, 0.0};
  return {0.0, std::copysign(1.0, p.z()), 0.0};
}

/// Out of the sphere of velocities that bring the two together at time `tau`.
Change out_of_sphere(const RelativeNeighbour& encounter, double tau) {
  const double inverse_tau = 1.0 / tau;
  const Vec3 w = encounter.v - inverse_tau * encounter.p;
  const double w2 = w.squaredNorm();
  if (w2 > std::numeric_limits<double>::min()) {
    const double length = std::sqrt(w2);
    return {w / length, encounter.radius * inverse_tau - length};
  }

  // v is the centre: straight apart
  const double distance = encounter.p.norm();
  const Vec3 away = distance > 0.0 ? Vec3{encounter.p / -distance} : encounter.parting;
  return {away, encounter.radius * inverse_tau};
}

}  // namespace

Change least_change(const RelativeNeighbour& encounter, double tau, double period) noexcept {
  const auto& [p, v, radius, parting] = encounter;
  const double d2 = p.squaredNorm();
  const double gap2 = d2 - radius * radius;
  if (gap2 <= 0.0) return out_of_sphere(encounter, period);

  // the cone is cut off by the sphere at tau: w = v - p / tau within the angle it spans there
  const Vec3 w = v - (1.0 / tau) * p;
  const double along = w.dot(p);
  if (along < 0.0 && along * along > radius * radius * w.squaredNorm()) return out_of_sphere(encounter, tau);

  // the side of the cone. With sin = R / d and f the unit vector from the axis towards v, the normal
  // is cos f - sin p / d, and the apex, at no relative velocity, lies on every tangent plane. This is
  // t = (p.v + |p x v| R / sqrt(d^2 - R^2)) / d^2 without forming v - t p, which cancels
  const double inverse_d2 = 1.0 / d2;
  const Vec3 across = v - (v.dot(p) * inverse_d2) * p;
  const double across2 = across.squaredNorm();
  const double cos2 = gap2 * inverse_d2;
  const Vec3 side = across2 > on_axis * on_axis * v.squaredNorm() ? Vec3{std::sqrt(cos2 / across2) * across}
                                                                  : Vec3{std::sqrt(cos2) * starboard_of(p)};
  const Vec3 normal = side - (radius * inverse_d2) * p;
  return {normal, -normal.dot(v)};
}

}  // namespace fairway::orca
