// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/kinematic_zone.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/avoa/testing/random_spaces.hpp"

namespace fairway::avoa {
namespace {

TEST(KinematicZone, StraightAheadEndsAtTheLargestSpeed) {
  EXPECT_FALSE(zarco.contains({1.5, 0.0}));
  EXPECT_TRUE(zarco.contains({1.5001, 0.0}));
  KinematicZone strong = zarco;
  strong.thruster_speed = 9.0;
  EXPECT_TRUE(strong.contains({1.5001, 0.0}));
}

TEST(KinematicZone, TheOuterThrusterLimitsTheSpeedInATurnToEitherSide) {
  // at 0.4 rad the turn rate is 0.2 rad/s: v + 3 * 0.2 <= 1.5
  for (const double heading : {0.4, -0.4}) {
    EXPECT_FALSE(zarco.contains({0.899, heading}));
    EXPECT_TRUE(zarco.contains({0.901, heading}));
  }
}

TEST(KinematicZone, OfWhoCannotStopHoldsWhatIsTooSlowOrAbaftTheBeam) {
  KinematicZone torpedo = zarco;
  torpedo.thruster_speed = 100.0;
  torpedo.min_speed = 1.0;
  torpedo.only_ahead = true;
  EXPECT_TRUE(torpedo.contains({0.99, 0.0}));
  EXPECT_FALSE(torpedo.contains({1.01, 1.5}));
  EXPECT_TRUE(torpedo.contains({1.01, -1.6}));
}

TEST(KinematicZone, BesideTheForeseenHeadingIsAsBesideTheBow) {
  KinematicZone foreseen = zarco;
  foreseen.foreseen_heading = 3.0;
  for (const double heading : {3.4 - 2.0 * pi, 2.6, 0.4, -0.4}) {
    EXPECT_FALSE(foreseen.contains({0.899, heading}));
    EXPECT_TRUE(foreseen.contains({0.901, heading}));
  }
  EXPECT_FALSE(foreseen.contains({1.5, 3.0}));
}

TEST(KinematicZone, BeyondTheLargestTurnRateTheHeadingDoesNotMatter) {
  // v + 3 * 0.3751 <= 1.5
  for (const double heading : {0.8, -2.0, pi}) {
    EXPECT_FALSE(zarco.contains({0.374, heading}));
    EXPECT_TRUE(zarco.contains({0.375, heading}));
  }
}

}  // namespace
}  // namespace fairway::avoa
