// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "fairway/core/params.hpp"
#include "fairway/planning/planar_map.hpp"

namespace fairway {

/// Which search looks for the path; all of OMPL.
enum class PathSearch {
  rrt_star,           ///< RRT* (Karaman, Frazzoli 2011)
  informed_rrt_star,  ///< RRT* that samples only where the path can still get shorter (Gammell et al. 2014)
  bit_star,           ///< BIT*: batches of samples, searched in the order of promise (Gammell et al. 2015)
};

template <>
struct EnumNames<PathSearch> {
  static constexpr std::array names{"rrt_star", "informed_rrt_star", "bit_star"};
};

struct PathRequest {
  Vec2 start = Vec2::Zero();  ///< [m, NE]
  Vec2 goal = Vec2::Zero();   ///< [m, NE]
  PathSearch search{PathSearch::rrt_star};
  int iterations_count{2000};  ///< of the search; it never looks at a clock
  double range_m{0.0};         ///< longest branch of the trees of RRT*; 0: a fifth of the extent
  std::uint32_t seed{};
};

enum class PathStatus {
  found,
  start_blocked,  ///< the start is inside an inflated obstacle
  goal_blocked,   ///< the goal is
  no_path,        ///< none was found; there may be one that takes more iterations
};

struct PathResult {
  PathStatus status{};
  std::vector<Vec2> waypoints;  ///< from start to goal, straight between; empty unless found [m, NE]
  double length_m{};
  std::vector<Vec2> tree;  ///< edges of the search tree, two points each; empty without a search, or if there
                           ///< are more than max_tree_edges [m, NE]
};

/// A tree with more edges is not kept.
inline constexpr std::size_t max_tree_edges = 5000;

/// A short path over `map` from start to goal: sampled by the search, then pulled taut, so that what is left
/// of chance is the side on which obstacles are passed. Where the straight line is free it is the path. It
/// searches the box around start, goal and inflated obstacles, widened by a tenth of its diagonal.
///
/// The same map and request give the same bits, whatever else was planned before or is being planned by other
/// threads. Informed RRT* and BIT* take their seeds from a generator that OMPL has once per process, so
/// they run one at a time and alone; RRT* runs beside RRT*. All this holds as long as nobody else
/// in the process uses OMPL at the same time. OMPL is silenced.
///
/// Throws InputError for numbers that are not finite, a negative range or no iterations.
PathResult plan_path(const PlanarMap& map, const PathRequest& request);

}  // namespace fairway
