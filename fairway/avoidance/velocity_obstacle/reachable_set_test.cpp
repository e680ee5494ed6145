// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/reachable_set.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/velocity_obstacle/testing/random_scenes.hpp"

namespace fairway::velocity_obstacle {
namespace {

const Ownship northbound{.velocity = {1.0, 0.0, 0.0}};

TEST(ReachableSet, IsEverythingWithoutLimits) {
  EXPECT_TRUE(ReachableSet(northbound, {}, 1.0).contains({-300.0, 400.0}, 0.0));
}

TEST(ReachableSet, IsTheLimitsTimesTheInterval) {
  const ReachableSet reachable(northbound, {.max_speed = 1.2, .max_acceleration = 0.2}, 2.0);
  EXPECT_TRUE(reachable.contains({0.601, 0.0}, 0.0));
  EXPECT_FALSE(reachable.contains({0.599, 0.0}, 0.0));
  EXPECT_TRUE(reachable.contains({1.199, 0.0}, 0.0));
  EXPECT_FALSE(reachable.contains({1.201, 0.0}, 0.0));
  EXPECT_TRUE(reachable.contains({1.0, 0.399}, 0.0));
  EXPECT_FALSE(reachable.contains({1.0, 0.401}, 0.0));
}

TEST(ReachableSet, ATurnLimitLeavesCoursesNearTheHeadingAndStandingStill) {
  const ReachableSet reachable(northbound, {.max_turn_rate = 0.25}, 2.0);
  EXPECT_TRUE(reachable.contains({std::cos(0.499), std::sin(0.499)}, 0.0));
  EXPECT_FALSE(reachable.contains({std::cos(0.501), -std::sin(0.501)}, 0.0));
  EXPECT_FALSE(reachable.contains({-1.0, 0.0}, 0.0));
  EXPECT_TRUE(reachable.contains({0.0, 0.0}, 0.0));
}

TEST(ReachableSet, AWideTurnLeavesOutWhatIsAstern) {
  const ReachableSet reachable(northbound, {.max_turn_rate = 2.5}, 1.0);
  EXPECT_TRUE(reachable.contains({std::cos(2.499), std::sin(2.499)}, 0.0));
  EXPECT_FALSE(reachable.contains({std::cos(2.501), std::sin(2.501)}, 0.0));
}

TEST(ReachableSet, WhoMayNotTurnGoesAheadOrStops) {
  const ReachableSet reachable(northbound, {.max_turn_rate = 0.0}, 1.0);
  EXPECT_TRUE(reachable.contains({0.5, 0.0}, 1e-12));
  EXPECT_FALSE(reachable.contains({0.5, 0.01}, 1e-12));
  EXPECT_FALSE(reachable.contains({-0.5, 0.0}, 1e-12));
}

TEST(ReachableSet, WhoIsTooFastOrGoesAsideCanAlwaysDoSomething) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Rng rng = Rng{1}.stream("aside", i);
    Ownship own{.yaw = rng.uniform(-pi, pi)};
    own.velocity.head<2>() = rng.uniform(0.0, 3.0) * any_direction(rng);
    const ReachableSet reachable(
        own, {.max_speed = 1.0, .max_acceleration = 0.1, .max_turn_rate = rng.uniform(0.0, 4.0)}, 1.0);
    EXPECT_TRUE(reachable.contains(reachable.middle(), 1e-12)) << i;
  }
}

TEST(ReachableSet, WhoCannotStopKeepsItsLeastSpeedAndGoesNotAbaftItsBeam) {
  const Limits torpedo{.max_speed = 1.5, .min_speed = 0.8, .sternway = false};
  const ReachableSet reachable(northbound, torpedo, 1.0);
  EXPECT_TRUE(reachable.contains({0.81, 0.0}, 0.0));
  EXPECT_FALSE(reachable.contains({0.79, 0.0}, 0.0));
  EXPECT_FALSE(reachable.contains({0.0, 0.0}, 0.0));
  EXPECT_TRUE(reachable.contains({0.01, -1.0}, 0.0));
  EXPECT_FALSE(reachable.contains({-0.01, -1.0}, 0.0));
  for (const Vec2& drifting : {Vec2{-1.0, 0.3}, Vec2{0.0, 0.0}, Vec2{0.1, 0.1}, Vec2{-2.0, 0.0}}) {
    const Ownship own{.velocity = {drifting.x(), drifting.y(), 0.0}};
    const ReachableSet from_there(own,
                                  {.max_speed = 1.5,
                                   .max_acceleration = 0.1,
                                   .max_turn_rate = 0.1,
                                   .min_speed = 0.8,
                                   .sternway = false},
                                  1.0);
    EXPECT_TRUE(from_there.contains(from_there.middle(), 1e-12)) << drifting.transpose();
  }
}

TEST(ReachableSet, OfWhoIsNotAllowedItsLeastSpeedIsTheSpeedLimit) {
  const ReachableSet reachable(northbound, {.max_speed = 0.5, .min_speed = 0.8}, 1.0);
  EXPECT_TRUE(reachable.contains({0.5, 0.0}, 1e-12));
  EXPECT_FALSE(reachable.contains({0.4, 0.0}, 1e-12));
}

}  // namespace
}  // namespace fairway::velocity_obstacle
