// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "fairway/avoidance/plane_program/plane_program.hpp"
#include "fairway/core/vec.hpp"

namespace fairway::orca2d {

/// A neighbour as ORCA sees it, all relative to own ship [m, m/s, north and east].
struct RelativeNeighbour {
  Vec2 p;         ///< p_B - p_A
  Vec2 v;         ///< v_A - v_B
  double radius;  ///< r_A + r_B
  Vec2 parting;   ///< unit; where to go if p and v say nothing
};

/// How far `v` is from the nearest boundary of the velocity obstacle, and which way: u = distance *
/// normal is the least change of v that leads out of it, or to its boundary if v is outside
/// (`distance` negative). `normal` is the outward unit normal there.
struct Change {
  Vec2 normal;
  double distance;
};

/// The velocities of `share` of that change or more, seen from `v_opt` (vandenberg2011, section 4.2).
inline HalfPlane half_plane(const Change& change, const Vec2& v_opt, double share) {
  return {change.normal, change.normal.dot(v_opt) + share * change.distance};
}

/// Below this sine a relative velocity points along the axis of the cone: no position is known better.
inline constexpr double on_axis = 1e-9;

/// Out of the disc of velocities that bring the two together at time `tau`.
inline Change out_of_disc(const RelativeNeighbour& encounter, double tau) noexcept {
  const double inverse_tau = 1.0 / tau;
  const Vec2 w = encounter.v - inverse_tau * encounter.p;
  const double w2 = w.squaredNorm();
  if (w2 > std::numeric_limits<double>::min()) {
    const double length = std::sqrt(w2);
    return {w / length, encounter.radius * inverse_tau - length};
  }

  // v is the centre: straight apart
  const double distance = encounter.p.norm();
  const Vec2 away = distance > 0.0 ? Vec2{encounter.p / -distance} : encounter.parting;
  return {away, encounter.radius * inverse_tau};
}

/// u of van den Berg et al. 2011, section 4.1, for a horizon `tau` > 0; of the disc that is left of the
/// velocity obstacle within one `period` where the two overlap already. With v on the axis of the cone the
/// change is to starboard, which is to starboard for both. O(1).
inline Change least_change(const RelativeNeighbour& encounter, double tau, double period) noexcept {
  const auto& [p, v, radius, parting] = encounter;
  const double d2 = p.squaredNorm();
  const double gap2 = d2 - radius * radius;
  if (gap2 <= 0.0) return out_of_disc(encounter, period);

  // the cone is cut off by the disc at tau: w = v - p / tau within the angle it spans there
  const Vec2 w = v - (1.0 / tau) * p;
  const double along = w.dot(p);
  if (along < 0.0 && along * along > radius * radius * w.squaredNorm()) return out_of_disc(encounter, tau);

  // the side of the cone. With sin = R / d and f the unit vector from the axis towards v, the normal is
  // cos f - sin p / d, and the apex, at no relative velocity, lies on both sides. This is
  // t = (p.v + |p x v| R / sqrt(d^2 - R^2)) / d^2 without forming v - t p, which cancels
  const double offside = cross(p, v);
  const bool to_port = offside < 0.0 && offside * offside > on_axis * on_axis * d2 * v.squaredNorm();
  const double reach = to_port ? -std::sqrt(gap2) : std::sqrt(gap2);
  const Vec2 normal = (reach * starboard_of(p) - radius * p) / d2;
  return {normal, -normal.dot(v)};
}

}  // namespace fairway::orca2d
