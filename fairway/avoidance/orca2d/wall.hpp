// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/avoidance/plane_program/plane_program.hpp"
#include "fairway/core/vec.hpp"

namespace fairway::orca2d {

/// One end of a wall, relative to own ship [m, north and east].
struct WallEnd {
  Vec2 p;
  bool is_convex = true;       ///< false where the next wall comes towards us: what is beyond is its business
  Vec2 beyond = Vec2::Zero();  ///< unit; along the next wall, away from this one; zero where there is none
};

/// A straight wall, seen from the side that it faces: own ship lies on it or on the side from which
/// `starboard` is the end to starboard. Both ends in one place are a post.
struct Wall {
  WallEnd starboard;
  WallEnd port;
};

/// Own ship and how far ahead it looks.
struct Mariner {
  Vec2 velocity;   ///< present one [m/s, north and east]
  double radius;   ///< [m]
  double horizon;  ///< for what does not move, > 0 [s]
  double period;   ///< until the next decision, > 0 [s]
  Vec2 parting;    ///< unit; where to go from a post that is exactly here
};

/// The velocities that `wall` leaves: beyond the tangent to its velocity obstacle at the point nearest to
/// the present velocity (van den Berg et al. 2011, section 4.3). That obstacle is the wall widened by the
/// radius, over all times within the horizon: a convex shape with the legs that are its tangents through the
/// origin. Nothing where that point belongs to the next wall. Closer than the radius: the velocities
/// that are clear of it within one period. O(1).
std::optional<HalfPlane> half_plane(const Wall& wall, const Mariner& mariner) noexcept;

/// The velocities that lead from inside a solid out through `wall`, one radius clear of it, within one
/// period; `wall` is seen from behind. O(1).
HalfPlane way_out(const Wall& wall, const Mariner& mariner) noexcept;

/// True if `half_plane` forbids already all that `wall` can. O(1).
bool covers(const HalfPlane& half_plane, const Wall& wall, const Mariner& mariner) noexcept;

}  // namespace fairway::orca2d
