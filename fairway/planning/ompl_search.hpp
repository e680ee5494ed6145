// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/planning/path_planner.hpp"

namespace fairway {

/// What a search came to.
struct SearchResult {
  std::vector<Vec2> path;  ///< from start to goal; empty if none was found [m, NE]
  std::vector<Vec2> tree;  ///< as in PathResult
};

/// The path that OMPL's search finds in request.iterations_count, from start to goal, and its tree.
/// Start and goal are free. Reproducible and safe among threads as plan_path() promises.
SearchResult search_path(const PlanarMap& map, const PathRequest& request);

}  // namespace fairway
