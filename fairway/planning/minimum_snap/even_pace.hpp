// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fairway/planning/minimum_snap/minimum_snap.hpp"
#include "fairway/planning/planar_map.hpp"

namespace fairway {

/// A minimum snap trajectory and the waypoints that it is made of.
struct PacedTrajectory {
  Trajectory trajectory;
  std::vector<Vec2> waypoints;  ///< [m, NE]
};

/// A smooth trajectory along the straight lines of `path` that keeps near the limits all the way: through
/// points at even distances on the path, each at the time at which a vehicle that speeds up, cruises and
/// slows down would be there. So no corner sets the pace of the whole, and no long segment swings out beside
/// short ones. Where the curve is not clear of the obstacles of `map` the points are put closer. Limits are
/// kept exactly. Nothing if no spacing gives a clear curve, or the path has no length. O(points) a spacing,
/// and a search for the least clearance.
std::optional<PacedTrajectory> evenly_paced(std::span<const Vec2> path, const PlanarMap& map,
                                            const TrajectoryLimits& limits);

}  // namespace fairway
