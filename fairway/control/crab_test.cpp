// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "fairway/control/guidance.hpp"
#include "fairway/control/steering.hpp"
#include "fairway/core/angles.hpp"

namespace fairway {
namespace {

const SteeringParams crab{.kind = SteeringKind::crab, .turn_gain_hz = 0.3, .min_speed_mps = 0.9};

/// A body that carries out a request at once.
struct IdealBody {
  Vec3 position = Vec3::Zero();
  double yaw{};
  Vec3 over_ground = Vec3::Zero();

  void follow(const BodyRequest& request, const Vec3& current_n, double h) {
    yaw = wrap_angle(yaw + h * request.yaw_rate_radps);
    const double ahead =
        std::sqrt(request.surge_mps * request.surge_mps - request.heave_mps * request.heave_mps);
    over_ground = Vec3{ahead * std::cos(yaw), ahead * std::sin(yaw), request.heave_mps} + current_n;
    position += h * over_ground;
  }
};

TEST(Crab, MakesTheCommandedVelocityOverGroundInAnyCurrent) {
  const Command command{.velocity = {1.2, 0.9, 0.1}};
  for (const Vec3& current_n : {Vec3{0, 0, 0}, Vec3{-0.16, 0.12, 0.0}, Vec3{0.2, -0.3, 0.05}}) {
    IdealBody body;
    for (int i = 0; i < 2000; ++i) {
      body.follow(steer_through_water(crab, command, body.yaw, current_n), current_n, 0.05);
    }
    EXPECT_LT((body.over_ground - command.velocity).norm(), 1e-9);
  }
}

TEST(Crab, AcrossACurrentATurnRateIsCarriedOutAtTheSpeedOverGroundThatIsMeantForTheBow) {
  Command command{.velocity = {1.5, 0, 0}};
  command.turn_rate = 0.02;
  const Vec3 abeam{0, 0.7, 0};
  EXPECT_EQ(steer_through_water(crab, command, 0.0, abeam).surge_mps, 1.5);
  EXPECT_EQ(steer_through_water(crab, command, pi, abeam).surge_mps, 0.9);  // its least

  Command aside{.velocity = {1.5, 0, 0}};
  aside.heading = 0.8;
  EXPECT_NEAR(steer_through_water(crab, aside, 0.8, Vec3::Zero()).surge_mps, 1.5 * std::cos(0.8), 1e-12);
}

TEST(Crab, NeverAsksForLessThanItsLeastSpeed) {
  EXPECT_EQ(steer_through_water(crab, {.velocity = {0.3, 0, 0}}, 0.0, Vec3::Zero()).surge_mps, 0.9);
  const BodyRequest stop = steer_through_water(crab, {.mode = Mode::infeasible}, 0.7, Vec3::Zero());
  EXPECT_EQ(stop.surge_mps, 0.9);
  EXPECT_EQ(stop.yaw_rate_radps, 0.0);  // and keeps its heading

  // with the current it is to stem it
  const BodyRequest stem = steer_through_water(crab, {}, 0.0, Vec3{-0.5, 0, 0});
  EXPECT_EQ(stem.yaw_rate_radps, 0.0);
  EXPECT_GT(steer_through_water(crab, {}, -1.0, Vec3{-0.5, 0, 0}).yaw_rate_radps, 0.0);
}

TEST(Crab, TakesACommandedHeadingOrTurnRateAsItIs) {
  Command command{.velocity = {1.5, 0, 0}};
  command.heading = 0.2;
  EXPECT_NEAR(steer_through_water(crab, command, 0.0, Vec3::Zero()).yaw_rate_radps, 0.3 * 0.2, 1e-15);
  command.turn_rate = -0.07;
  EXPECT_EQ(steer_through_water(crab, command, 0.0, Vec3::Zero()).yaw_rate_radps, -0.07);
}

TEST(Circle, IsSailedToStarboardOverThePositionFromInsideAndOutside) {
  const HoldPoint hold{{10.0, -20.0, 8.0}, 0.0};
  constexpr double radius = 25.0;
  for (const Vec3& start : {Vec3{10, -20, 8}, Vec3{30, -10, 3}, Vec3{200, 100, 20}}) {
    for (const Vec3& current_n : {Vec3{0, 0, 0}, Vec3{0.1, 0.2, 0}}) {
      IdealBody body{.position = start};
      double nearest = 1e9, farthest = 0.0, turned = 0.0;
      for (int i = 0; i < 40000; ++i) {
        const Ownship own{.position = body.position, .yaw = body.yaw};
        const double before = body.yaw;
        body.follow(steer_through_water(crab, circle(hold, radius, 1.0, own), body.yaw, current_n), current_n,
                    0.05);
        if (i < 20000) continue;
        turned += wrap_angle(body.yaw - before);
        const double away = horizontal_norm(body.position - hold.position);
        nearest = std::fmin(nearest, away);
        farthest = std::fmax(farthest, away);
      }
      // outside by what heading lags behind a course that turns at 0.04 rad/s, and more along the current
      EXPECT_GT(nearest, radius - 2.0);
      EXPECT_LT(farthest, radius + 5.0);
      EXPECT_GT(turned, 4 * pi);
      EXPECT_NEAR(body.position.z(), 8.0, 1e-6);
    }
  }
}

}  // namespace
}  // namespace fairway
