// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/drift.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/avoa_improved/testing/unicycle.hpp"

namespace fairway::avoa_improved {
namespace {

constexpr VesselResponse boat_helm{.turn_gain = 1.0,
                                   .max_turn_rate = 0.3751,
                                   .max_turn_acceleration = 0.5,
                                   .max_acceleration = 0.5,
                                   .response = 0.5};

TEST(AvoaImprovedDrift, LearnsTheCurrentOnOneHeading) {
  Unicycle boat{.current = {-0.1, 0.15}};
  Drift drift;
  for (int k = 0; k < 100; ++k) {
    drift.observe(boat.velocity(), {std::cos(boat.yaw), std::sin(boat.yaw)}, boat_helm, 0.2, 3.0);
    const Command ahead{.velocity = {k < 50 ? 1.2 : 0.4, 0.0, 0.0}};
    drift.command(ahead.velocity.x());
    boat.sail(ahead, 0.2);
  }
  EXPECT_LT((drift.velocity() - boat.current).norm(), 0.01);
}

TEST(AvoaImprovedDrift, IsNoneForAVesselThatDoesAsItIsSteered) {
  Unicycle boat;
  Drift drift;
  for (int k = 0; k < 100; ++k) {
    drift.observe(boat.velocity(), {std::cos(boat.yaw), std::sin(boat.yaw)}, boat_helm, 0.2, 3.0);
    const Command turning{.velocity = {0.0, k < 50 ? 1.2 : 0.3, 0.0}};
    drift.command(turning.velocity.y());
    boat.sail(turning, 0.2);
    EXPECT_LT(drift.velocity().norm(), 0.02);
  }
}

TEST(AvoaImprovedDrift, TheCrabAngleMakesGoodTheDirection) {
  const Vec2 direction{std::cos(0.4), std::sin(0.4)};
  const Vec2 drift{-0.2, 0.15};
  const double heading = 0.4 + crab_angle(direction, drift, 1.2);
  const Vec2 made_good = 1.2 * Vec2{std::cos(heading), std::sin(heading)} + drift;
  EXPECT_NEAR(std::atan2(made_good.y(), made_good.x()), 0.4, 1e-12);
  EXPECT_EQ(crab_angle(direction, drift, 0.0), 0.0);
  EXPECT_NEAR(std::abs(crab_angle({1, 0}, {0, 5}, 1.2)), pi / 2, 1e-12);
}

}  // namespace
}  // namespace fairway::avoa_improved
