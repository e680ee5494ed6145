// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/orca3d/least_change.hpp"
#include "fairway/avoidance/velocity_program/velocity_program.hpp"

namespace fairway::orca {

/// A neighbour as ORCA sees it, all relative to own ship [m, m/s, one common frame]: p = p_B - p_A,
/// v = v_A - v_B, radius = r_A + r_B, and `parting`, a unit vector, where to go if p and v say nothing.
using RelativeNeighbour = lanes::NeighbourOf<double>;

/// How far `v` is from the nearest boundary of the velocity obstacle, and which way: u = distance *
/// normal is the least change of v that leads out of it, or to its boundary if v is outside
/// (`distance` negative). `normal` is the outward unit normal there.
using Change = lanes::ChangeOf<double>;

/// u of van den Berg et al. 2011, section 4.1 (raja2024, eq. 8), for a horizon `tau` > 0; of the sphere
/// that is left of the velocity obstacle within one `period` where the two overlap already. O(1).
[[gnu::always_inline]] inline Change least_change(const RelativeNeighbour& encounter, double tau,
                                                  double period) noexcept {
  return lanes::least_change(encounter, tau, period);
}

/// The velocities of `share` of that change or more, seen from `v_opt` (van den Berg et al. 2011, section 4;
/// raja2024, eq. 7, which prints the other side where v lies in the velocity obstacle: see README.md).
inline HalfSpace half_space(const Change& change, const Vec3& v_opt, double share) noexcept {
  return lanes::half_space<double>(change, v_opt, share);
}

}  // namespace fairway::orca
