// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/rrt_star/rrt_star.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/drawing.hpp"
#include "fairway/avoidance/testing/boat.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/planning/builtin.hpp"
#include "fairway/planning/testing/four_obstacles.hpp"
#include "fairway/planning/testing/planar_vessel.hpp"
#include "fairway/planning/testing/planner_at_work.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;

/// The transport system at the start of the four-obstacle case.
OwnedSituation four_obstacle_encounter() {
  OwnedSituation e;
  e.situation = {.time = 5.0,
                 .period = 0.1,
                 .own = {.position = {0, 0, 7}, .radius = 3.2},
                 .goal = {.position = {22, 35, 7}, .cruise_speed = 0.3},
                 .limits = {.max_speed = 0.5, .max_acceleration = 0.05}};
  e.obstacles = four_obstacles::obstacles();
  return e;
}

Avoider avoider(const ParamValues& params = {}, std::uint64_t seed = 1) {
  Catalog catalog;
  add_planners(catalog);
  return catalog.make("rrt_star", params, Rng{seed});
}

TEST(RrtStar, TakesAVelocityDrivenVehicleToTheGoalClearOfObstacles) {
  OwnedSituation e = four_obstacle_encounter();
  Avoider helm = avoider();
  const PlanarMap map = four_obstacles::map();
  double closest = 1e9;
  int avoiding = 0, steps = 0;
  for (; steps < 4000; ++steps) {
    const Command command = helm.decide(e);
    ASSERT_NE(command.mode, Mode::infeasible);
    EXPECT_FALSE(command.wrench);
    avoiding += command.mode == Mode::avoid ? 1 : 0;
    carry_out(e, command);
    closest = std::fmin(closest, map.clearance(seen_from_above(e.situation.own.position)));
  }
  EXPECT_LT((e.situation.own.position - e.situation.goal.position).norm(), 1e-3);
  EXPECT_EQ(e.situation.own.position.z(), 7.0);
  EXPECT_GT(closest, -0.01);  // velocities are held for 0.1 s; measured 0.15
  EXPECT_GT(avoiding, 300);   // until the goal is in sight
  EXPECT_LT(avoiding, steps);
}

TEST(RrtStar, TakesAForceDrivenVehicleAlongItsTrajectory) {
  const OnboardModel model = transport_model();
  OwnedSituation e = four_obstacle_encounter();
  e.situation.period = 0.02;
  e.situation.time = 0.0;
  e.situation.model = &model;
  PlanarVessel vessel{.model = model};
  const RrtStar algorithm{{}};
  RrtStar::Memory memory;
  Rng rng{3};
  Context context{rng};
  double squares = 0.0;
  int steps = 0;
  do {
    e.situation.own.position << vessel.position, 7.0;
    e.situation.own.velocity << vessel.velocity(), 0.0;
    e.situation.own.yaw = vessel.yaw;
    e.situation.own.yaw_rate = vessel.yaw_rate;
    const Command command = algorithm.decide(e, memory, context);
    const Vec2 wanted = memory.plan->trajectory.sample(e.situation.time).position;
    squares += (wanted - vessel.position).squaredNorm();
    vessel.move(command.wrench.value(), e.situation.period);
    e.situation.time = ++steps * e.situation.period;
  } while (e.situation.time < memory.plan->trajectory.duration());
  EXPECT_LT(std::sqrt(squares / steps), 0.05);  // measured 1.5e-3
  EXPECT_LT((vessel.position - four_obstacles::goal).norm(), 0.05);
}

TEST(RrtStar, TheSameSituationsAndSeedGiveTheSameBits) {
  const auto run = [](const ParamValues& params) {
    OwnedSituation e = four_obstacle_encounter();
    Avoider helm = avoider(params, 9);
    std::vector<Command> commands;
    for (int i = 0; i < 50; ++i) {
      commands.push_back(helm.decide(e));
      carry_out(e, commands.back());
    }
    return commands;
  };
  for (const std::string search : {"rrt_star", "informed_rrt_star", "bit_star"}) {
    const ParamValues params{{"planner", search}};
    const std::vector<Command> expected = run(params);
    std::vector<std::vector<Command>> others(4);
    {
      std::vector<std::jthread> threads;
      for (auto& other : others) threads.emplace_back([&] { other = run(params); });
    }
    for (const auto& other : others) EXPECT_EQ(other, expected) << search;
  }
}

TEST(RrtStar, InOpenWaterItGoesStraightAndCruises) {
  OwnedSituation e = four_obstacle_encounter();
  e.obstacles.clear();
  Avoider helm = avoider();
  for (int i = 0; i < 100; ++i) {
    const Command command = helm.decide(e);
    EXPECT_EQ(command.mode, Mode::cruise);
    EXPECT_NEAR(command.velocity.x() * 35 - command.velocity.y() * 22, 0.0, 1e-12);
    carry_out(e, command);
  }
}

