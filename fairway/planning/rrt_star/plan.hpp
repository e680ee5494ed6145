// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "fairway/avoidance/situation.hpp"
#include "fairway/avoidance/sketch.hpp"
#include "fairway/core/params.hpp"
#include "fairway/planning/minimum_snap/fit_trajectory.hpp"
#include "fairway/planning/path_planner.hpp"

namespace fairway {

/// A place to pass.
struct Waypoint {
  double n_m{};
  double e_m{};

  static consteval auto fields() {
    return std::tuple{
        field<&Waypoint::n_m>({-1e7, 1e7}, "north"),
        field<&Waypoint::e_m>({-1e7, 1e7}, "east"),
    };
  }
};

/// How a plan is made.
struct PlanParams {
  PathSearch planner = PathSearch::rrt_star;
  int iterations_count = 2000;
  double range_m = 0.0;
  double slack_m = 0.15;
  double clearance_m = 0.0;
  double max_speed_mps = 0.0;
  double max_acceleration_mps2 = 0.0;
  double segment_time_s = 0.0;
  bool rest_to_rest = false;
  std::vector<Waypoint> waypoints;

  static consteval auto fields() {
    using P = PlanParams;
    return std::tuple{
        field<&P::planner>("which search looks for the path"),
        field<&P::iterations_count>({1, 1000000}, "of the search; bit_star wants 5000"),
        field<&P::range_m>({0, 100000},
                           "longest branch of the search tree; 0 = a fifth of the extent of the map"),
        field<&P::clearance_m>({0, 10000}, "kept from charted obstacles, besides the own radius"),
        field<&P::slack_m>({0, 100}, "more that the path keeps where it can: room to round its corners"),
        field<&P::max_speed_mps>({0, 100}, "along the trajectory; 0 = as the mission and the limits say"),
        field<&P::max_acceleration_mps2>({0, 100}, "along the trajectory; 0 = as limits and thrust allow"),
        field<&P::segment_time_s>({0, 100000},
                                  "for each segment of the path; 0 = by its length and the limits"),
        field<&P::rest_to_rest>("come to rest at every waypoint, each segment by itself"),
        field<&P::waypoints>("to follow instead of planning, from the own position on"),
    };
  }
};

/// What a plan is made for.
struct PlanTask {
  Vec2 start = Vec2::Zero();  ///< [m, NE]
  Vec2 goal = Vec2::Zero();   ///< [m, NE]
  PlanarMap map{{}, 0.0};     ///< charted obstacles, grown by own radius and clearance
  TrajectoryLimits limits;
  std::optional<double> strays;  ///< of a vehicle that must turn: as strays_by() says (pursuit.hpp) [m]
};

/// The charted obstacles of a situation, grown by `inflation_m`. Throws InputError for an unusable one.
PlanarMap charted_map(const Situation& s, double inflation_m);

/// The task of a situation. Speed is that of the mission within its limits, acceleration that of the limits.
/// Where the forces are known, neither drag at that speed nor that acceleration takes more than half of what
/// surge and sway can give, an axis that is not driven aside. Of a vehicle that must turn
/// (trackable::must_turn()) both are at most what its envelope says. Throws InputError for an unusable
/// obstacle.
PlanTask plan_task(const PlanParams& params, const Situation& s);

enum class PlanStatus {
  ready,
  start_blocked,
  goal_blocked,
  no_path,
  no_speed,           ///< there is none that the vehicle may make
  waypoints_blocked,  ///< the given waypoints lead through an obstacle
  failed,             ///< an error that make_plan() throws
};

/// For people: "no path to the goal". Nothing where the plan is ready.
std::string_view note_of(PlanStatus status) noexcept;

/// A path and the trajectory along it, or why there is none.
struct Plan {
  PlanTask task;
  PlanStatus status{};
  std::vector<Vec2> path;  ///< [m, NE]
  Trajectory trajectory;   ///< from task.start at time 0
  FitStatus fit{};         ///< how the trajectory came to be; `violates`: see make_plan()
  std::vector<Vec2> tree;  ///< of the search, as in PathResult
};

/// The search tree, the path and the trajectory, as far as there are any, at a depth [m]. `with_tree` is
/// false where the rest is drawn anew at every decision.
void draw(const Plan& plan, double depth, bool with_tree, Sketch& sketch);

/// Path, smooth trajectory, check, repair. For a vehicle that must turn, the path, with as much more room as
/// the vehicle strays where there is that, else a quarter of it, and the trajectory goes along it at the
/// greatest speed from the beginning to the end (Pursuit says how it is followed). Where the smooth
/// trajectory cannot be repaired the vehicle comes to rest at every waypoint instead, which keeps it on the
/// straight lines of the path. With segment times given limits are not looked at. A few ten milliseconds
/// where there is something in the way (see README.md). Throws InputError as plan_path() and fit_trajectory()
/// do.
Plan make_plan(const PlanParams& params, PlanTask task, std::uint32_t seed);

}  // namespace fairway
