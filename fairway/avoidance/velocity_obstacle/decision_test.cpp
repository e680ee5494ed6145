// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/decision.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "fairway/avoidance/drawing.hpp"
#include "fairway/avoidance/testing/boat.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway::velocity_obstacle {
namespace {

using encounters::OwnedSituation;

constexpr std::array everyone{Responsibility::all, Responsibility::shared, Responsibility::by_side};

/// Without anyone looking.
Command decide(const Situation& s, const Params& params, Responsibility responsibility,
               Sketch* sketch = nullptr) {
  Rng rng{1};
  return decide(s, params, responsibility, Context{rng, sketch});
}

Command vo(const Situation& s, const Params& params = {}) { return decide(s, params, Responsibility::all); }

/// A random scene in the plane; with limits of acceleration, and of turning, in every other one.
OwnedSituation any_scene(std::uint64_t i) {
  const Rng rng = Rng{11}.stream("scene", i);
  const int count = static_cast<int>(i / 2 % 12);
  OwnedSituation e = i % 2 == 0 ? encounters::crowd(count, rng) : encounters::congested(count, rng);
  e.situation.own.velocity.z() = 0.0;
  e.situation.goal.position.z() = e.situation.own.position.z();
  for (Track& t : e.tracks) t.reacts = number(t.id) % 3 != 0;
  if (i % 4 < 2) e.situation.limits.max_acceleration = 0.5;
  if (i % 8 < 4) e.situation.limits.max_turn_rate = 0.6;
  return e.sorted();
}

TEST(VelocityObstacleDecision, WhatDoesNotReactIsAvoidedAloneByAll) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    OwnedSituation e = any_scene(i);
    for (Track& t : e.tracks) t.reacts = false;
    const Command expected = vo(e);
    EXPECT_EQ(decide(e, {}, Responsibility::shared), expected);
    EXPECT_EQ(decide(e, {}, Responsibility::by_side), expected);
  }
}

TEST(VelocityObstacleDecision, TurnedSceneAndMirroredSceneHaveTheirAnswers) {
  double turned = 0.0, mirrored = 0.0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const OwnedSituation e = any_scene(i);
    for (const Responsibility r : everyone) {
      const Vec3 here = decide(e, {}, r).velocity;
      const Vec3 there = decide(encounters::turned(e, 2.0), {}, r).velocity;
      turned = std::fmax(turned, (there - Eigen::AngleAxisd(2.0, Vec3::UnitZ()) * here).norm());

      const Params unbiased{.starboard_bias_ratio = 0.0};
      const Vec3 right = decide(e, unbiased, r).velocity;
      const Vec3 left = decide(encounters::mirrored(e), unbiased, r).velocity;
      mirrored = std::fmax(mirrored, (left - Vec3(right.x(), -right.y(), 0.0)).norm());
    }
  }
  EXPECT_LT(turned, 1e-9);
  EXPECT_LT(mirrored, 1e-9);
}

TEST(VelocityObstacleDecision, WhoOverlapsPartsWithinOneInterval) {
  // 1.5 m apart, R = 2: 0.5 m/s back, of which each does half in RVO
  OwnedSituation e = encounters::open_water();
  e.situation.own.velocity = Vec3::Zero();
  e.situation.goal.velocity = Vec3::Zero();
  e.tracks = {encounters::track(1, {1.5, 0.0, 50.0}, Vec3::Zero())};
  EXPECT_LT((vo(e).velocity - Vec3(-0.5, 0.0, 0.0)).norm(), 1e-12);
  EXPECT_EQ(vo(e).mode, Mode::avoid);
  const Command half = decide(e, {}, Responsibility::shared);
  EXPECT_LT((half.velocity - Vec3(-0.25, 0.0, 0.0)).norm(), 1e-12);
}

TEST(VelocityObstacleDecision, WhoCannotGetApartInTimeIsInfeasibleAndLeavesAsFastAsItCan) {
  // 2 m apart, R = 3.5: 1.5 m/s back is the limit, but only 0.4 m/s of change are possible
  OwnedSituation e = encounters::open_water();
  e.situation.own.velocity = Vec3::Zero();
  e.situation.limits.max_acceleration = 0.4;
  e.tracks = {encounters::track(1, {2.0, 0.0, 50.0}, Vec3::Zero(), 2.5)};
  const Command command = vo(e);
  EXPECT_EQ(command.mode, Mode::infeasible);
  EXPECT_LT((command.velocity - Vec3(-0.4, 0.0, 0.0)).norm(), 1e-9);
}

TEST(VelocityObstacleDecision, DepthIsNotSeen) {
  OwnedSituation e = encounters::head_on(8.0);
  const Command level = vo(e);
  e.tracks[0].position.z() += 7.0;
  e.tracks[0].velocity.z() = -1.0;
  e.situation.goal.position.z() += 30.0;
  EXPECT_EQ(vo(e).velocity.z(), 0.0);
  EXPECT_LT((vo(e).velocity - level.velocity).norm(), 1e-3);
}