TEST(RrtStar, WhatIsNotChartedIsNotSeen) {
  OwnedSituation charted = four_obstacle_encounter(), uncharted = charted, open = charted;
  for (Obstacle& obstacle : uncharted.obstacles) obstacle.charted = false;
  open.obstacles.clear();
  charted.situation.time = uncharted.situation.time = open.situation.time = 5.0;
  Avoider seeing = avoider(), blind = avoider(), free = avoider();
  Command with, without, none;
  for (int i = 0; i < 200; ++i) {
    with = seeing.decide(charted);
    without = blind.decide(uncharted);
    none = free.decide(open);
    for (OwnedSituation* e : {&charted, &uncharted, &open}) e->situation.time += 0.1;
  }
  EXPECT_EQ(without, none);
  EXPECT_NE(with.velocity, none.velocity);
}

TEST(RrtStar, AnotherGoalIsAnotherPlan) {
  OwnedSituation e = four_obstacle_encounter();
  const RrtStar algorithm{{}};
  RrtStar::Memory memory;
  Rng rng{3};
  Context context{rng};
  (void)algorithm.decide(e, memory, context);
  const auto first = memory.plan;
  e.situation.time += 10.0;
  (void)algorithm.decide(e, memory, context);
  EXPECT_EQ(memory.plan, first);
  e.situation.goal.position = {0, 30, 7};
  (void)algorithm.decide(e, memory, context);
  EXPECT_NE(memory.plan, first);
  EXPECT_EQ(memory.begin_s, 15.0);
  EXPECT_EQ(memory.plan->task.goal, Vec2(0, 30));
}

TEST(RrtStar, WithoutAPlanItStaysAndSaysWhy) {
  OwnedSituation start = four_obstacle_encounter(), goal = start, walled = start;
  start.situation.own.position = {10, 15, 7};
  goal.situation.goal.position = {10, 33, 7};
  const Vec3 a{18, 31, 0}, b{26, 31, 0}, c{26, 39, 0}, d{18, 39, 0};
  walled.situation.own.radius = 0.5;
  for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}}) {
    walled.obstacles.push_back({.kind = Obstacle::Kind::segment, .from = from, .to = to});
  }
  EXPECT_EQ(avoider().decide(start),
            (Command{.mode = Mode::infeasible, .note = "start is inside an inflated obstacle"}));
  EXPECT_EQ(avoider().decide(goal),
            (Command{.mode = Mode::infeasible, .note = "goal is inside an inflated obstacle"}));
  EXPECT_EQ(avoider().decide(walled), (Command{.mode = Mode::infeasible, .note = "no path to the goal"}));
}

TEST(RrtStar, AFailureIsRememberedUntilTheSituationChanges) {
  OwnedSituation e = four_obstacle_encounter();
  e.situation.goal.position = {10, 33, 7};
  const RrtStar algorithm{{}};
  RrtStar::Memory memory;
  Rng rng{3};
  Context context{rng};
  (void)algorithm.decide(e, memory, context);
  const auto failed = memory.plan;
  e.situation.time += 1.0;
  e.situation.own.position.x() += 1.0;
  (void)algorithm.decide(e, memory, context);
  EXPECT_EQ(memory.plan, failed);
  e.situation.own.position.x() -= 5.0;  // by more than its radius
  (void)algorithm.decide(e, memory, context);
  EXPECT_NE(memory.plan, failed);
  e.obstacles.erase(e.obstacles.begin() + 2);  // the one on the goal
  EXPECT_NE(algorithm.decide(e, memory, context).mode, Mode::infeasible);
}

TEST(RrtStar, DrawsTheTreeThePathAndTheTrajectoryAtItsDepth) {
  OwnedSituation e = four_obstacle_encounter();
  Drawing drawing;
  (void)avoider().decide(e, &drawing);
  const auto strokes = drawing.strokes();
  ASSERT_EQ(strokes.size(), 3U);
  EXPECT_EQ(strokes[0].kind, Stroke::Kind::tree);
  EXPECT_EQ(strokes[0].meaning, "search tree");
  EXPECT_EQ(strokes[1].meaning, "path");
  EXPECT_EQ(strokes[2].meaning, "trajectory");
  for (const Stroke& stroke : strokes.last(2)) {
    EXPECT_LT((stroke.points.front() - Vec3(0, 0, 7)).norm(), 1e-12) << stroke.meaning;
    EXPECT_LT((stroke.points.back() - Vec3(22, 35, 7)).norm(), 1e-9) << stroke.meaning;
  }
}

