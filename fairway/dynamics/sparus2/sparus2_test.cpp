// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/sparus2/sparus2.hpp"

#include <gtest/gtest.h>

#include "fairway/dynamics/testing/held_actuators.hpp"

namespace fairway {
namespace {

Sparus2::Params neutral() {
  Sparus2::Params params;
  params.buoyancy_kg = params.mass_kg;
  return params;
}

/// From rest, by thrusts down, and of port and starboard ahead [N].
VehicleState driven(const Sparus2::Params& params, const Leg& leg, const Water& water = {}) {
  return driven(Vehicle{Sparus2{params}}, {leg}, water);
}

TEST(Sparus2, MassMatrixIsThatOfTheTable) {
  // 52 + 2, 52 + 64.6, 52 + 68.5 kg; 0.5 + 0.015, 9.4 + 12.3, 9.5 + 12.3 kg m2
  fossen::Vector6 expected;
  expected << 54.0, 116.6, 120.5, 0.515, 21.7, 21.8;
  EXPECT_TRUE(Sparus2{{}}.body().mass().isApprox(fossen::Matrix6{expected.asDiagonal()}, 1e-15));
}

TEST(Sparus2, ThrustersPushWhereTheySit) {
  const Sparus2 sparus{{}};
  // port ahead turns to starboard: N = -y F = 0.17 F
  Eigen::Matrix<double, 6, 3> expected;
  expected.transpose() << 0, 0, 1, 0, 0, 0,  //
      1, 0, 0, 0, 0, 0.17,                   //
      1, 0, 0, 0, 0, -0.17;
  EXPECT_TRUE(sparus.propulsion().effectiveness.isApprox(expected, 1e-15));
}

TEST(Sparus2, FullHeaveThrustReachesThePublishedSpeeds) {
  const Sparus2 sparus{{}};
  const Range heave = sparus.actuators()[0].range;
  EXPECT_NEAR(heave.hi, 12.702, 0.001);  // 126 * 0.305^2 + 0.1 * 9.81
  EXPECT_NEAR(heave.lo, -6.277, 0.001);  // -(126 * 0.24^2 - 0.1 * 9.81)
  EXPECT_NEAR(driven({}, {60.0, {100.0, 0, 0}}).v_n().z(), 0.305, 0.005 * 0.305);
  EXPECT_NEAR(driven({}, {60.0, {-100.0, 0, 0}}).v_n().z(), -0.24, 0.005 * 0.24);
}

TEST(Sparus2, UncalibratedHeaveHasThePublishedThrust) {
  const Sparus2 sparus{{.heave_calibrated = false}};
  EXPECT_EQ(sparus.actuators()[0].range.hi, 55.0);
  EXPECT_EQ(sparus.actuators()[0].range.lo, -28.5);
}

TEST(Sparus2, WithoutThrustItRisesAtTheSpeedWhereDragHoldsItsBuoyancy) {
  // 126 w^2 = 0.1 * 9.81
  EXPECT_NEAR(driven({}, {120.0, {0, 0, 0}}).v_n().z(), -std::sqrt(0.981 / 126.0), 1e-4);
}

TEST(Sparus2, SteadySurgeIsWhereDragHoldsThrust) {
  // 14.2 u^2 = 2 * 5 N
  EXPECT_NEAR(driven(neutral(), {120.0, {0, 5.0, 5.0}}).v_b.x(), std::sqrt(10.0 / 14.2), 1e-6);
}

TEST(Sparus2, SteadyTurnOnTheSpotIsWhereDragHoldsTheMoment) {
  // 9.44 r^2 = 2 * 0.17 * 4 N m
  const VehicleState x = driven(neutral(), {120.0, {0, 4.0, -4.0}});
  EXPECT_NEAR(x.omega_b.z(), std::sqrt(2 * 0.17 * 4.0 / 9.44), 1e-6);
  EXPECT_LT(x.p_n.norm(), 1e-9);
}

TEST(Sparus2, DivesLevelWhileSurgingWithoutTheMunkMomentAndIsTurnedUpByIt) {
  const Leg ahead_and_down{120.0, {100.0, 1.0, 1.0}};
  const VehicleState level = driven({}, ahead_and_down);
  EXPECT_LT(std::abs(euler_of(level.q_nb).pitch), radians(0.1));
  EXPECT_NEAR(level.v_n().z(), 0.305, 0.002);

  // settles where (Z_wdot - X_udot) u w = 66.5 * 0.451 * 0.313 = 9.4 N m meets 52.1 * 9.81 * 0.02 sin(pitch)
  const VehicleState turned = driven({.munk_moment = true}, ahead_and_down);
  EXPECT_NEAR(degrees(euler_of(turned.q_nb).pitch), 66.5, 0.5);
  EXPECT_LT(turned.v_n().z(), -0.2);  // climbs under full thrust down
}

TEST(Sparus2, RollsUndampedAtTheFrequencyOfItsStability) {
  // I roll'' = -52.1 * 9.81 * 0.02 sin(roll): omega = sqrt(10.222 / 0.515) = 4.455 rad/s, quarter period
  // 0.3526 s
  Vehicle vehicle{Sparus2{{}}};
  VehicleState x;
  x.q_nb = quaternion_of({.roll = 0.01, .pitch = 0, .yaw = 0});
  vehicle.set_state(x);
  const double quarter = pi / 2 / std::sqrt(52.1 * 9.81 * 0.02 / 0.515);
  for (int i = 0; i < 100; ++i) vehicle.drift({}, quarter / 100);
  EXPECT_NEAR(euler_of(vehicle.state().q_nb).roll, 0.0, 1e-6);
  for (int i = 0; i < 3900; ++i) vehicle.drift({}, quarter / 100);
  EXPECT_NEAR(euler_of(vehicle.state().q_nb).roll, 0.01, 1e-5);  // ten periods later
}

TEST(Sparus2, DenserWaterLiftsAndBrakesMore) {
  const Water sea{.current_n = Vec3::Zero(), .density = 1025.0};
  const VehicleState x = driven({}, {60.0, {0, 0, 0}}, sea);
  EXPECT_NEAR(x.v_n().z(), -std::sqrt((52.1 * 1.025 - 52.0) * 9.81 / (126.0 * 1.025)), 1e-4);
}

TEST(Sparus2, PowerIsThatOfItsDisks) {
  const double area = pi / 4 * 0.13 * 0.13;
  const double expected = (std::pow(4.0, 1.5) + 2 * std::pow(9.0, 1.5)) / std::sqrt(2 * 1000.0 * area);
  EXPECT_NEAR(Sparus2{{}}.power(values({-4.0, 9.0, -9.0})), expected, 1e-12);
}

}  // namespace
}  // namespace fairway
