// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "fairway/avoidance/situation.hpp"

namespace fairway {

/// Something to keep clear of, as a ball: a track or a sphere as it is; a segment, and each edge of a
/// polygon, as the point of it that is nearest, with no radius, and flat unless that is one of its ends. From
/// inside a polygon its nearest edge is a
/// ball on the far side of own ship whose surface touches it, so that away from the centre is out.
struct Hazard {
  Vec3 centre;    ///< [m, NED]
  Vec3 velocity;  ///< [m/s, NED]
  double radius;  ///< [m]
  bool is_flat;   ///< the surface runs straight across the line to it: motion along it is free
  bool reacts;    ///< it does its share of keeping clear
  Vec3 parting;   ///< where to leave it from exactly its place, unit [NED]

  /// From own sphere to its surface [m]; negative if they overlap.
  double gap(const Ownship& own) const { return (own.position - centre).norm() - radius - own.radius; }
};

/// Writes what is within `range` [m] of own sphere to `found`: obstacles as listed, then tracks, nearest
/// first. Returns how many; what does not fit is left out. O(tracks + obstacle vertices).
std::size_t hazards_near(const Situation& s, double range, std::span<Hazard> found) noexcept;

}  // namespace fairway
