// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/blend/blend.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/testing/passage.hpp"

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

TEST(Finds, EachIsKeptOnceAndOutlivesWhereItWasSeen) {
  Finds finds;
  {
    const std::vector<Vec3> vertices{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const std::vector<Obstacle> seen{
        disc(1, 2, 3, false),
        disc(1, 2, 3, true),
        {.kind = Obstacle::Kind::polygon, .vertices = vertices, .charted = false}};
    EXPECT_TRUE(finds.add(seen));
    EXPECT_FALSE(finds.add(seen));
  }
  const Finds copy = finds;
  const std::vector<Obstacle> charted = copy.charted();
  ASSERT_EQ(charted.size(), 2U);
  EXPECT_TRUE(charted[1].charted);
  EXPECT_NEAR(nearest_point(charted[1], {-3, 1, 0}).distance, 3.0, 1e-15);
}

}  // namespace
}  // namespace fairway
