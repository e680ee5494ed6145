// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/rrt_star/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "fairway/avoidance/trackable/keeper.hpp"
#include "fairway/core/math.hpp"
#include "fairway/planning/rrt_star/pursuit.hpp"

namespace fairway {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The speed at which `axis` drags with `force` [m/s].
double speed_against(const OnboardModel& model, int axis, double force) {
  const double linear = model.linear_damping[axis];
  const double quadratic = model.quadratic_damping[axis];
  if (quadratic <= 0.0) return linear > 0.0 ? force / linear : unlimited;
  return (std::sqrt(linear * linear + 4.0 * quadratic * force) - linear) / (2.0 * quadratic);
}

/// What half of the force of surge and of sway holds against drag, and accelerates.
TrajectoryLimits limits_of(const OnboardModel& model) {
  TrajectoryLimits limits{unlimited, unlimited};
  for (const int axis : {0, 1}) {
    const double half = 0.5 * math::fmin(-model.least[axis], model.greatest[axis]);
    if (!(half > 0.0)) continue;
    limits.max_speed_mps = math::fmin(limits.max_speed_mps, speed_against(model, axis, half));
    limits.max_acceleration_mps2 = math::fmin(limits.max_acceleration_mps2, half / model.mass[axis]);
  }
  return limits;
}

TrajectoryLimits limits_for(const PlanParams& params, const Situation& s) {
  const TrajectoryLimits thrust =
      s.model != nullptr ? limits_of(*s.model) : TrajectoryLimits{unlimited, unlimited};
  const double speed = params.max_speed_mps > 0.0 ? params.max_speed_mps
                                                  : math::fmin(s.goal.cruise_speed, thrust.max_speed_mps);
  const double acceleration = params.max_acceleration_mps2 > 0.0
                                  ? params.max_acceleration_mps2
                                  : math::fmin(s.limits.max_acceleration, thrust.max_acceleration_mps2);
  return {math::fmin(speed, s.limits.max_speed), acceleration};
}

TrajectoryLimits limits_of(const Envelope& can, const PlanParams& params, const Situation& s) {
  const double speed = params.max_speed_mps > 0.0 ? params.max_speed_mps : s.goal.cruise_speed;
  return {std::min({speed, s.limits.max_speed, can.ahead}), can.acceleration};
}

/// From the start through the given waypoints; one where the vehicle is already is no segment.
std::vector<Vec2> given_path(const PlanParams& params, const Vec2& start) {
  std::vector<Vec2> path{start};
  for (const Waypoint& waypoint : params.waypoints) {
    const Vec2 next{waypoint.n_m, waypoint.e_m};
    if (next != path.back()) path.push_back(next);
  }
  return path;
}

/// With slack, and for a vehicle that strays from it with room for that, or for some of it; without where
/// there is no room for any.
PathResult path_for(const PlanParams& params, const PlanTask& task, std::uint32_t seed) {
  if (!params.waypoints.empty()) return {.waypoints = given_path(params, task.start)};
  const PathRequest request{.start = task.start,
                            .goal = task.goal,
                            .search = params.planner,
                            .iterations_count = params.iterations_count,
                            .range_m = params.range_m,
                            .seed = seed};
  const double strays = task.strays.value_or(0.0);
  const std::array rooms{params.slack_m + strays, params.slack_m + 0.25 * strays};
  for (const double room : std::span{rooms}.first(task.strays ? 2 : 1)) {
    if (!(room > 0.0)) continue;
    PathResult roomy = plan_path(task.map.grown(room), request);
    if (roomy.status == PathStatus::found) return roomy;
  }
  return plan_path(task.map, request);
}

/// Along `path` without a stop.
Trajectory at_pace(std::span<const Vec2> path, double speed) {
  if (path.size() < 2) return Trajectory{path.front()};
  std::vector<Trajectory::Segment> segments;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 leg = path[i] - path[i - 1];
    Trajectory::Segment& segment = segments.emplace_back();
    segment.coefficients.col(0) = path[i - 1];
    segment.coefficients.col(1) = leg;
    segment.duration = leg.norm() / speed;
  }
  return Trajectory{std::move(segments)};
}

