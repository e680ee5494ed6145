// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/velocity_program/velocity_program.hpp"
#include "fairway/core/vec.hpp"

namespace fairway::orca {

/// A neighbour as ORCA sees it, all relative to own ship [m, m/s, one common frame].
struct RelativeNeighbour {
  Vec3 p;         ///< p_B - p_A
  Vec3 v;         ///< v_A - v_B
  double radius;  ///< r_A + r_B
  Vec3 parting;   ///< unit; where to go if p and v say nothing
};

/// How far `v` is from the nearest boundary of the velocity obstacle, and which way: u = distance *
/// normal is the least change of v that leads out of it, or to its boundary if v is outside
/// (`distance` negative). `normal` is the outward unit normal there.
struct Change {
  Vec3 normal;
  double distance;
};

/// u of van den Berg et al. 2011, section 4.1 (raja2024, eq. 8), for a horizon `tau` > 0; of the sphere
/// that is left of the velocity obstacle within one `period` where the two overlap already. O(1).
Change least_change(const RelativeNeighbour& encounter, double tau, double period) noexcept;

/// The velocities of `share` of that change or more, seen from `v_opt` (raja2024, eq. 7).
inline HalfSpace half_space(const Change& change, const Vec3& v_opt, double share) {
  return {change.normal, change.normal.dot(v_opt) + share * change.distance};
}

}  // namespace fairway::orca
