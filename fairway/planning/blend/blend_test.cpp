// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/blend/blend.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

Obstacle disc(double n, double e, double radius, bool charted) {
  return {.kind = Obstacle::Kind::sphere, .position = {n, e, 0}, .radius = radius, .charted = charted};
}

/// What came of a voyage of a vehicle that takes up velocities with a lag of one second.
struct Voyage {
  double clearance{std::numeric_limits<double>::infinity()};  ///< of the sphere of 3.2 m [m]
  std::optional<double> arrival;                              ///< within 1 m of the goal [s]
  double length{};
  int going_round{};  ///< decisions that avoided
  Ownship own;
};

struct Sea {
  std::vector<Obstacle> obstacles;
  std::vector<Track> movers;  ///< as they are at time 0
  double range = 5.0;         ///< at which the uncharted is seen, from the sphere
  Vec3 goal{40, 0, 0};
};

Voyage sail(Avoider avoider, const Sea& sea, double duration = 400.0) {
  constexpr double h = 0.1, lag = 1.0;
  Voyage voyage{.own = {.id = VehicleId{0}, .radius = 3.2}};
  Ownship& own = voyage.own;
  for (int tick = 0; tick * h < duration && !voyage.arrival; ++tick) {
    const double time = tick * h;
    std::vector<Obstacle> seen;
    for (const Obstacle& o : sea.obstacles) {
      const double gap = nearest_point(o, own.position).distance - own.radius;
      voyage.clearance = std::fmin(voyage.clearance, gap);
      if (o.charted || gap <= sea.range) seen.push_back(o);
    }
    std::vector<Track> tracks;
    for (Track track : sea.movers) {
      track.position += time * track.velocity;
      const double gap = (track.position - own.position).norm() - track.radius - own.radius;
      voyage.clearance = std::fmin(voyage.clearance, gap);
      if (gap <= sea.range) tracks.push_back(track);
    }
    const Command command = avoider.decide({.time = time,
                                            .period = h,
                                            .own = own,
                                            .goal = {.position = sea.goal, .cruise_speed = 0.5},
                                            .limits = {.max_speed = 0.5, .max_acceleration = 0.3},
                                            .tracks = tracks,
                                            .obstacles = seen});
    voyage.going_round += command.mode == Mode::avoid ? 1 : 0;
    own.velocity += h / lag * (command.velocity - own.velocity);
    own.position += h * own.velocity;
    voyage.length += h * own.velocity.norm();
    if ((own.position - sea.goal).norm() < 1.0) voyage.arrival = time;
  }
  return voyage;
}

Avoider blend(Blend::Params params = {}) { return Avoider{Blend{params}, Rng{1}}; }

TEST(Blend, FollowsItsPlanWhereNothingIsUnknown) {
  const Voyage voyage = sail(blend(), {.obstacles = {disc(20, 1, 3, true)}});
  ASSERT_TRUE(voyage.arrival);
  EXPECT_LT(*voyage.arrival, 150.0);
  EXPECT_GT(voyage.clearance, 0.0);
}

TEST(Blend, PassesWhatNoChartShows) {
  const Sea sea{.obstacles = {disc(12, 1, 2, true), disc(26, -1, 2, false)}};
  const Voyage voyage = sail(blend(), sea);
  ASSERT_TRUE(voyage.arrival);
  EXPECT_GT(voyage.clearance, 0.4);  // the filter keeps 0.5 m, less what the lag makes of it
  EXPECT_LT(voyage.length, 60.0);
}

TEST(Blend, WithoutReplanningItGoesRoundAndComesBack) {
  const Sea sea{.obstacles = {disc(20, 0.5, 2, false)}};
  Blend::Params params;
  params.replan = false;
  const Voyage voyage = sail(blend(params), sea);
  ASSERT_TRUE(voyage.arrival);
  EXPECT_GT(voyage.going_round, 0);
  EXPECT_GT(voyage.clearance, 0.4);
}

TEST(Blend, PlansAnewWhereThatIsQuicker) {
  // a long wall across the way, seen early: round its near end
  const Sea sea{.obstacles = {{.kind = Obstacle::Kind::segment,
                               .from = {20, -4, 0},
                               .to = {20, 30, 0},
                               .charted = false}},
                .range = 10.0};
  const Voyage anew = sail(blend(), sea);
  ASSERT_TRUE(anew.arrival);
  EXPECT_GT(anew.clearance, 0.4);
  EXPECT_LT(anew.length, 55.0);
}

TEST(Blend, LetsAMoverPass) {
  Track crossing{.id = TrackId{9}, .position = {20, -18, 0}, .velocity = {0, 0.25, 0}, .radius = 1.5};
  crossing.reacts = false;
  Track ahead{.id = TrackId{10}, .position = {36, 0.5, 0}, .velocity = {-0.15, 0, 0}, .radius = 1.0};
  ahead.reacts = false;
  const Voyage voyage = sail(blend(), {.movers = {crossing, ahead}});
  ASSERT_TRUE(voyage.arrival);
  EXPECT_GT(voyage.clearance, 0.3);
}

TEST(Blend, WhatRestsBesideItsWayOrGoesAlongDoesNotHoldItUp) {
  for (const double gap : {0.7, 1.0, 2.0, 3.0, 4.0}) {  // the filter keeps 0.5 m
    const Vec3 beside{0, 3.2 + 1.0 + gap, 0};
    const Track resting{.id = TrackId{9}, .position = Vec3{20, 0, 0} + beside, .radius = 1.0};
    const Track abreast{.id = TrackId{9}, .position = beside, .velocity = {0.25, 0, 0}, .radius = 1.0};
    for (const Track& other : {resting, abreast}) {
      const Voyage voyage = sail(blend(), {.movers = {other}});
      ASSERT_TRUE(voyage.arrival) << gap;
      EXPECT_LT(*voyage.arrival, 220.0) << gap;
      EXPECT_GT(voyage.clearance, 0.4) << gap;
    }
  }
}

TEST(Blend, SaysWhyItHasNoPlanAndGoesOnWithoutOne) {
  Avoider avoider = blend();
  const std::vector<Obstacle> obstacles{disc(40, 0, 2, true)};  // over the goal
  const Command command = avoider.decide({.time = 0,
                                          .period = 0.1,
                                          .own = {.id = VehicleId{0}, .radius = 3.2},
                                          .goal = {.position = {40, 0, 0}, .cruise_speed = 0.5},
                                          .limits = {.max_speed = 0.5},
                                          .obstacles = obstacles});
  EXPECT_EQ(command.note, "goal is inside an inflated obstacle");
  EXPECT_GT(command.velocity.x(), 0.0);
}

TEST(Blend, ACopyGoesOnAlike) {
  const Sea sea{.obstacles = {disc(12, 1, 2, true), disc(26, -1, 2, false)}};
  const Avoider one = blend();
  const Voyage a = sail(one, sea), b = sail(one, sea);
  EXPECT_EQ(a.own.position, b.own.position);
  EXPECT_EQ(a.arrival, b.arrival);
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
