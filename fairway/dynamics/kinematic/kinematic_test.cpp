// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/kinematic/kinematic.hpp"

#include <gtest/gtest.h>

#include "fairway/core/rng.hpp"
#include "fairway/dynamics/testing/held_actuators.hpp"

namespace fairway {
namespace {

TEST(Kinematic, KeepsItsLimitsForAnySetpoints) {
  Rng rng{1};
  const Kinematic::Params p{.max_speed_mps = 1.5,
                            .max_reverse_mps = 0.3,
                            .max_heave_mps = 0.4,
                            .max_turn_rate_radps = 0.6,
                            .max_acceleration_mps2 = 0.3,
                            .max_turn_acceleration_radps2 = 0.2};
  Vehicle vehicle{Kinematic{p}};
  const double h = 0.05, slack = 1e-9;
  ActuatorValues u = values({0, 0, 0});
  for (int i = 0; i < 20000; ++i) {
    if (rng.uniform(0, 1) < 0.05) u = 5.0 * values({rng.normal(), rng.normal(), rng.normal()});
    const VehicleState before = vehicle.state();
    vehicle.step(u, {}, h);
    const VehicleState& x = vehicle.state();
    ASSERT_LE(x.v_b.x(), p.max_speed_mps + slack);
    ASSERT_GE(x.v_b.x(), -p.max_reverse_mps - slack);
    ASSERT_LE(std::abs(x.v_b.z()), p.max_heave_mps + slack);
    ASSERT_LE(std::abs(x.omega_b.z()), p.max_turn_rate_radps + slack);
    ASSERT_LE((x.v_b - before.v_b).norm(), p.max_acceleration_mps2 * h + slack);
    ASSERT_LE(std::abs(x.omega_b.z() - before.omega_b.z()), p.max_turn_acceleration_radps2 * h + slack);
    ASSERT_EQ(x.v_b.y(), 0.0);
    ASSERT_NEAR(euler_of(x.q_nb).roll, 0.0, 1e-12);
    ASSERT_NEAR(euler_of(x.q_nb).pitch, 0.0, 1e-12);
  }
}

TEST(Kinematic, ReachesASetpointWithoutOvershootOrChatterAtAnyStableStep) {
  for (const double h : {0.01, 0.05, 0.2, 0.5}) {
    Vehicle vehicle{Kinematic{{}}};
    const ActuatorValues u = values({0.5, 0.3, -0.4});
    VehicleState before = vehicle.state();
    for (double t = 0.0; t < 20.0; t += h) {
      vehicle.step(u, {}, h);
      const VehicleState& x = vehicle.state();
      EXPECT_GE(x.v_b.x(), before.v_b.x());
      EXPECT_LE(x.v_b.x(), 0.5 + 1e-12);
      EXPECT_LE(x.omega_b.z(), before.omega_b.z());
      EXPECT_GE(x.omega_b.z(), -0.4 - 1e-12);
      before = x;
    }
    EXPECT_NEAR(before.v_b.x(), 0.5, 1e-6) << "h " << h;
    EXPECT_NEAR(before.v_b.z(), 0.3, 1e-6) << "h " << h;
    EXPECT_NEAR(before.omega_b.z(), -0.4, 1e-6) << "h " << h;
  }
}

TEST(Kinematic, SteadyTurnIsACircleOfSpeedOverTurnRate) {
  Vehicle vehicle{Kinematic{{}}};
  VehicleState x;
  x.v_b = {0.5, 0, 0};
  x.omega_b = {0, 0, 0.25};
  vehicle.set_state(x);
  const int steps = 1000;
  const double half_turn = pi / 0.25;
  for (int i = 0; i < steps; ++i) vehicle.step(values({0.5, 0, 0.25}), {}, half_turn / steps);
  EXPECT_NEAR(vehicle.state().p_n.x(), 0.0, 1e-8);
  EXPECT_NEAR(vehicle.state().p_n.y(), 2 * 0.5 / 0.25, 1e-8);
}

TEST(Kinematic, LevelInStillWaterItGoesToTheBitAsByTheFullEquations) {
  const auto expect_same = [](const Vec3& a, const Vec3& b) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      EXPECT_EQ(a[i], b[i]);
      EXPECT_EQ(std::signbit(a[i]), std::signbit(b[i]));
    }
  };
  Rng rng{2};
  for (const double most_sway : {0.0, 0.4}) {
    const Kinematic model{{.max_sway_mps = most_sway}};
    VehicleState x;
    x.q_nb = quaternion_of({.yaw = 2.5});
    for (int i = 0; i < 5000; ++i) {
      const ActuatorValues u = values({rng.normal(), rng.normal(), rng.normal(), rng.normal()});
      const VehicleState full = rk4(model, x, u, Water{}, 0.05);
      x = model.advanced(x, u, Water{}, 0.05);
      expect_same(x.p_n, full.p_n);
      expect_same(x.q_nb.vec(), full.q_nb.vec());
      EXPECT_EQ(x.q_nb.w(), full.q_nb.w());
      expect_same(x.v_b, full.v_b);
      expect_same(x.omega_b, full.omega_b);
    }
  }
}

TEST(Kinematic, HeeledOrInACurrentItGoesByTheFullEquations) {
  const Kinematic model{{}};
  const ActuatorValues u = values({0.5, 0.1, 0.2});
  VehicleState heeled;
  heeled.q_nb = quaternion_of({.roll = 0.3, .yaw = 1.0});
  heeled.v_b = {0.3, 0.0, 0.1};
  const Water current{.current_n = {0.1, 0.2, 0.0}};
  EXPECT_EQ(model.advanced(heeled, u, Water{}, 0.05).p_n, rk4(model, heeled, u, Water{}, 0.05).p_n);
  EXPECT_EQ(model.advanced({}, u, current, 0.05).v_b, rk4(model, {}, u, current, 0.05).v_b);
}

TEST(Kinematic, HasNoSwayActuatorUnlessItIsGivenSway) {
  EXPECT_EQ(Kinematic{{}}.actuators().size(), 3U);
  EXPECT_EQ(Kinematic{{.max_sway_mps = 1.0}}.actuators().back().name, "sway_mps");
}

TEST(Kinematic, WithSwayGoesAnyWayWithinOneLimitOfAcceleration) {
  const Kinematic::Params p{
      .max_speed_mps = 10.0, .max_sway_mps = 10.0, .max_acceleration_mps2 = 2.0, .time_constant_s = 0.02};
  Vehicle vehicle{Kinematic{p}};
  const ActuatorValues u = values({3.0, 0.0, 0.0, -4.0});
  for (int i = 0; i < 50; ++i) vehicle.step(u, {}, 0.02);
  EXPECT_NEAR(vehicle.state().v_b.norm(), 2.0, 1e-9);  // 2 m/s2 for a second
  for (int i = 0; i < 150; ++i) vehicle.step(u, {}, 0.02);
  EXPECT_NEAR(vehicle.state().v_b.x(), 3.0, 1e-6);
  EXPECT_NEAR(vehicle.state().v_b.y(), -4.0, 1e-6);
  EXPECT_NEAR(yaw_of(vehicle.state().q_nb), 0.0, 1e-12);
}

}  // namespace
}  // namespace fairway
