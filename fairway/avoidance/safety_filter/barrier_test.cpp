// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/safety_filter/barrier.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;

constexpr BarrierGains of_forces{.k1 = 0.4, .k2 = 0.2, .margin = 0.5, .response = 0.0};

/// A ball of radius 2 m, 10 m north of own ship of radius 1 m: R = 3.5 m, h = 87.75 m2.
Hazard ball(const Vec3& velocity = Vec3::Zero()) {
  return {{10.0, 0.0, 50.0}, velocity, 2.0, false, false, Vec3::UnitX()};
}

Ownship northbound(double speed = 1.0) { return encounters::open_water(speed).situation.own; }

std::vector<Hazard> seen(const Situation& s, double range = 100.0) {
  Hazards found;
  find_hazards_near(s, range, found);
  return {found.view().begin(), found.view().end()};
}

TEST(Barrier, OfSecondOrderBoundsTheAcceleration) {
  // h' = -20: -20 a >= -(2 - 0.6 * 20 + 0.08 * 87.75), so a <= -0.149
  const Barrier b = barrier(ball(), northbound(), of_forces);
  EXPECT_EQ(b.acceleration.normal, Vec2(-1.0, 0.0));
  EXPECT_NEAR(b.acceleration.offset, -(2.0 - 12.0 + 7.02) / 20.0, 1e-14);
  EXPECT_FALSE(b.is_late);
}

TEST(Barrier, SeesOnlyRelativeVelocity) {
  const Barrier standing = barrier(ball(), northbound(1.0), of_forces);
  const Barrier coming = barrier(ball({-0.6, 0.0, 0.0}), northbound(0.4), of_forces);
  EXPECT_NEAR(coming.acceleration.offset, standing.acceleration.offset, 1e-14);
}

TEST(Barrier, WhoReactsDoesHalf) {
  Hazard vehicle = ball();
  vehicle.reacts = true;
  EXPECT_NEAR(barrier(vehicle, northbound(), of_forces).acceleration.offset, 0.5 * 2.98 / 20.0, 1e-14);
}

TEST(Barrier, MotionAlongAFlatSurfaceDoesNotOpenTheRange) {
  Ownship own = northbound();
  own.velocity = {1.0, 5.0, 0.0};
  Hazard wall = ball();
  wall.is_flat = true;
  EXPECT_NEAR(barrier(wall, own, of_forces).acceleration.offset, 2.98 / 20.0, 1e-14);
  EXPECT_LT(barrier(ball(), own, of_forces).acceleration.offset, 0.0);
}

TEST(Barrier, WhenLateAsksForTheDecelerationThatStopsAtTheMargin) {
  // h' = -60 and k1 h = 35.1; from 3 m/s within 6.5 m: 9 / 13 m/s2
  Ownship own = northbound(3.0);
  const BarrierGains slow{.k1 = 0.4, .k2 = 0.01, .margin = 0.5, .response = 0.0};
  const Barrier b = barrier(ball(), own, slow);
  EXPECT_TRUE(b.is_late);
  EXPECT_NEAR(b.acceleration.offset, 9.0 / 13.0, 1e-14);
}

TEST(Barrier, ACommandedVelocityIsHeldToTheFirstOrderToo) {
  // k1 h = 35.1: no more than 1.755 m/s towards it. Fast sideways motion leaves that to be the tighter one
  Ownship own = northbound();
  own.velocity = {1.0, 5.0, 0.0};
  const Barrier b = barrier(ball(), own, {.k1 = 0.4, .k2 = 0.2, .margin = 0.5, .response = 2.0});
  EXPECT_NEAR(own.velocity.x() - 2.0 * b.acceleration.offset, 1.755, 1e-13);
}

TEST(Barrier, AtOnePlaceBothPart) {
  Hazard there = ball();
  there.centre = northbound().position;
  there.parting = -Vec3::UnitX();
  const Barrier b = barrier(there, northbound(0.0), of_forces);
  EXPECT_EQ(b.acceleration.normal, Vec2(-1.0, 0.0));
  EXPECT_GT(b.acceleration.offset, 0.0);
}

