// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fairway/avoidance/situation.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/planning/teb/band.hpp"

namespace fairway::teb {

/// What of a way lies within the lookahead.
struct WayAhead {
  std::vector<Vec2> points;  ///< from own ship, over the corners of the way, to the end [m, NE]
  Pose end;                  ///< heading along the way
};

/// As far along `way`, of two points at least, as is looked ahead from its point nearest to `own`. O(points).
WayAhead ahead_on(std::span<const Vec2> way, const Vec2& own, double lookahead);

/// Whether something that is known now lies on what is left of `way` from its point nearest to own ship on.
/// O(points x obstacles); allocates.
bool is_blocked(const TebParams& params, std::span<const Vec2> way, const Situation& s);

/// A short way from own ship to `goal` round all that is known now, by RRT* and pulled taut
/// (path_planner.hpp): min_obstacle_dist_m off everything where there is room for it. Tracks count where they
/// are, unless they are to be reckoned with as they move. Nothing if none is found. About 10 ms where
/// something is in the way.
std::optional<std::vector<Vec2>> plan_way(const TebParams& params, const Situation& s, const Vec2& goal,
                                          Rng& rng);

}  // namespace fairway::teb