TEST(VelocityObstacleDecision, ASphereThatDoesNotMoveIsATrackThatDoesNotReact) {
  OwnedSituation obstacle = encounters::open_water();
  obstacle.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {8.0, 0.5, 50.0}, .radius = 2.0}};
  OwnedSituation track = encounters::open_water();
  track.tracks = {encounters::track(1, {8.0, 0.5, 50.0}, Vec3::Zero(), 2.0)};
  track.tracks[0].reacts = false;
  const Params params{.time_horizon_s = 10.0, .obstacle_time_horizon_s = 10.0};
  for (const Responsibility r : everyone) {
    EXPECT_EQ(decide(obstacle, params, r), decide(track, params, r));
  }
  EXPECT_GT(vo(obstacle, params).velocity.y(), -1.0);
  EXPECT_LT(vo(obstacle, params).velocity.y(), -0.1);
}

TEST(VelocityObstacleDecision, AWallIsGoneAlongOrRoundNotThrough) {
  // 3 m ahead across the course, own radius 1 m, horizon 5 s: no faster than 2 / 5 m/s towards it, and with
  // its end 1.5 m to starboard the tangent round that end is the nearer choice
  OwnedSituation e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::segment, .from = {3.0, -50.0, 50.0}, .to = {3.0, 50.0, 50.0}}};
  EXPECT_LT((vo(e).velocity - Vec3(0.4, 0.0, 0.0)).norm(), 1e-12);
  e.obstacles[0].to.y() = 0.2;
  const double reach = std::sqrt(9.04 - 1.0);
  const Vec2 leg = Vec2(3.0 * reach - 0.2, 0.2 * reach + 3.0) / 9.04;
  EXPECT_LT((vo(e).velocity.head<2>() - leg.x() * leg).norm(), 1e-12);
}

TEST(VelocityObstacleDecision, FromInsideASolidTheWayIsOutThroughTheNearestSide) {
  const std::array<Vec3, 4> square{Vec3{-0.2, -5, 0}, Vec3{9, -5, 0}, Vec3{9, 5, 0}, Vec3{-0.2, 5, 0}};
  OwnedSituation e = encounters::open_water();
  e.situation.own.velocity = Vec3::Zero();
  e.situation.goal.velocity = Vec3::Zero();
  e.obstacles = {{.kind = Obstacle::Kind::polygon, .vertices = square}};
  EXPECT_LT((vo(e).velocity - Vec3(-1.2, 0.0, 0.0)).norm(), 1e-9);
}

TEST(VelocityObstacleDecision, APolygonIsItsSides) {
  const std::array<Vec3, 4> square{Vec3{3, -5, 0}, Vec3{9, -5, 0}, Vec3{9, 5, 0}, Vec3{3, 5, 0}};
  OwnedSituation polygon = encounters::open_water();
  polygon.obstacles = {{.kind = Obstacle::Kind::polygon, .vertices = square}};
  OwnedSituation wall = encounters::open_water();
  wall.obstacles = {{.kind = Obstacle::Kind::segment, .from = square[3], .to = square[0]}};
  EXPECT_LT((vo(polygon).velocity - vo(wall).velocity).norm(), 1e-12);
}

TEST(VelocityObstacleDecision, OnAWallItLeavesAcrossIt) {
  OwnedSituation e = encounters::open_water();
  e.situation.goal.velocity = Vec3::Zero();
  e.obstacles = {{.kind = Obstacle::Kind::segment, .from = {-9.0, 0.0, 50.0}, .to = {9.0, 0.0, 50.0}}};
  EXPECT_LT((vo(e).velocity - Vec3(0.0, 1.0, 0.0)).norm(), 1e-9);
}

TEST(VelocityObstacleDecision, WhoStandsAndMayOnlyGoAheadTurnsToItsCourse) {
  OwnedSituation e = encounters::open_water();
  e.tracks = {encounters::track(1, {15.0, 0.0, 50.0}, Vec3::Zero())};
  e.situation.own.velocity = Vec3::Zero();
  e.situation.goal.position = {0.0, -100.0, 50.0};
  e.situation.own.yaw = 0.5;
  EXPECT_EQ(vo(e).heading, std::nullopt);
  EXPECT_TRUE(vo(e).astern);
  e.situation.limits.max_turn_rate = 0.3;
  EXPECT_LT(vo(e).velocity.norm(), 1e-12);
  EXPECT_NEAR(vo(e).heading.value_or(0.0), -0.5 * pi, 1e-12);
  EXPECT_FALSE(vo(e).astern);
}

