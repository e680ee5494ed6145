// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/planning/path_planner.hpp"

namespace fairway {

/// The path that OMPL's search finds in request.iterations_count, from start to goal; empty if none.
/// Start and goal are free. Reproducible and safe among threads as plan_path() promises.
std::vector<Vec2> search_path(const PlanarMap& map, const PathRequest& request);

}  // namespace fairway
