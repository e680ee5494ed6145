// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/hard_switching/hard_switching.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/hard_switching/testing/transport.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;
using transport::Course;

/// The model that comes nearest to the printed numbers has linear damping only and no Coriolis terms.
Course course_of_500_s(bool coriolis = false) {
  Course course;
  course.plant.coriolis = coriolis;
  course.duration = 500.0;
  return course;
}

Avoider with(HardSwitching::Params params = {}) { return Avoider{HardSwitching{params}}; }

/// Own ship at the origin, a sphere of 2 m at `distance` in the direction `bearing` of its surface.
OwnedSituation sphere_at(double distance, double bearing, double yaw = 0.0) {
  OwnedSituation e = encounters::open_water();
  e.situation.own.yaw = yaw;
  e.obstacles = {
      {.kind = Obstacle::Kind::sphere,
       .position = Vec3{(distance + 2.0) * std::cos(bearing), (distance + 2.0) * std::sin(bearing), 50.0},
       .radius = 2.0}};
  return e;
}

TEST(PointSensors, DetectWhatHasItsSurfaceInRangeOfATip) {
  // the tip ahead is at 3.2 m, and reaches 5 m further
  EXPECT_TRUE(nearest_detected(sphere_at(8.199, 0.0), {}).has_value());
  EXPECT_FALSE(nearest_detected(sphere_at(8.201, 0.0), {}).has_value());
  EXPECT_TRUE(nearest_detected(sphere_at(8.199, pi / 2), {}).has_value());
  EXPECT_FALSE(nearest_detected(sphere_at(8.199, pi / 2, pi / 4), {}).has_value());
}

TEST(PointSensors, TellTheNearestAndOfEqualsTheFirst) {
  OwnedSituation e = sphere_at(6.0, 0.0);
  e.obstacles.push_back(sphere_at(6.0, pi).obstacles[0]);
  EXPECT_EQ(nearest_detected(e, {})->centre, e.obstacles[0].position);
  e.tracks = {encounters::track(1, {0.0, 8.0, 50.0}, {0.1, 0.0, 0.0}, 3.0)};
  EXPECT_EQ(nearest_detected(e, {})->centre, e.tracks[0].position);
  EXPECT_EQ(nearest_detected(e, {})->velocity, e.tracks[0].velocity);
  EXPECT_NEAR(nearest_detected(e, {})->distance, 1.8, 1e-12);
}

TEST(PointSensors, AreBlindOnTheDiagonal) {
  // 1 m of radius and 1 m of range, 0.1 m behind the line between two tips: the nearest tip is 2.26 m away
  OwnedSituation e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = Vec3{1.5, 1.5, 50.0}, .radius = 1.0}};
  EXPECT_FALSE(nearest_detected(e, {.range = 1.0}).has_value());
}

TEST(HardSwitching, PullsPerAxisInTheEarthFrameTurnedIntoBodyAxes) {
  OwnedSituation e = encounters::open_water();
  e.situation.goal.position = {10.0, 20.0, 50.0};
  e.situation.own.yaw = pi / 2;
  const Command command = with().decide(e);
  ASSERT_TRUE(command.wrench.has_value());
  EXPECT_NEAR((*command.wrench)[0], 26.0, 1e-12);   // 1.3 N/m x 20 m, ahead is east
  EXPECT_NEAR((*command.wrench)[1], -13.0, 1e-12);  // to port is north
  EXPECT_EQ((*command.wrench)[5], 0.0);
}

TEST(HardSwitching, TurnsOnTheSpotTowardsAHeadingLatchedAtSwitchOn) {
  Avoider avoider = with();
  OwnedSituation e = sphere_at(6.0, 0.0);
  const Command first = avoider.decide(e);
  EXPECT_EQ(first.mode, Mode::avoid);
  EXPECT_EQ(first.velocity, Vec3(0.0, 0.0, 0.0));
  EXPECT_NEAR((*first.wrench)[5], 200.0 * pi / 2, 1e-12);
  EXPECT_EQ(first.wrench->head<2>().norm(), 0.0);

  e.situation.own.yaw = 0.3;
  e.situation.own.yaw_rate = 0.1;
  e.situation.time = 1.0;
  const double latched = (*avoider.decide(e).wrench)[5];
  EXPECT_NEAR(latched, 200.0 * (pi / 2 - 0.3) - 1.0 * 0.1, 1e-12);
}

TEST(HardSwitching, AsWrittenTheHeadingIsAlwaysAQuarterTurnAhead) {
  Avoider avoider = with({.latch = false});
  OwnedSituation e = sphere_at(8.0, 0.0);
  (void)avoider.decide(e);
  e.situation.own.yaw = 0.2;
  EXPECT_NEAR((*avoider.decide(e).wrench)[5], 200.0 * pi / 2, 1e-12);
}

TEST(HardSwitching, IntegratesTheErrorSinceTheSwitch) {
  Avoider avoider = with({.goal_ki_npmps = 0.1});
  OwnedSituation e = encounters::open_water();
  e.situation.goal.position = {10.0, 0.0, 50.0};
  e.situation.time = 100.0;
  EXPECT_NEAR((*avoider.decide(e).wrench)[0], 13.0, 1e-12);
  e.situation.time = 102.0;
  EXPECT_NEAR((*avoider.decide(e).wrench)[0], 13.0 + 0.1 * 20.0, 1e-12);
}

TEST(HardSwitching, ExampleRunReachesTheGoalWithoutCoriolisTerms) {
  const transport::Voyage run = transport::run(with(), course_of_500_s());
  EXPECT_NEAR(run.first[0], 130.0, 1e-9);       // printed 130
  EXPECT_NEAR(run.first[1], 130.0, 1e-9);       // printed 129
  EXPECT_NEAR(run.greatest[5], 314.16, 0.1);    // printed 313, measured 314.21
  EXPECT_NEAR(run.displacement(), 141.7, 0.5);  // printed 141.8, measured 141.46

  // a tip comes within 25 m of the centre: that ahead or that to starboard
  const Vec3 centre = course_of_500_s().obstacles[0].position;
  const Vec3 at{run.at_first_avoidance[0], run.at_first_avoidance[1], 0.0};
  const double ahead = (at + Vec3{3.2, 0.0, 0.0} - centre).norm();
  const double starboard = (at + Vec3{0.0, 3.2, 0.0} - centre).norm();
  EXPECT_NEAR(std::fmin(ahead, starboard), 25.0, 0.5);  // measured 24.997
}

TEST(HardSwitching, DeadlocksWithCoriolisTerms) {
  // a moment alone cannot turn the motion of a body whose mass is the same on every axis
  const transport::Voyage run = transport::run(with(), course_of_500_s(true));
  EXPECT_LT(run.arrival, 0.0);
  EXPECT_LT(run.clearance, 3.2);  // measured -12.9: the centre coasts into the obstacle
}

TEST(HardSwitching, SpinsForEverAsWritten) {
  const transport::Voyage run = transport::run(with({.latch = false}), course_of_500_s());
  EXPECT_LT(run.arrival, 0.0);
  EXPECT_NEAR(run.end[5], 314.16 / 1018.0, 1e-3);
}

}  // namespace
}  // namespace fairway
