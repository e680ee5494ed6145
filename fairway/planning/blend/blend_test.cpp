// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/blend/blend.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/testing/boat.hpp"
#include "fairway/avoidance/testing/passage.hpp"
#include "fairway/avoidance/trackable/trackable.hpp"
#include "fairway/planning/testing/planner_at_work.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;
using encounters::Passage;

Obstacle disc(double n, double e, double radius, bool charted) {
  return {.kind = Obstacle::Kind::sphere, .position = {n, e, 0}, .radius = radius, .charted = charted};
}

/// Own sphere of 3.2 m, 40 m south of its goal; what is on no chart and what moves is seen from 5 m.
OwnedSituation sea(std::vector<Obstacle> obstacles, std::vector<Track> movers = {}) {
  OwnedSituation e;
  e.situation = {.period = 0.1,
                 .own = {.id = VehicleId{0}, .radius = 3.2},
                 .goal = {.position = {40, 0, 0}, .cruise_speed = 0.5},
                 .limits = {.max_speed = 0.5, .max_acceleration = 0.3}};
  e.obstacles = std::move(obstacles);
  e.tracks = std::move(movers);
  return e;
}

Passage sail(const Avoider& avoider, const OwnedSituation& e, double sight = 5.0) {
  return passage(e, avoider, {.duration = 400.0, .lag = 1.0, .sight = sight});
}

Avoider blend(Blend::Params params = {}) { return Avoider{Blend{params}, Rng{1}}; }

TEST(Blend, FollowsItsPlanWhereNothingIsUnknown) {
  const Passage voyage = sail(blend(), sea({disc(20, 1, 3, true)}));
  ASSERT_TRUE(voyage.arrival);
  EXPECT_LT(*voyage.arrival, 150.0);
  EXPECT_GT(voyage.clearance, 0.0);
}

TEST(Blend, PassesWhatNoChartShows) {
  const Passage voyage = sail(blend(), sea({disc(12, 1, 2, true), disc(26, -1, 2, false)}));
  ASSERT_TRUE(voyage.arrival);
  EXPECT_GT(voyage.clearance, 0.4);  // the filter keeps 0.5 m, less what the lag makes of it
  EXPECT_LT(voyage.length, 60.0);
}

TEST(Blend, WithoutReplanningItGoesRoundAndComesBack) {
  Blend::Params params;
  params.replan = false;
  const Passage voyage = sail(blend(params), sea({disc(20, 0.5, 2, false)}));
  ASSERT_TRUE(voyage.arrival);
  EXPECT_GT(voyage.avoiding, 0);
  EXPECT_GT(voyage.clearance, 0.4);
}

TEST(Blend, PlansAnewWhereThatIsQuicker) {
  // a long wall across the way, seen early: round its near end
  Obstacle wall = encounters::wall({20, -4, 0}, {20, 30, 0});
  wall.charted = false;
  const Passage anew = sail(blend(), sea({wall}), 10.0);
  ASSERT_TRUE(anew.arrival);
  EXPECT_GT(anew.clearance, 0.4);
  EXPECT_LT(anew.length, 55.0);
}

TEST(Blend, LetsAMoverPass) {
  Track crossing{.id = TrackId{9}, .position = {20, -18, 0}, .velocity = {0, 0.25, 0}, .radius = 1.5};
  crossing.reacts = false;
  Track ahead{.id = TrackId{10}, .position = {36, 0.5, 0}, .velocity = {-0.15, 0, 0}, .radius = 1.0};
  ahead.reacts = false;
  const Passage voyage = sail(blend(), sea({}, {crossing, ahead}));
  ASSERT_TRUE(voyage.arrival);
  EXPECT_GT(voyage.clearance, 0.3);
}

TEST(Blend, WhatRestsBesideItsWayOrGoesAlongDoesNotHoldItUp) {
  for (const double gap : {0.7, 1.0, 2.0, 3.0, 4.0}) {  // the filter keeps 0.5 m
    const Vec3 beside{0, 3.2 + 1.0 + gap, 0};
    const Track resting{.id = TrackId{9}, .position = Vec3{20, 0, 0} + beside, .radius = 1.0};
    const Track abreast{.id = TrackId{9}, .position = beside, .velocity = {0.25, 0, 0}, .radius = 1.0};
    for (const Track& other : {resting, abreast}) {
      const Passage voyage = sail(blend(), sea({}, {other}));
      ASSERT_TRUE(voyage.arrival) << gap;
      EXPECT_LT(*voyage.arrival, 220.0) << gap;
      EXPECT_GT(voyage.clearance, 0.4) << gap;
    }
  }
}

TEST(Blend, SaysWhyItHasNoPlanAndGoesOnWithoutOne) {
  const Command command = blend().decide(sea({disc(40, 0, 2, true)}));  // over the goal
  EXPECT_EQ(command.note, "goal is inside an inflated obstacle");
  EXPECT_GT(command.velocity.x(), 0.0);
}