TEST(VelocityObstacleDecision, WhoIsFollowedAndHasNothingToGoRoundByItselfMayAskForAnyVelocity) {
  OwnedSituation e = encounters::open_water();
  e.tracks = {encounters::track(1, {15.0, 0.0, 50.0}, Vec3::Zero())};
  e.situation.own.velocity = {0.2, 0.0, 0.0};
  e.situation.goal.position = {0.0, -100.0, 50.0};
  e.situation.limits.max_turn_rate = 0.3;
  e.situation.limits.max_acceleration = 0.1;
  e.situation.limits.sway = false;
  const Vec3 within_reach = vo(e).velocity;
  EXPECT_GT(within_reach.x(), 0.0);
  const Envelope envelope = encounters::of_a_boat();
  e.situation.envelope = &envelope;
  EXPECT_EQ(vo(e).velocity, e.situation.preferred_velocity());
  e.obstacles = {encounters::sphere(10.0, 10.0, 1.0, 50.0)};
  EXPECT_EQ(vo(e).velocity, within_reach);
  e.situation.limits.sway = true;
  EXPECT_EQ(vo(e).velocity, e.situation.preferred_velocity());
  e.situation.limits.sway = false;
  e.situation.is_led = true;
  EXPECT_EQ(vo(e).velocity, e.situation.preferred_velocity());
}

TEST(VelocityObstacleDecision, DrawsTheRegionOfEachObstacleAndItsChoice) {
  // R / d = 3 / 5, T = 5: the legs leave the cut 0.8 from the apex, which is the other's velocity
  OwnedSituation e = encounters::open_water();
  e.tracks = {encounters::track(1, {5.0, 0.0, 50.0}, {0.0, -1.0, 0.0}, 2.0)};
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {0.0, 9.0, 50.0}, .radius = 1.0}};
  Drawing drawing;
  const Command command = decide(e, {}, Responsibility::all, &drawing);
  const auto strokes = drawing.strokes();
  ASSERT_EQ(strokes.size(), 4U);
  EXPECT_EQ(strokes[0].kind, Stroke::Kind::region);
  EXPECT_EQ(strokes[0].meaning, "velocity obstacle of vehicle 1");
  const std::vector<Vec3>& cone = strokes[0].points;
  EXPECT_LT((cone.at(1) - Vec3(0.64, -1.48, 0.0)).norm(), 1e-12);
  EXPECT_LT((cone.at(cone.size() - 2) - Vec3(0.64, -0.52, 0.0)).norm(), 1e-12);
  // nearest to the apex, the cut is 1 - 3 / 5 from it
  EXPECT_LT((cone.at(cone.size() / 2) - Vec3(0.4, -1.0, 0.0)).norm(), 1e-12);
  EXPECT_EQ(strokes[1].meaning, "velocity obstacle of an obstacle");
  EXPECT_EQ(strokes[2].meaning, "preferred");
  EXPECT_EQ(strokes[3].meaning, "chosen");
  EXPECT_EQ(strokes[3].points, std::vector<Vec3>{command.velocity});
}

TEST(VelocityObstacleDecision, WhoTouchesAndMayOnlyGoAheadTurnsAway) {
  // 1.9 m to the south-west, R = 2: ahead leads on into it, so stop and turn to north-east
  OwnedSituation e = encounters::open_water();
  e.situation.own.velocity = Vec3::Zero();
  e.situation.own.yaw = -0.75 * pi;
  e.situation.goal.velocity = Vec3{-1.0, -1.0, 0.0};
  e.situation.limits.max_turn_rate = 0.3;
  e.tracks = {encounters::track(1, Vec3{-1.9, -1.9, 0.0} / std::sqrt(2.0) + Vec3{0, 0, 50}, Vec3::Zero())};
  const Command command = vo(e);
  EXPECT_EQ(command.mode, Mode::infeasible);
  EXPECT_LT(command.velocity.norm(), 1e-12);
  EXPECT_NEAR(command.heading.value_or(0.0), 0.25 * pi, 1e-6);
}

TEST(VelocityObstacleDecision, OfTooManyObstaclesTheNearestCount) {
  // 200 pebbles astern, listed before a wall 3 m ahead
  OwnedSituation e = encounters::open_water();
  for (int i = 0; i < 200; ++i) e.obstacles.push_back(encounters::sphere(-12.0, 0.01 * i, 0.1, 50.0));
  e.obstacles.push_back(encounters::wall({3.0, -50.0, 50.0}, {3.0, 50.0, 50.0}));
  for (const Responsibility responsibility : everyone) {
    const Command command = decide(e, {}, responsibility);
    EXPECT_LT(command.velocity.x(), 0.4 + 1e-9);
    EXPECT_NE(command.note, "");
  }
  e.obstacles.erase(e.obstacles.begin(), e.obstacles.begin() + 100);
  EXPECT_EQ(vo(e).note, "");
}

}  // namespace
}  // namespace fairway::velocity_obstacle
