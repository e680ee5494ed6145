// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/orca3d/orca3d.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

using encounters::decide;
using encounters::OwnedSituation;

TEST(Orca3d, MeetingBeyondTheHorizonChangesNothing) {
  // 8 m at 2 m/s with R = 2: they touch after 3 s
  EXPECT_EQ(decide<Orca3d>(encounters::head_on(8.0), {.time_horizon_s = 2.9}).velocity, Vec3(1.0, 0.0, 0.0));
  EXPECT_NE(decide<Orca3d>(encounters::head_on(8.0), {.time_horizon_s = 3.1}).velocity, Vec3(1.0, 0.0, 0.0));
}

TEST(Orca3d, WhoOverlapsPartsWithinOnePeriodIfSpeedAllows) {
  // 1.9 m apart at rest, R = 2, period 0.1: apart at 1 m/s, half of it each
  OwnedSituation e = encounters::open_water();
  e.situation.own.velocity = Vec3::Zero();
  e.situation.goal.velocity = Vec3::Zero();
  e.tracks = {encounters::track(1, {1.9, 0.0, 50.0}, Vec3::Zero())};
  const Command command = decide<Orca3d>(e);
  EXPECT_LT((command.velocity - Vec3(-0.5, 0.0, 0.0)).norm(), 1e-12);
  EXPECT_EQ(command.mode, Mode::avoid);
}

TEST(Orca3d, ReportsAnInfeasibleProgramAndTakesTheLeastViolation) {
  // squeezed equally from north and south: neither can be kept, so stay between; up and down is free
  OwnedSituation e = encounters::open_water();
  e.situation.own.velocity = Vec3::Zero();
  e.situation.goal.velocity = Vec3{0.3, 0.0, 0.5};
  e.tracks = {encounters::track(1, {1.0, 0.0, 50.0}, Vec3::Zero()),
              encounters::track(2, {-1.0, 0.0, 50.0}, Vec3::Zero())};
  const Command command = decide<Orca3d>(e);
  EXPECT_EQ(command.mode, Mode::infeasible);
  EXPECT_LT((command.velocity - Vec3(0.0, 0.0, 0.5)).norm(), 1e-12);
}

TEST(Orca3d, ASphereThatDoesNotMoveIsANeighbourThatDoesNotCooperate) {
  OwnedSituation obstacle = encounters::open_water();
  obstacle.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {8.0, 0.5, 50.0}, .radius = 2.0}};
  OwnedSituation track = encounters::open_water();
  track.tracks = {encounters::track(1, {8.0, 0.5, 50.0}, Vec3::Zero(), 2.0)};
  const Command command = decide<Orca3d>(obstacle, {.obstacle_time_horizon_s = 10.0});
  EXPECT_EQ(command, decide<Orca3d>(track, {.time_horizon_s = 10.0, .responsibility_ratio = 1.0}));
  EXPECT_EQ(command.mode, Mode::avoid);
  EXPECT_GT(std::fabs(command.velocity.y()), 0.1);
}

TEST(Orca3d, AWallIsAvoidedAtItsNearestPoint) {
  // 3 m ahead, own radius 1, horizon 5 s: no faster than 2 / 5 m/s towards it
  OwnedSituation e = encounters::open_water();
  e.situation.own.velocity = {0.3, 0.0, 0.0};
  e.obstacles = {{.kind = Obstacle::Kind::segment, .from = {3.0, -50.0, 50.0}, .to = {3.0, 50.0, 50.0}}};
  EXPECT_LT((decide<Orca3d>(e).velocity - Vec3(0.4, 0.0, 0.0)).norm(), 1e-12);
}

TEST(Orca3d, WithoutASpeedLimitAvoidanceStillAnswers) {
  OwnedSituation e = encounters::head_on(8.0);
  const Vec3 limited = decide<Orca3d>(e).velocity;
  e.situation.limits.max_speed = Limits::none;
  EXPECT_LT((decide<Orca3d>(e).velocity - limited).norm(), 1e-11);
}

TEST(Orca3d, WorksInRawNorthings) {
  // positions are good to 1e-9 m at 4.6e6 m; in a congested scene that is magnified
  double crowd = 0.0, congested = 0.0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Rng rng = Rng{3}.stream("northings", i);
    const auto change = [](const OwnedSituation& here) {
      return (decide<Orca3d>(here).velocity -
              decide<Orca3d>(encounters::shifted(here, {4.6e6, 5e5, 0.0})).velocity)
          .norm();
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
    std::array<OwnedSituation, 2> agents;
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
      const std::array<Command, 2> commands{decide<Orca3d>(agents[0]), decide<Orca3d>(agents[1])};
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

TEST(Orca3d, OfTooManyObstaclesTheNearestCount) {
  // more pebbles astern than there is room for half-spaces, listed before a wall 3 m ahead
  OwnedSituation e = encounters::open_water();
  for (int i = 0; i < 1100; ++i) e.obstacles.push_back(encounters::sphere(-8.0, 0.001 * i, 0.1, 50.0));
  e.obstacles.push_back(encounters::wall({3.0, -50.0, 50.0}, {3.0, 50.0, 50.0}));
  const Command command = decide<Orca3d>(e);
  EXPECT_LT(command.velocity.x(), 0.9);
  EXPECT_NE(command.note, "");
}

}  // namespace
}  // namespace fairway