TEST(RrtStar, DrawsTheSameUntilThereIsAnotherPlan) {
  OwnedSituation e = four_obstacle_encounter();
  Avoider helm = avoider();
  Drawing first, later;
  carry_out(e, helm.decide(e, &first));
  for (int i = 0; i < 50; ++i) carry_out(e, helm.decide(e));
  (void)helm.decide(e, &later);
  EXPECT_TRUE(std::ranges::equal(first.strokes(), later.strokes()));
}

/// Among walls that bend the way to a goal 30 m north.
OwnedSituation between_walls(const Envelope& can) {
  OwnedSituation e = encounters::under_way(can);
  e.situation.period = 0.2;
  e.situation.goal = {.position = {30, 0, 50}, .cruise_speed = 1.0, .arrival = 1.0};
  e.obstacles = {encounters::wall({10, -12, 50}, {10, 3, 50}), encounters::wall({20, -3, 50}, {20, 12, 50})};
  return e;
}

Avoider trackable_one() {
  Catalog catalog = builtin_avoiders();
  add_planners(catalog);
  return catalog.make("rrt_star+trackable", {}, Rng{1});
}

TEST(RrtStar, AVehicleThatMustTurnArrivesInTheTimeOfTheWay) {
  // 38 m by the tangents at 1 m/s
  const Envelope boat = encounters::of_a_boat();
  const auto sailed = encounters::sail(between_walls(boat), trackable_one(), 48.0);
  EXPECT_LT((sailed.end - Vec2{30, 0}).norm(), 2.0);
  EXPECT_GT(sailed.clearance, 0.2);
  EXPECT_EQ(sailed.infeasible, 0);
}

TEST(RrtStar, AVehicleThatMustTurnDoesNotLoseItsWayToOneThatComes) {
  const Envelope boat = encounters::of_a_boat();
  OwnedSituation e = between_walls(boat);
  e.obstacles.clear();
  e.tracks = {encounters::track(1, {20, 0, 50}, {-1, 0, 0})};
  const auto sailed = encounters::sail(e, trackable_one(), 40.0);
  EXPECT_LT((sailed.end - Vec2{30, 0}).norm(), 2.0);
  EXPECT_GT(sailed.clearance, 0.2);
}

TEST(RrtStar, AVehicleThatMustTurnPlansAnewWhereItComesOnNoMore) {
  const Envelope boat = encounters::of_a_boat();
  OwnedSituation e = between_walls(boat);
  PlannerAtWork<RrtStar> work;
  const auto plan_at = [&](double time) { return work.plan_at(e, time); };
  const auto first = plan_at(0.0);
  EXPECT_EQ(plan_at(9.0), first);  // 0.5 s, half a turn at 0.45 rad/s and 2 s to stop: 9.5 s
  const auto second = plan_at(10.0);
  EXPECT_NE(second, first);
  EXPECT_EQ(plan_at(11.0), second);

  // something else is charted now, on what is left of the path
  e.obstacles.push_back(encounters::buoy(25, 0, 3.0));
  EXPECT_EQ(plan_at(11.9), second);  // not so soon
  EXPECT_NE(plan_at(12.1), second);
}

TEST(RrtStar, AVehicleThatMustTurnKeepsItsPlanWhereThereIsNoOther) {
  const Envelope boat = encounters::of_a_boat();
  OwnedSituation e = between_walls(boat);
  PlannerAtWork<RrtStar> work;
  work.algorithm.params.clearance_m = 1.0;
  const auto first = work.plan_at(e, e.situation.time);

  // set aside, nearer to the wall than a path may lead, it sees nothing of its path
  e.situation.own.position = {10.0, 3.5 + e.situation.own.radius, 50.0};
  (void)work.decide_at(e, 4.8);
  const Command command = work.decide_at(e, 5.0);
  EXPECT_EQ(work.memory.planned_s, 5.0);
  EXPECT_EQ(work.memory.plan, first);
  EXPECT_GT(command.velocity.norm(), 0.1);
}

TEST(RrtStar, ReadsWaypointsFromFlatParameters) {
  const ParamValues params{{"segment_time_s", 28.0},    {"waypoints", 2.0},
                           {"waypoints[0].n_m", 0.0},   {"waypoints[0].e_m", 10.0},
                           {"waypoints[1].n_m", -10.0}, {"waypoints[1].e_m", 10.0}};
  OwnedSituation e = four_obstacle_encounter();
  Drawing drawing;
  (void)avoider(params).decide(e, &drawing);
  EXPECT_EQ(drawing.strokes()[0].points, (std::vector<Vec3>{{0, 0, 7}, {0, 10, 7}, {-10, 10, 7}}));
}

}  // namespace
}  // namespace fairway
