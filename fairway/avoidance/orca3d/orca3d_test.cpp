// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/orca3d/orca3d.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

using encounters::Encounter;

Command decide(const Situation& s, const Orca3d::Params& params = {}) {
  Rng rng{1};
  Context context{rng};
  NoMemory memory;
  return Orca3d{params}.decide(s, memory, context);
}

TEST(Orca3d, GoesWhereItWasGoingWhenNobodyIsInRange) {
  const Command expected{.velocity = {1.0, 0.0, 0.0}, .mode = Mode::cruise};
  EXPECT_EQ(decide(encounters::open_water()), expected);
  EXPECT_EQ(decide(encounters::head_on(20.5)), expected);
}

TEST(Orca3d, SomebodyInRangeIsAvoidanceEvenIfTheCourseIsClear) {
  Encounter e = encounters::open_water();
  e.tracks = {encounters::track(1, {-19.0, 0.0, 50.0}, {-1.0, 0.0, 0.0})};
  const Command command = decide(e);
  EXPECT_EQ(command.velocity, Vec3(1.0, 0.0, 0.0));
  EXPECT_EQ(command.mode, Mode::avoid);
  EXPECT_TRUE(command.astern);
}

TEST(Orca3d, HeadOnTakesHalfOfTheLeastChangeToStarboard) {
  // p = 8 north, v = 2 north, R = 2: sin 1/4, cos sqrt(15)/4. The change is u = sin * 2 along the normal
  // (-sin, cos, 0); half of it is 1/4, and the preferred velocity (1, 0, 0) lies 1/4 beyond the plane
  const Command command = decide(encounters::head_on(8.0));
  const Vec3 normal{-0.25, std::sqrt(15.0) / 4.0, 0.0};
  EXPECT_LT((command.velocity - (Vec3(1.0, 0.0, 0.0) + 0.25 * normal)).norm(), 1e-14);
  EXPECT_EQ(command.mode, Mode::avoid);
}

TEST(Orca3d, FullResponsibilityTakesAllOfTheChange) {
  const Command command = decide(encounters::head_on(8.0), {.responsibility_ratio = 1.0});
  const Vec3 normal{-0.25, std::sqrt(15.0) / 4.0, 0.0};
  EXPECT_LT((command.velocity - (Vec3(1.0, 0.0, 0.0) + 0.5 * normal)).norm(), 1e-14);
}

TEST(Orca3d, WhatDoesNotReactLeavesAllOfTheChangeToUs) {
  Encounter e = encounters::head_on(8.0);
  const Command shared = decide(e);
  e.tracks[0].reacts = false;
  EXPECT_EQ(decide(e), decide(encounters::head_on(8.0), {.responsibility_ratio = 1.0}));
  EXPECT_EQ(decide(e), decide(e, {.responsibility_ratio = 0.0}));
  EXPECT_GT((decide(e).velocity - shared.velocity).norm(), 0.2);
}

TEST(Orca3d, MeetingBeyondTheHorizonChangesNothing) {
  // 8 m at 2 m/s with R = 2: they touch after 3 s
  EXPECT_EQ(decide(encounters::head_on(8.0), {.time_horizon_s = 2.9}).velocity, Vec3(1.0, 0.0, 0.0));
  EXPECT_NE(decide(encounters::head_on(8.0), {.time_horizon_s = 3.1}).velocity, Vec3(1.0, 0.0, 0.0));
}

TEST(Orca3d, WhoOverlapsPartsWithinOnePeriodIfSpeedAllows) {
  // 1.9 m apart at rest, R = 2, period 0.1: apart at 1 m/s, half of it each
  Encounter e = encounters::open_water();
  e.situation.own.velocity = Vec3::Zero();
  e.situation.goal.velocity = Vec3::Zero();
  e.tracks = {encounters::track(1, {1.9, 0.0, 50.0}, Vec3::Zero())};
  const Command command = decide(e);
  EXPECT_LT((command.velocity - Vec3(-0.5, 0.0, 0.0)).norm(), 1e-12);
  EXPECT_EQ(command.mode, Mode::avoid);
}