PlanStatus status_of(PathStatus status) {
  switch (status) {
    case PathStatus::found:
      return PlanStatus::ready;
    case PathStatus::start_blocked:
      return PlanStatus::start_blocked;
    case PathStatus::goal_blocked:
      return PlanStatus::goal_blocked;
    case PathStatus::no_path:
      break;
  }
  return PlanStatus::no_path;
}

}  // namespace

PlanarMap charted_map(const Situation& s, double inflation_m) {
  std::vector<Obstacle> charted;
  std::ranges::copy_if(s.obstacles, std::back_inserter(charted), &Obstacle::charted);
  return {charted, inflation_m};
}

PlanTask plan_task(const PlanParams& params, const Situation& s) {
  const Vec2 goal = params.waypoints.empty() ? seen_from_above(s.goal.position)
                                             : Vec2{params.waypoints.back().n_m, params.waypoints.back().e_m};
  PlanTask task{.start = seen_from_above(s.own.position),
                .goal = goal,
                .map = charted_map(s, s.own.radius + params.clearance_m)};
  const bool turns = trackable::must_turn(s);
  task.limits = turns ? limits_of(*s.envelope, params, s) : limits_for(params, s);
  if (turns) task.strays = strays_by(s, task.limits.max_speed_mps);
  return task;
}

std::string_view note_of(PlanStatus status) noexcept {
  constexpr std::array<std::string_view, 7> notes{"",
                                                  "start is inside an inflated obstacle",
                                                  "goal is inside an inflated obstacle",
                                                  "no path to the goal",
                                                  "no speed that the vehicle may make",
                                                  "the waypoints lead through an inflated obstacle",
                                                  "planning failed"};
  return notes[static_cast<std::size_t>(status)];
}

Plan make_plan(const PlanParams& params, PlanTask task, std::uint32_t seed) {
  Plan plan{.task = std::move(task)};
  const TrajectoryLimits& limits = plan.task.limits;
  if (!(limits.max_speed_mps > 0.0 && limits.max_acceleration_mps2 > 0.0)) {
    plan.status = PlanStatus::no_speed;
    return plan;
  }

  PathResult path = path_for(params, plan.task, seed);
  plan.status = status_of(path.status);
  plan.tree = std::move(path.tree);
  if (plan.status != PlanStatus::ready) return plan;
  plan.path = std::move(path.waypoints);
  if (plan.task.strays) {
    plan.trajectory = at_pace(plan.path, limits.max_speed_mps);
    return plan;
  }

  FitOptions options{.limits = limits,
                     .segment_time_s = params.segment_time_s,
                     .joining = params.rest_to_rest ? Joining::rest_to_rest : Joining::smooth};
  FittedTrajectory fitted = fit_trajectory(plan.path, plan.task.map, options);
  plan.fit = fitted.status;
  if (plan.fit == FitStatus::violates) {
    options.joining = Joining::rest_to_rest;
    fitted = fit_trajectory(plan.path, plan.task.map, options);
    if (fitted.status == FitStatus::violates) plan.status = PlanStatus::waypoints_blocked;
  }
  plan.trajectory = std::move(fitted.trajectory);
  return plan;
}

void draw(const Plan& plan, double depth, bool with_tree, Sketch& sketch) {
  const auto at_depth = [depth](std::span<const Vec2> points) {
    std::vector<Vec3> in_space;
    for (const Vec2& p : points) in_space.emplace_back(p.x(), p.y(), depth);
    return in_space;
  };
  if (with_tree && !plan.tree.empty()) sketch.tree(at_depth(plan.tree), "search tree");
  if (plan.status != PlanStatus::ready) return;
  sketch.path(at_depth(plan.path), "path");

  constexpr int pieces = 256;
  std::vector<Vec2> curve;
  for (int i = 0; i <= pieces; ++i)
    curve.push_back(plan.trajectory.sample(plan.trajectory.duration() * i / pieces).position);
  sketch.path(at_depth(curve), "trajectory");
}

}  // namespace fairway
