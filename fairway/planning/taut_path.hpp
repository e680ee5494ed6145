// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/planning/planar_map.hpp"

namespace fairway {

/// `path` pulled taut: waypoints that are not needed are dropped and corners are cut as far as the obstacles
/// let them, until a round gains less than a ten thousandth. It passes obstacles on the sides that `path`
/// does, unless there is a short cut in sight, and is never longer. Of a free path it makes a free one.
///
/// O(n^2) lines of sight each round, with n = 100 points on the path and its waypoints; at most 20 rounds.
std::vector<Vec2> taut_path(std::span<const Vec2> path, const PlanarMap& map);

}  // namespace fairway
