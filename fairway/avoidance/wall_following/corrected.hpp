// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "fairway/avoidance/wall_following/wall_following.hpp"

namespace fairway::wall {

/// The corrected form: a velocity.
Command decide_corrected(const WallFollowing::Params& params, const Situation& s, WallFollowing::Round& round,
                         Context& context) noexcept;

/// A direction to go.
struct Way {
  Vec2 direction;  ///< unit [NED]
  bool has_wall;   ///< something keeps it from turning further to the side of the wall
};

/// The direction at the edge of what `allowed` forbids at `speed` > 0, next to `along`, with what is
/// forbidden on the side of the wall: from a direction that is forbidden away from the wall, else towards it
/// by up to 90 degrees. `turn` is 1 if away from the wall is to starboard, -1 if to port. Nothing if every
/// direction is forbidden. O(n^2).
std::optional<Way> way_along(std::span<const HalfPlane> allowed, const Vec2& along, double turn,
                             double speed) noexcept;

}  // namespace fairway::wall