/// A boat of 1 m/s under `+trackable`, 40 m south of its goal, among obstacles no chart shows but one.
OwnedSituation boat_among(const Envelope& can, bool charted) {
  OwnedSituation e = encounters::under_way(can);
  e.situation.period = 0.2;
  e.situation.goal = {.position = {40, 0, 50}, .cruise_speed = 1.0, .arrival = 1.0};
  e.obstacles = {encounters::wall({12, -12, 50}, {12, 3, 50}), encounters::wall({24, -3, 50}, {24, 12, 50})};
  for (Obstacle& wall : e.obstacles) wall.charted = charted;
  return e;
}

TEST(Blend, AVehicleThatMustTurnIsNeitherSlowNorAstray) {
  // 46 m by the tangents; what is on no chart is seen from the start
  const Envelope boat = encounters::of_a_boat();
  for (const bool charted : {true, false}) {
    const Avoider avoider{Trackable{{}}, blend()};
    const auto sailed = encounters::sail(boat_among(boat, charted), avoider, 58.0);
    EXPECT_LT((sailed.end - Vec2{40, 0}).norm(), 2.0) << charted;
    EXPECT_GT(sailed.clearance, 0.2) << charted;
  }
}

TEST(Blend, AVehicleThatMustTurnPlansRoundWhatItFindsOnItsPath) {
  const Envelope boat = encounters::of_a_boat();
  OwnedSituation e = boat_among(boat, true);
  PlannerAtWork<Blend> work;
  const auto plan_at = [&](double time) { return work.plan_at(e, time); };
  const auto first = plan_at(0.0);
  e.obstacles.push_back(encounters::buoy(34, 0, 2.0));
  e.obstacles.back().charted = false;
  EXPECT_EQ(plan_at(1.9), first);  // at most every 2 s
  EXPECT_EQ(work.memory.stage, Blend::Stage::going_round);
  const auto second = plan_at(2.1);
  EXPECT_NE(second, first);
  EXPECT_EQ(work.memory.stage, Blend::Stage::following);
  e.obstacles.pop_back();  // out of sight, and remembered
  EXPECT_EQ(plan_at(5.0), second);
}

TEST(Blend, AVehicleThatMustTurnPlansForAGoalThatMovesNowAndThen) {
  const Envelope boat = encounters::of_a_boat();
  OwnedSituation e = boat_among(boat, true);
  PlannerAtWork<Blend> work;
  int plans = 0;
  for (int i = 0; i <= 20; ++i) {  // 4.1 s
    e.situation.goal.position.y() = 0.01 * i;
    const auto before = work.memory.plan;
    plans += work.plan_at(e, 0.205 * i) != before ? 1 : 0;
  }
  EXPECT_EQ(plans, 3);  // at 0, 2.05 and 4.1 s
}

TEST(Finds, EachIsKeptOnceAndOutlivesWhereItWasSeen) {
  Finds finds;
  {
    const std::vector<Vec3> vertices{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const std::vector<Obstacle> seen{
        disc(1, 2, 3, false),
        disc(1, 2, 3, true),
        {.kind = Obstacle::Kind::polygon, .vertices = vertices, .charted = false}};
    EXPECT_TRUE(finds.add(seen, Vec3::Zero()));
    EXPECT_FALSE(finds.add(seen, Vec3::Zero()));
  }
  const Finds copy = finds;
  const std::vector<Obstacle> charted = copy.charted();
  ASSERT_EQ(charted.size(), 2U);
  EXPECT_TRUE(charted[1].charted);
  EXPECT_NEAR(nearest_point(charted[1], {-3, 1, 0}).distance, 3.0, 1e-15);
}

TEST(Finds, WhatIsSeenWithNoiseIsOneFind) {
  Finds finds;
  Rng rng{3};
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Obstacle> seen{
        disc(10.0 + rng.uniform(-0.001, 0.001), rng.uniform(-0.001, 0.001), 1.0, false)};
    EXPECT_EQ(finds.add(seen, Vec3::Zero()), i == 0);
  }
  EXPECT_EQ(finds.charted().size(), 1U);
}

TEST(Finds, NoMoreAreKeptThanTheNearest) {
  Finds finds;
  for (int i = 1; i <= 400; ++i) (void)finds.add(std::vector{disc(i, 0.0, 0.1, false)}, {400.0, 0.0, 0.0});
  const std::vector<Obstacle> kept = finds.charted();
  ASSERT_EQ(kept.size(), Finds::capacity);
  for (const Obstacle& find : kept)
    EXPECT_GT(find.position.x(), 400.0 - static_cast<double>(Finds::capacity));
  EXPECT_FALSE(finds.add(std::vector{disc(1.0, 0.0, 0.1, false)}, {400.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace fairway
