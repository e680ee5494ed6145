// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/rrt_star/plan.hpp"

#include <gtest/gtest.h>

#include <array>

#include "fairway/planning/testing/four_obstacles.hpp"
#include "fairway/planning/testing/planar_vessel.hpp"

namespace fairway {
namespace {

PlanTask four_obstacle_task() {
  return {.start = four_obstacles::start,
          .goal = four_obstacles::goal,
          .map = four_obstacles::map(),
          .limits = {.max_speed_mps = 0.3, .max_acceleration_mps2 = 0.05}};
}

std::vector<Waypoint> waypoints_of(const std::vector<Vec2>& points) {
  std::vector<Waypoint> waypoints;
  for (const Vec2& p : points) waypoints.push_back({.n_m = p.x(), .e_m = p.y()});
  return waypoints;
}

TEST(Plan, LeadsFromStartToGoalClearOfObstacles) {
  const Plan plan = make_plan({}, four_obstacle_task(), 1);
  EXPECT_EQ(plan.status, PlanStatus::ready);
  EXPECT_EQ(note_of(plan.status), "");
  EXPECT_EQ(plan.path.front(), four_obstacles::start);
  EXPECT_EQ(plan.path.back(), four_obstacles::goal);
  EXPECT_LT((plan.trajectory.sample(0.0).position - four_obstacles::start).norm(), 1e-12);
  EXPECT_LT((plan.trajectory.sample(1e9).position - four_obstacles::goal).norm(), 1e-9);
  EXPECT_GE(least_clearance(plan.trajectory, plan.task.map), 0.0);
  EXPECT_LE(plan.trajectory.peak_speed(), 0.3 * (1 + 1e-12));
}

TEST(Plan, FollowsGivenWaypointsWithGivenTimes) {
  const PlanParams params{.segment_time_s = 28.0,
                          .waypoints = waypoints_of(four_obstacles::published_waypoints())};
  const Plan plan = make_plan(params, four_obstacle_task(), 1);
  EXPECT_EQ(plan.status, PlanStatus::ready);
  EXPECT_EQ(plan.fit, FitStatus::as_given);
  EXPECT_EQ(plan.path, four_obstacles::published_waypoints());
  EXPECT_DOUBLE_EQ(plan.trajectory.duration(), 280.0);
}

TEST(Plan, GivenWaypointsBeginAtTheOwnPosition) {
  PlanTask task = four_obstacle_task();
  task.start = {-5, 0};
  const Plan plan = make_plan({.waypoints = waypoints_of({{0, 0}, {0, 20}})}, task, 1);
  EXPECT_EQ(plan.path, (std::vector<Vec2>{{-5, 0}, {0, 0}, {0, 20}}));
}

TEST(Plan, GivenWaypointsThroughAnObstacleAreNotFollowed) {
  const std::array wall{Obstacle{.kind = Obstacle::Kind::segment, .from = {10, -900, 0}, .to = {10, 900, 0}}};
  PlanTask task = four_obstacle_task();
  task.map = PlanarMap{wall, 1.0};
  const Plan plan = make_plan({.waypoints = waypoints_of({{20, 0}})}, task, 1);
  EXPECT_EQ(plan.status, PlanStatus::waypoints_blocked);
  EXPECT_EQ(note_of(plan.status), "the waypoints lead through an inflated obstacle");
}

TEST(Plan, ComesToRestAtEveryWaypointWhereAskedTo) {
  const PlanParams params{.rest_to_rest = true,
                          .waypoints = waypoints_of(four_obstacles::published_waypoints())};
  const Plan plan = make_plan(params, four_obstacle_task(), 1);
  EXPECT_EQ(plan.status, PlanStatus::ready);
  for (std::size_t i = 0; i < plan.trajectory.segments().size(); ++i) {
    EXPECT_LT(plan.trajectory.derivative(i, 1, 1.0).norm(), 1e-12);
  }
  EXPECT_LE(plan.trajectory.peak_speed(), 0.3 * (1 + 1e-12));
}

TEST(Plan, SaysWhyThereIsNone) {
  PlanTask blocked_start = four_obstacle_task(), blocked_goal = blocked_start, still = blocked_start;
  blocked_start.start = {10, 13};
  blocked_goal.goal = {20, 30};
  still.limits.max_speed_mps = 0.0;
  EXPECT_EQ(note_of(make_plan({}, blocked_start, 1).status), "start is inside an inflated obstacle");
  EXPECT_EQ(note_of(make_plan({}, blocked_goal, 1).status), "goal is inside an inflated obstacle");
  EXPECT_EQ(note_of(make_plan({}, still, 1).status), "no speed that the vehicle may make");
}

TEST(Plan, ATaskSeesChartedObstaclesGrownByTheOwnSize) {
  std::vector<Obstacle> obstacles = four_obstacles::obstacles();
  obstacles.push_back({.kind = Obstacle::Kind::sphere, .position = {0, 1, 0}, .radius = 5, .charted = false});
  const Situation s{.period = 0.1,
                    .own = {.position = {0, 0, 7}, .radius = 3.2},
                    .goal = {.position = {22, 35, 7}, .cruise_speed = 0.4},
                    .limits = {.max_speed = 0.3, .max_acceleration = 0.05},
                    .obstacles = obstacles};
  EXPECT_EQ(plan_task({.clearance_m = 0.0}, s).map, four_obstacles::map());
  EXPECT_EQ(plan_task({.clearance_m = 0.5}, s).map.inflation(), 3.7);
  const PlanTask task = plan_task({}, s);
  EXPECT_EQ(task.start, Vec2(0, 0));
  EXPECT_EQ(task.goal, Vec2(22, 35));
  EXPECT_EQ(task.limits.max_speed_mps, 0.3);
  EXPECT_EQ(task.limits.max_acceleration_mps2, 0.05);
}

TEST(Plan, DragAndAccelerationEachLeaveHalfOfTheForces) {
  OnboardModel model = transport_model();
  Situation s{.period = 0.1, .goal = {.cruise_speed = 10.0}, .model = &model};
  const TrajectoryLimits limits = plan_task({}, s).limits;
  EXPECT_NEAR(model.drag(0, limits.max_speed_mps), 0.5 * 778.0, 1e-9);
  EXPECT_NEAR(model.mass[0] * limits.max_acceleration_mps2, 0.5 * 778.0, 1e-9);
  EXPECT_EQ(plan_task({.max_speed_mps = 0.2}, s).limits.max_speed_mps, 0.2);
  model.greatest[1] = model.least[1] = 0.0;  // not driven abeam: that axis says nothing
  EXPECT_EQ(plan_task({}, s).limits.max_speed_mps, limits.max_speed_mps);
  model.greatest[0] = 1.0;
  EXPECT_LT(plan_task({}, s).limits.max_speed_mps, 0.01);
}

TEST(Plan, TheGoalAtTheStartIsRest) {
  PlanTask task = four_obstacle_task();
  task.goal = task.start;
  const Plan plan = make_plan({}, task, 1);
  EXPECT_EQ(plan.status, PlanStatus::ready);
  EXPECT_EQ(plan.trajectory.sample(100.0).position, task.start);
}

}  // namespace
}  // namespace fairway
