// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/wall_following/printed.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/hard_switching/testing/transport.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;
using transport::Course;

Avoider with(WallFollowing::Params params = {}) { return Avoider{WallFollowing{params}}; }

/// Table 6, and the gains of section IV-B-1.
WallFollowing::Params among_four() {
  return {.sensor_range_m = 1.0,
          .goal_gain_hz = 0.1,
          .wall_gain_hz = 1.0,
          .alpha_ratio = 1.0,
          .goal_surge_kp_kgps = 20.0,
          .goal_surge_kd_kg = 50.0,
          .goal_sway_kp_kgps = 30.0,
          .goal_sway_kd_kg = 100.0,
          .goal_yaw_kd_kgm2ps = 0.0,
          .wall_surge_kp_kgps = 20.0,
          .wall_surge_kd_kg = 5.0,
          .wall_sway_kp_kgps = 100.0,
          .wall_sway_kd_kg = 5.0,
          .wall_yaw_kp_nmprad = 5.0,
          .wall_yaw_kd_kgm2ps = 0.0};
}

TEST(WallFollowingPrinted, PidActsOnVelocityErrorsInBodyAxes) {
  OwnedSituation e = encounters::open_water(0.0);
  e.situation.goal.position = {10.0, 20.0, 50.0};
  e.situation.own.yaw = pi / 2;
  const Command command = with({.heading_rad = pi}).decide(e);
  ASSERT_TRUE(command.wrench.has_value());
  EXPECT_NEAR((*command.wrench)[0], 3.0 * 0.5 * 20.0, 1e-12);   // ahead is east
  EXPECT_NEAR((*command.wrench)[1], -5.0 * 0.5 * 10.0, 1e-12);  // to port is north
  EXPECT_NEAR((*command.wrench)[5], 5.0 * pi / 2, 1e-12);
}

TEST(WallFollowingPrinted, DerivativeOfTheWishIsThatOfTheClosedForm) {
  // making 1 m/s north and turning: the wish in body axes falls with the distance and turns the other way
  OwnedSituation e = encounters::open_water(1.0);
  e.situation.goal.position = {10.0, 0.0, 50.0};
  e.situation.own.yaw_rate = 0.2;
  const Wrench tau = *with().decide(e).wrench;
  EXPECT_NEAR(tau[0], 3.0 * (5.0 - 1.0) + 5.0 * -0.5, 1e-12);
  EXPECT_NEAR(tau[1], 10.0 * 0.2 * -5.0, 1e-12);
  EXPECT_NEAR(tau[5], -1.0 * 0.2, 1e-12);
}

TEST(WallFollowingPrinted, AccelerationIsTheDifferenceFromTheCallBefore) {
  Avoider avoider = with();
  OwnedSituation e = encounters::open_water(1.0);
  e.situation.goal.position = {10.0, 0.0, 50.0};
  (void)avoider.decide(e);
  e.situation.time = 0.5;
  e.situation.own.velocity = {1.2, 0.0, 0.0};
  EXPECT_NEAR((*avoider.decide(e).wrench)[0], 3.0 * (5.0 - 1.2) + 5.0 * (-0.5 * 1.2 - 0.4), 1e-12);
}

TEST(WallFollowingPrinted, GoesTheWayThatLeadsNearerToTheGoalAndClockwiseInATie) {
  EXPECT_EQ(wall::turn_along({-1.0, 0.0}, {1.0, 0.1}), 1.0);
  EXPECT_EQ(wall::turn_along({-1.0, 0.0}, {1.0, -0.1}), -1.0);
  EXPECT_EQ(wall::turn_along({-1.0, 0.0}, {1.0, 0.0}), 1.0);
  EXPECT_EQ(wall::clockwise({-1.0, 0.0}), Vec2(0.0, 1.0));
}

TEST(WallFollowingPrinted, StopsFollowingWhenTheGoalIsOnOwnSideOfTheCentre) {
  EXPECT_FALSE(wall::is_clear({-1.0, 0.2}, {1.0, 0.0}));
  EXPECT_FALSE(wall::is_clear({0.0, 1.0}, {1.0, 0.0}));
  EXPECT_TRUE(wall::is_clear({0.1, 1.0}, {1.0, 0.0}));
}

TEST(WallFollowingPrinted, FollowedVelocityLeadsAlongTheWallAtCruiseSpeed) {
  OwnedSituation e = encounters::open_water(1.0);
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {8.0, -1.0, 50.0}, .radius = 2.0}};
  const Command command = with().decide(e);
  EXPECT_EQ(command.mode, Mode::avoid);
  EXPECT_NEAR(command.velocity.norm(), 1.0, 1e-12);
  EXPECT_GT(command.velocity.y(), 0.9);
}

// Examples on a plant chosen after seeing the published times; first forces, displacement and yaw moment come
// out alike on any.
TEST(WallFollowingPrinted, ExampleRunAroundOneObstacle) {
  const transport::Voyage run = transport::run(with(), Course{});
  EXPECT_NEAR(run.first[0], 150.0, 1e-9);       // printed 150
  EXPECT_NEAR(run.first[1], 250.0, 1e-9);       // printed 250
  EXPECT_NEAR(run.least[0], -41.0, 1.0);        // printed -54, measured -41.01
  EXPECT_NEAR(run.greatest[0], 195.0, 1.0);     // printed 187, measured 195.33
  EXPECT_NEAR(run.greatest[1], 483.0, 1.0);     // printed 487, measured 482.77
  EXPECT_NEAR(run.displacement(), 141.2, 0.2);  // printed 141.2, measured 141.20
  EXPECT_NEAR(run.arrival, 273.0, 1.0);         // measured 273.14 s to 1 m
  EXPECT_EQ(run.greatest[5], 0.0);              // printed 0
  const Vec3 at{run.at_first_avoidance[0] + 3.2, run.at_first_avoidance[1], 0.0};
  EXPECT_NEAR((at - Course{}.obstacles[0].position).norm(), 25.0, 0.05);  // measured 24.9997
}

TEST(WallFollowingPrinted, ExampleRunAmongFourObstaclesLeavesThePublishedCourseAtTheThird) {
  const transport::Voyage run = transport::run(with(among_four()), Course::of_four({}));
  EXPECT_NEAR(run.least[0], -18.7, 1.0);  // printed -29
  EXPECT_NEAR(run.greatest[0], 98.5,
              1.0);  // printed 93, at the third obstacle, which it meets on another side
  EXPECT_NEAR(run.greatest[1], 461.7, 3.0);    // printed 441
  EXPECT_NEAR(run.displacement(), 41.3, 0.5);  // the goal is at 41.34 m
  const Vec3 at{run.at_first_avoidance[0] + 3.2, run.at_first_avoidance[1], 0.0};
  EXPECT_NEAR((at - Course::of_four({}).obstacles[0].position).norm(), 2.0, 0.05);  // measured 1.998
}

TEST(WallFollowingPrinted, PassesRightThroughWhatIsOnTheDiagonal) {
  Course course;
  course.obstacles = {transport::sphere(50, 50, 1)};
  WallFollowing::Params params = among_four();
  params.goal_sway_kp_kgps = params.goal_surge_kp_kgps;
  params.goal_sway_kd_kg = params.goal_surge_kd_kg;
  const transport::Voyage run = transport::run(with(params), course);
  EXPECT_EQ(run.avoided, 0);
  EXPECT_LT(run.clearance, -0.99);  // through its centre
  EXPECT_GT(run.arrival, 0.0);
}

}  // namespace
}  // namespace fairway
