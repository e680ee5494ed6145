// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
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

/// As many hazards enter one decision at most.
inline constexpr std::size_t max_hazards = 256;

/// What is near, on the stack.
struct Hazards {
  std::array<Hazard, max_hazards> all;
  std::size_t count = 0;
  bool left_out = false;  ///< something in range found no room

  std::span<const Hazard> view() const { return {all.data(), count}; }
};

/// Writes what is within `range` [m] of own sphere to `found`: obstacles as listed, then tracks, nearest
/// first. Where that is too much, the nearest tracks, but no more than three quarters of the room for
/// certain, and the nearest of all else. O(tracks + obstacle vertices), O(room) more for each that is too
/// much.
void find_hazards_near(const Situation& s, double range, Hazards& found) noexcept;

}  // namespace fairway
