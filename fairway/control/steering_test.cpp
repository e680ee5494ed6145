// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/steering.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace fairway {
namespace {

TEST(Steering, ACommandedTurnRateIsTakenAsItIsByEveryKind) {
  const double yaw = 0.5 * std::numbers::pi;
  const Command command{.velocity = {0.3, 0.4, 0.1}, .turn_rate = -0.2};
  for (const SteeringKind kind : {SteeringKind::turn_then_go, SteeringKind::proportional,
                                  SteeringKind::holonomic, SteeringKind::speed_and_course}) {
    const BodyRequest request = steer({.kind = kind}, command, yaw);
    EXPECT_EQ(request.yaw_rate_radps, -0.2) << static_cast<int>(kind);
    EXPECT_NEAR(request.surge_mps, 0.4, 1e-12) << static_cast<int>(kind);
    EXPECT_EQ(request.sway_mps, 0.0) << static_cast<int>(kind);
    EXPECT_EQ(request.heave_mps, 0.1) << static_cast<int>(kind);
  }
}

TEST(Steering, AVelocityBesideTheHeadingThatIsAskedForIsMadeAsFarAsItIsAlongTheBow) {
  for (const SteeringKind kind :
       {SteeringKind::proportional, SteeringKind::speed_and_course, SteeringKind::turn_then_go}) {
    SteeringParams params;
    params.kind = kind;
    const Command east{.velocity = {0.0, 0.5, 0.0}, .heading = 0.0};
    EXPECT_NEAR(steer(params, east, 0.0).surge_mps, 0.0, 1e-12);
    const Command south{.velocity = {-0.5, 0.0, 0.0}, .heading = 0.0};
    EXPECT_NEAR(steer(params, south, 0.0).surge_mps, -0.5, 1e-12) << "astern, and not the opposite way";
    EXPECT_EQ(steer(params, south, 0.0).yaw_rate_radps, 0.0);
    const Command along{.velocity = {0.5, 0.0, 0.0}, .heading = 0.0};
    EXPECT_EQ(steer(params, along, 0.0).surge_mps, 0.5);
  }
}

TEST(Steering, HolonomicGoesAnyWayAndKeepsTheHeading) {
  const BodyRequest request = steer({.kind = SteeringKind::holonomic, .heading_rad = 0.5 * std::numbers::pi},
                                    {.velocity = {0.3, 0.4, 0.1}}, 0.5 * std::numbers::pi);
  EXPECT_NEAR(request.surge_mps, 0.4, 1e-12);
  EXPECT_NEAR(request.sway_mps, -0.3, 1e-12);
  EXPECT_NEAR(request.yaw_rate_radps, 0.0, 1e-12);
}

}  // namespace
}  // namespace fairway