TEST(Hazards, ObstaclesAsListedThenTracksWithinRange) {
  OwnedSituation e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {9.0, 0.0, 50.0}, .radius = 2.0},
                 {.kind = Obstacle::Kind::sphere, .position = {13.1, 0.0, 50.0}, .radius = 2.0}};
  e.tracks = {encounters::track(1, {0.0, 5.0, 50.0}, {0.1, 0.2, 0.0}, 1.5)};
  e.tracks[0].reacts = false;
  const std::vector<Hazard> hazards = seen(e, 10.0);
  ASSERT_EQ(hazards.size(), 2U);
  EXPECT_EQ(hazards[0].centre, e.obstacles[0].position);
  EXPECT_NEAR(hazards[0].gap(e.situation.own), 6.0, 1e-14);
  EXPECT_EQ(hazards[1].velocity, e.tracks[0].velocity);
  EXPECT_EQ(hazards[1].radius, 1.5);
  EXPECT_FALSE(hazards[1].reacts);
}

TEST(Hazards, AWallIsFlatBesideItAndAPointBeyondItsEnd) {
  OwnedSituation e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::segment, .from = {5.0, -3.0, 50.0}, .to = {5.0, 3.0, 50.0}},
                 {.kind = Obstacle::Kind::segment, .from = {5.0, 3.0, 50.0}, .to = {5.0, 9.0, 50.0}}};
  const std::vector<Hazard> hazards = seen(e);
  EXPECT_EQ(hazards[0].centre, Vec3(5.0, 0.0, 50.0));
  EXPECT_TRUE(hazards[0].is_flat);
  EXPECT_EQ(hazards[1].centre, Vec3(5.0, 3.0, 50.0));
  EXPECT_FALSE(hazards[1].is_flat);
}

TEST(Hazards, APolygonIsItsEdgesAndFromInsideTheWayOut) {
  const std::array<Vec3, 4> square{Vec3{2, -5, 0}, Vec3{9, -5, 0}, Vec3{9, 5, 0}, Vec3{2, 5, 0}};
  OwnedSituation e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::polygon, .vertices = square}};
  EXPECT_EQ(seen(e).size(), 4U);

  e.situation.own.position = {3.0, 0.0, 50.0};  // 1 m inside
  const std::vector<Hazard> inside = seen(e);
  ASSERT_EQ(inside.size(), 1U);
  EXPECT_NEAR(inside[0].gap(e.situation.own), -2.0, 1e-14);
  EXPECT_LT(barrier(inside[0], northbound(0.0), of_forces).acceleration.normal.x(), -0.999);
}

TEST(Hazards, NoNumberOfPebblesHidesAVessel) {
  OwnedSituation e = encounters::head_on(6.0);
  for (int i = 0; i < 300; ++i) e.obstacles.push_back(encounters::sphere(-3.0 - 0.01 * i, 0.0, 0.1, 50.0));
  Hazards found;
  find_hazards_near(e, 30.0, found);
  EXPECT_TRUE(found.left_out);
  ASSERT_EQ(found.count, max_hazards);
  EXPECT_EQ(found.all[0].centre, Vec3(6.0, 0.0, 50.0));
  for (const Hazard& hazard : found.view().subspan(1)) EXPECT_GE(hazard.centre.x(), -3.0 - 0.01 * 254);
  e.obstacles.resize(255);
  find_hazards_near(e, 30.0, found);
  EXPECT_FALSE(found.left_out);
  EXPECT_EQ(found.all[255].centre, Vec3(6.0, 0.0, 50.0)) << "where all fit, obstacles come first";
}

TEST(Hazards, NoNumberOfVesselsHidesAWall) {
  OwnedSituation e = encounters::open_water();
  for (std::uint32_t i = 0; i < 300; ++i)
    e.tracks.push_back(encounters::track(i + 1, {-10.0 - 0.01 * i, 0.0, 50.0}, Vec3::Zero()));
  e.obstacles = {encounters::wall({3.0, -9.0, 50.0}, {3.0, 9.0, 50.0})};
  Hazards found;
  find_hazards_near(e, 30.0, found);
  EXPECT_TRUE(std::ranges::any_of(found.view(), &Hazard::is_flat));
}

}  // namespace
}  // namespace fairway