TEST(Orca3d, ReportsAnInfeasibleProgramAndTakesTheLeastViolation) {
  // squeezed equally from north and south: neither can be kept, so stay between; up and down is free
  Encounter e = encounters::open_water();
  e.situation.own.velocity = Vec3::Zero();
  e.situation.goal.velocity = Vec3{0.3, 0.0, 0.5};
  e.tracks = {encounters::track(1, {1.0, 0.0, 50.0}, Vec3::Zero()),
              encounters::track(2, {-1.0, 0.0, 50.0}, Vec3::Zero())};
  const Command command = decide(e);
  EXPECT_EQ(command.mode, Mode::infeasible);
  EXPECT_LT((command.velocity - Vec3(0.0, 0.0, 0.5)).norm(), 1e-12);
}

TEST(Orca3d, TwoAtTheSamePlacePartAlongOneLineByTheirIds) {
  Encounter e = encounters::open_water();
  e.situation.own.velocity = Vec3::Zero();
  e.situation.goal.velocity = Vec3::Zero();
  e.tracks = {encounters::track(1, e.situation.own.position, Vec3::Zero())};
  const Command first = decide(e);
  e.situation.own.id = VehicleId{1};
  e.tracks[0].id = TrackId{0};
  const Command second = decide(e);
  EXPECT_GT(first.velocity.norm(), 1.0);
  EXPECT_EQ(first.velocity, -second.velocity);
}

TEST(Orca3d, LooksAtTheNearestWhenThereAreTooMany) {
  Encounter e = encounters::head_on(8.0);
  e.tracks.push_back(encounters::track(2, {0.0, 9.0, 50.0}, {0.0, -2.0, 0.0}));
  EXPECT_EQ(decide(e, {.max_neighbours_count = 1}), decide(encounters::head_on(8.0)));
  EXPECT_EQ(decide(e, {.max_neighbours_count = 0}).mode, Mode::cruise);
}

TEST(Orca3d, ASphereThatDoesNotMoveIsANeighbourThatDoesNotCooperate) {
  Encounter obstacle = encounters::open_water();
  obstacle.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {8.0, 0.5, 50.0}, .radius = 2.0}};
  Encounter track = encounters::open_water();
  track.tracks = {encounters::track(1, {8.0, 0.5, 50.0}, Vec3::Zero(), 2.0)};
  const Command command = decide(obstacle, {.obstacle_time_horizon_s = 10.0});
  EXPECT_EQ(command, decide(track, {.time_horizon_s = 10.0, .responsibility_ratio = 1.0}));
  EXPECT_EQ(command.mode, Mode::avoid);
  EXPECT_GT(std::fabs(command.velocity.y()), 0.1);
}

TEST(Orca3d, AWallIsAvoidedAtItsNearestPoint) {
  // 3 m ahead, own radius 1, horizon 5 s: no faster than 2 / 5 m/s towards it
  Encounter e = encounters::open_water();
  e.situation.own.velocity = {0.3, 0.0, 0.0};
  e.obstacles = {{.kind = Obstacle::Kind::segment, .from = {3.0, -50.0, 50.0}, .to = {3.0, 50.0, 50.0}}};
  EXPECT_LT((decide(e).velocity - Vec3(0.4, 0.0, 0.0)).norm(), 1e-12);
}

TEST(Orca3d, FromInsideASolidTheWayIsOutThroughTheNearestSide) {
  const std::array<Vec3, 4> square{Vec3{-1, -5, 0}, Vec3{9, -5, 0}, Vec3{9, 5, 0}, Vec3{-1, 5, 0}};
  Encounter e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::polygon, .vertices = square}};
  const Command command = decide(e);
  EXPECT_EQ(command.mode, Mode::infeasible);  // 2 m in 0.1 s
  EXPECT_LT((command.velocity - Vec3(-1.5, 0.0, 0.0)).norm(), 1e-9);
}

TEST(Orca3d, WithoutASpeedLimitAvoidanceStillAnswers) {
  Encounter e = encounters::head_on(8.0);
  const Vec3 limited = decide(e).velocity;
  e.situation.limits.max_speed = Limits::none;
  EXPECT_LT((decide(e).velocity - limited).norm(), 1e-11);
}

