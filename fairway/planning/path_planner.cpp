// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/path_planner.hpp"

#include <cmath>
#include <utility>

#include "fairway/core/error.hpp"
#include "fairway/planning/ompl_search.hpp"
#include "fairway/planning/taut_path.hpp"

namespace fairway {
namespace {

void refuse_nonsense(const PathRequest& request) {
  if (!request.start.allFinite() || !request.goal.allFinite()) {
    throw InputError("start and goal of a path must be finite");
  }
  if (request.iterations_count < 1) throw InputError("a path takes at least one iteration");
  if (!(request.range_m >= 0.0 && std::isfinite(request.range_m))) {
    throw InputError("the range of a planner must be 0 m (automatic) or more");
  }
}

PathResult found(std::vector<Vec2> waypoints) {
  const double length = length_of(waypoints);
  return {.status = PathStatus::found, .waypoints = std::move(waypoints), .length_m = length};
}

}  // namespace

PathResult plan_path(const PlanarMap& map, const PathRequest& request) {
  refuse_nonsense(request);
  if (!map.is_free(request.start)) return {.status = PathStatus::start_blocked};
  if (!map.is_free(request.goal)) return {.status = PathStatus::goal_blocked};
  if (request.start == request.goal) return found({request.start});
  if (map.is_free(request.start, request.goal)) return found({request.start, request.goal});

  SearchResult search = search_path(map, request);
  PathResult result =
      search.path.empty() ? PathResult{.status = PathStatus::no_path} : found(taut_path(search.path, map));
  result.tree = std::move(search.tree);
  return result;
}

}  // namespace fairway
