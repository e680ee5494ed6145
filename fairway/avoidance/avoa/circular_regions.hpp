// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoa/protective_zones.hpp"
#include "fairway/avoidance/situation.hpp"

namespace fairway::avoa {

/// How obstacles become circular regions.
struct Regions {
  double margin{};          ///< kept besides the radii [m]
  double spacing{};         ///< of the circles along a wall [m], > 0
  double window{};          ///< t_H of tracks [s]
  double window_at_rest{};  ///< t_H of obstacles [s]
  TimeToContact contact{};
};

/// Adds everyone in the situation to `zones`, seen from above: tracks and spheres as discs; "objects with
/// complex shapes" as several (campos2019, III-A-1): the band of own radius and margin round a segment, or
/// round each edge of a polygon, is covered by equal discs from end to end, at most `spacing` apart and at
/// most 256 for what of an edge is in range. From inside a polygon, what does not lead out through its
/// nearest surface point is forbidden. O(tracks + obstacle vertices + discs) times what a disc costs.
void add_everyone(const Situation& situation, const Regions& regions, ProtectiveZones& zones);

}  // namespace fairway::avoa