TEST(Orca3d, TheOrderOfTracksChangesNothingThatMatters) {
  double largest = 0.0;
  int infeasible = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const Rng rng = Rng{1}.stream("order", i);
    Encounter e = i % 2 == 0 ? encounters::congested(static_cast<int>(i % 30), rng)
                             : encounters::crowd(static_cast<int>(i % 30), rng);
    const Command command = decide(e);
    infeasible += command.mode == Mode::infeasible ? 1 : 0;
    Rng draws = rng.stream("shuffle");
    for (std::size_t k = e.tracks.size(); k > 1; --k) std::swap(e.tracks[k - 1], e.tracks[draws.index(k)]);
    const Command shuffled = decide(e);
    EXPECT_EQ(command.mode, shuffled.mode);
    largest = std::fmax(largest, (command.velocity - shuffled.velocity).norm());
  }
  EXPECT_LT(largest, 3e-8 * 1.5);  // measured 2e-12
  EXPECT_GT(infeasible, 500);
}

TEST(Orca3d, WorksInRawNorthings) {
  // positions are good to 1e-9 m at 4.6e6 m; in a congested scene that is magnified
  double crowd = 0.0, congested = 0.0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Rng rng = Rng{3}.stream("northings", i);
    const auto change = [](const Encounter& here) {
      return (decide(here).velocity - decide(encounters::shifted(here, {4.6e6, 5e5, 0.0})).velocity).norm();
    };
    crowd = std::fmax(crowd, change(encounters::crowd(7, rng)));
    congested = std::fmax(congested, change(encounters::congested(7, rng)));
  }
  EXPECT_LT(crowd, 1e-8);      // measured 1e-9
  EXPECT_LT(congested, 1e-6);  // measured 3e-8
}

// Both of a pair keep to their half-spaces, so at no time within the horizon do they touch: the law that
// ORCA is named after. Followed exactly, over random geometries in space.
TEST(Orca3d, TwoWhoBothUseItNeverTouch) {
  double closest = 1e9;
  int started = 0, arrived = 0;
  for (std::uint64_t run = 0; run < 300; ++run) {
    Rng rng = Rng{2}.stream("pair", run);
    std::array<Encounter, 2> agents;
    const double radius = rng.uniform(0.5, 2.0);
    const Vec3 middle{0.0, 0.0, 50.0};
    for (std::uint32_t k = 0; k < 2; ++k) {
      agents[k] = encounters::open_water();
      Situation& s = agents[k].situation;
      const Vec3 out = rng.uniform(6.0, 12.0) * (k == 0 ? encounters::direction(rng) : Vec3::UnitX().eval());
      s.own = {.id = VehicleId{k}, .position = middle + out, .velocity = Vec3::Zero(), .radius = radius};
      s.goal = {.position = middle - out, .cruise_speed = rng.uniform(0.3, 1.5)};
    }
    // starts, and with them goals, that leave each other less than 1 m may only be crept up to
    const Vec3 apart = agents[0].situation.own.position - agents[1].situation.own.position;
    if (apart.norm() < 2.0 * radius + 1.0) continue;
    ++started;
    for (int step = 0; step < 1200; ++step) {
      for (std::uint32_t k = 0; k < 2; ++k) {
        const Ownship& other = agents[1 - k].situation.own;
        agents[k].tracks = {encounters::track(1 - k, other.position, other.velocity, radius)};
      }
      const std::array<Command, 2> commands{decide(agents[0]), decide(agents[1])};
      const Vec3 p = agents[1].situation.own.position - agents[0].situation.own.position;
      const Vec3 v = commands[1].velocity - commands[0].velocity;
      const double t = v.squaredNorm() > 0.0 ? std::clamp(-p.dot(v) / v.squaredNorm(), 0.0, 0.1) : 0.0;
      closest = std::fmin(closest, (p + t * v).norm() - 2.0 * radius);
      for (std::uint32_t k = 0; k < 2; ++k) {
        agents[k].situation.own.velocity = commands[k].velocity;
        agents[k].situation.own.position += 0.1 * commands[k].velocity;
      }
    }
    const auto left = [&](std::uint32_t k) {
      return (agents[k].situation.goal.position - agents[k].situation.own.position).norm();
    };
    arrived += left(0) < 0.1 && left(1) < 0.1 ? 1 : 0;
  }
  EXPECT_GT(closest, -1e-9);  // measured -4e-16
  EXPECT_EQ(arrived, started);
  EXPECT_GT(started, 250);
}

}  // namespace
}  // namespace fairway
