// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <tuple>

#include "fairway/avoidance/algorithm.hpp"
#include "fairway/planning/rrt_star/plan.hpp"
#include "fairway/planning/rrt_star/pursuit.hpp"
#include "fairway/planning/rrt_star/trajectory_tracker.hpp"

namespace fairway {

/// Plans once, then follows: the shortest path around the charted obstacles by RRT*, a minimum snap
/// trajectory along it, and PID control of the position on it (rehman2021, sections III-A-3 and IV-B-2). It
/// sees neither tracks nor obstacles that are not charted. Everything is in the horizontal plane, so the
/// depth of the start is kept.
///
/// It plans on the first decision, from where the vehicle is and as if it were at rest, and again whenever
/// the goal is another; a plan that failed is tried again when anything it depended on is different, of the
/// own position more than the own radius. Planning takes a few ten milliseconds and allocates (plan.hpp),
/// following is O(obstacles + log segments).
///
/// A vehicle that must turn follows the path itself, by looking ahead (Pursuit), and a plan is made anew also
/// where that has come to nothing or something charted lies on what is left of it, at most every
/// `between_plans_s`, and taken unless it leads nowhere: the paper has neither.
struct RrtStar {
  static constexpr AlgorithmInfo info{
      .name = "rrt_star",
      .title = "RRT* path and minimum snap trajectory, planned before leaving",
      .source =
          "rehman2021, sections III-A-3 and IV-B-2; Karaman, Frazzoli 2011; Mellinger, Kumar 2011; on "
          "vehicles that must turn line of sight (Fossen 2011) and plans made anew",
      .planar = true,
      .allocates = true,
      .isotropic = false,
      .ignores_movers = true,
      .needs_sway = true,
      .needs_stopping = true,
      .needs_chart = true,
      .finds_way = true,
  };

  struct Params : PlanParams, TrackingParams {
    static consteval auto fields() { return std::tuple_cat(PlanParams::fields(), TrackingParams::fields()); }
  };

  struct Memory {
    std::shared_ptr<const Plan> plan;
    double begin_s{};  ///< time of the situation at which the trajectory begins
    double depth{};    ///< of its start [m], for who looks
    TrajectoryTracker::Memory tracking;
    Pursuit pursuit;     ///< of the path, by a vehicle that must turn
    double planned_s{};  ///< when a plan was made last, taken or not
    double looked_s{};   ///< when such a one looked at the chart last
  };

  Params params;

  /// Mode::cruise if the straight way to the goal is free, Mode::avoid if it is not. Mode::infeasible,
  /// no velocity and a note if there is no plan.
  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;
};

static_assert(AvoidanceAlgorithm<RrtStar>);

}  // namespace fairway
