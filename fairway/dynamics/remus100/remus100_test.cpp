// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/remus100/remus100.hpp"

#include <gtest/gtest.h>

#include "fairway/dynamics/testing/held_actuators.hpp"

namespace fairway {
namespace {

VehicleState driven(const std::vector<Leg>& legs) { return driven(Vehicle{Remus100{{}}}, legs); }

constexpr double five_degrees = radians(5.0);

// The expected states at 100 s are those of the published equations, evaluated independently with Euler
// angles and a Runge-Kutta step of 0.01 s, to 9 digits, from rest. Measured over all twelve states: 4e-8 on
// straight runs, 4e-7 diving, 9e-7 in turns, where the drag coefficient jumps at its critical Reynolds
// number.
constexpr double tolerance = 5e-6;

TEST(Remus100, RunsStraightAsThePublishedModel) {
  const VehicleState cruise = driven({{100, {0, 0, 1000}}});
  EXPECT_NEAR(cruise.v_b.x(), 1.6642, 5e-5);
  EXPECT_LT(deviation(cruise, {1.66419516, 6.73921343e-07, 0, 1.72386594e-10, 0, 0, 164.704267, -0.0360504962,
                               0.259690558, 0.00748743779, 0, -0.000219993972}),
            tolerance);

  const VehicleState flat_out = driven({{100, {0, 0, 1525}}});
  EXPECT_NEAR(flat_out.v_b.x(), 2.5396, 5e-5);
  EXPECT_LT(deviation(flat_out, {2.53960549, 3.90154972e-06, 0, 9.98534251e-10, 0, 0, 252.232271,
                                 -0.165026281, 0.611680661, 0.0173985965, 0, -0.000660961347}),
            tolerance);
}

TEST(Remus100, TurnsAsThePublishedModel) {
  const VehicleState x = driven({{100, {five_degrees, 0, 1200}}});
  EXPECT_NEAR(x.v_b.x(), 1.9842, 5e-5);
  EXPECT_NEAR(x.v_b.y(), -0.1538, 5e-5);
  EXPECT_NEAR(x.omega_b.z(), 0.0495, 5e-5);
  EXPECT_LT(
      deviation(x, {1.98415948, -0.153768841, 0.000902158848, 0.000129778291, 0.00103065111, 0.0494991678,
                    -37.3155596, 34.8779723, 0.656266277, 0.0208185763, -0.00262125358, 4.92341072}),
      1e-3);
}

TEST(Remus100, ClimbsAndDivesAsThePublishedModel) {
  const VehicleState climb = driven({{100, {0, -five_degrees, 1200}}});
  EXPECT_NEAR(climb.p_n.z(), -38.4, 0.05);
  EXPECT_NEAR(euler_of(climb.q_nb).pitch, 0.215, 5e-4);
  EXPECT_LT(deviation(climb, {1.99429073, -1.46373472e-06, 0.021729273, -3.83321456e-10, 0, 0, 193.812161,
                              0.431001224, -38.4415076, 0.0110556242, 0.215340551, 0.00246705707}),
            tolerance);

  const VehicleState dive = driven({{100, {0, five_degrees, 1525}}});
  EXPECT_LT(deviation(dive, {2.53512758, 1.17410142e-05, -0.027855237, 3.20660842e-09, 0, 0, 237.764733,
                             -1.80554043, 82.3171385, 0.0185796063, -0.352550912, -0.00813112159}),
            tolerance);
}

TEST(Remus100, FollowsThePublishedModelThroughAMixedManoeuvre) {
  const VehicleState x =
      driven({{20, {0, 0, 1200}}, {30, {0.1, 0.05, 1200}}, {30, {-0.2, -0.08, 1400}}, {20, {0, 0, 900}}});
  EXPECT_LT(deviation(x, {1.49720511, 0.0145013504, -5.8933739e-08, 1.33948457e-05, 3.59036049e-07, 0,
                          65.9427369, 24.2505531, -6.8587549, 0.00594738213, -2.14614625e-06, -3.05178731}),
            tolerance);
}

TEST(Remus100, MassIsThatOfThePublishedSpheroid) {
  Wrench expected;
  expected << 32.7638171, 62.1941208, 62.1941208, 0.165391892, 7.82734872, 7.81458851;
  EXPECT_LT((Remus100{{}}.mass().diagonal() - expected).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(Remus100, LiesStillWithoutThrust) {
  const VehicleState x = driven({{100, {0.1, -0.1, 0}}});
  EXPECT_EQ(x.p_n, Vec3::Zero());
  EXPECT_EQ(x.v_b, Vec3::Zero());
}

TEST(Remus100, PortAndStarboardAreMirrorImagesWithoutThePropeller) {
  Vehicle coasting{Remus100{{}}};
  VehicleState start;
  start.v_b.x() = 2.0;
  coasting.set_state(start);
  const VehicleState port = driven(coasting, {{10, {-0.2, 0.05, 0}}});
  const VehicleState starboard = driven(coasting, {{10, {0.2, 0.05, 0}}});
  EXPECT_LT(deviation(port, mirrored(starboard)), 1e-12);
  EXPECT_GT(starboard.p_n.y(), 0.5);
}

TEST(Remus100, WaterOnlyTakesEnergyFromIt) {
  // when level gravity does no work
  const Remus100 remus{{}};
  expect_water_to_take_energy(Vehicle{remus}, remus.mass(), {});
}

TEST(Remus100, ActuatorsHaveThePublishedLimits) {
  const Remus100 remus{{}};
  const std::span<const ActuatorInfo> fitted = remus.actuators();
  EXPECT_EQ(fitted[0].range.hi, radians(20.0));
  EXPECT_EQ(fitted[1].range.lo, -radians(20.0));
  EXPECT_EQ(fitted[2].range.hi, 1525.0);
  EXPECT_EQ(Vehicle{remus}.propulsion(), nullptr);
}

TEST(Remus100, TellsAutopilotsWhatItsDerivativeDoes) {
  const Remus100 remus{{}};
  const FinDrive& drive = remus.fin_drive();
  EXPECT_EQ(remus.actuators()[drive.propeller].name, "n_rpm");
  EXPECT_EQ(remus.actuators()[drive.rudder].name, "rudder_rad");
  EXPECT_EQ(remus.actuators()[drive.stern].name, "stern_rad");

  // steady speed and how fast it is come to: the published ones, without the little surge damping
  EXPECT_NEAR(1000 * drive.speed_per_turn, 1.6642, 0.002);
  EXPECT_NEAR(1525 * drive.speed_per_turn, 2.5396, 0.002);
  VehicleState x;
  x.v_b.x() = 1.5;
  const double n = 1.02 * 1.5 / drive.speed_per_turn;
  const double gathering = remus.derivative(x, values({0, 0, n}), {}).v_b.x();
  EXPECT_NEAR(gathering, 0.02 * 1.5 * 1.5 / drive.surge_distance, 0.05 * gathering);

  // moments by finite differences; a fin turned moves sway and heave too, through the centre of gravity
  const auto force = [&](const ActuatorValues& u) -> Wrench {
    return remus.mass() * acceleration(remus.derivative(x, u, {}));
  };
  const Wrench change = force(values({0.01, 0.02, 0})) - force(values({0, 0, 0}));
  EXPECT_NEAR(change[5], drive.rudder_moment * 1.5 * 1.5 * 0.01, 1e-9);
  EXPECT_NEAR(change[4], drive.stern_moment * 1.5 * 1.5 * 0.02, 1e-9);
  EXPECT_EQ(drive.yaw_inertia, remus.mass()(5, 5));
  EXPECT_EQ(drive.pitch_inertia, remus.mass()(4, 4));

  // at rest, pitched and turning
  x = {.q_nb = quaternion_of({.pitch = 0.1})};
  x.omega_b = {0.0, 0.0, 0.001};
  const Wrench still = force(values({0, 0, 0}));
  EXPECT_NEAR(still[4], -drive.pitch_restoring * std::sin(0.1), 1e-4);
  EXPECT_NEAR(still[5], -drive.yaw_damping * 0.001, 1e-4);
}

TEST(Remus100, PowerIsThatOfTheShaftAtTheDesignPoint) {
  // 2 pi n Q with Q = 0.0312 * 1026 * 0.14^5 n^2, n = 25.417 / s
  const double n = 1525.0 / 60.0;
  const double expected = 2 * pi * n * 0.0312 * 1026 * std::pow(0.14, 5) * n * n;
  EXPECT_NEAR(Remus100{{}}.power(values({0, 0, 1525})), expected, 1e-12 * expected);
}

}  // namespace
}  // namespace fairway
