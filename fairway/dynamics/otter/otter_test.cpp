// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/otter/otter.hpp"

#include <gtest/gtest.h>

#include "fairway/dynamics/testing/held_actuators.hpp"

namespace fairway {
namespace {

VehicleState driven(const std::vector<Leg>& legs, const Otter::Params& params = {}, const Water& water = {}) {
  return driven(Vehicle{Otter{params}}, legs, water);
}

const std::vector<Leg> all_sorts{
    {20, {90, 60}}, {20, {60, 90}}, {20, {100, -50}}, {20, {-80, -40}}, {20, {70, 70}}};

// The expected states at 100 s are those of the published equations, evaluated independently with Euler
// angles and a Runge-Kutta step of 0.01 s, to 9 digits. Both start in the waterline of the empty boat, level.
// Measured: at most 1.4e-7 over all twelve states, 3e-8 where the distance has more digits.
constexpr double tolerance = 1e-6;

TEST(Otter, MassMatrixIsThePublishedOne) {
  // payload at the origin, as printed by the model when it is asked for its matrices
  const OtterHull hull{{.payload_x_m = 0.0, .payload_z_m = 0.0}};
  Wrench expected;
  expected << 85.281521, 162.5, 135.0, 14.654684, 30.25, 40.49375;
  EXPECT_LT((hull.mass().diagonal() - expected).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Otter, PropellersTurnWithinThePublishedLimits) {
  const Otter otter{{}};
  ASSERT_EQ(otter.actuators().size(), 2U);
  for (const ActuatorInfo& propeller : otter.actuators()) {
    EXPECT_NEAR(propeller.range.lo, -101.74, 5e-3);
    EXPECT_NEAR(propeller.range.hi, 103.93, 5e-3);
    EXPECT_EQ(propeller.time_constant_s, 0.1);
    EXPECT_NEAR(Otter::thrust(propeller.range.hi), OtterHull::max_ahead_n, 1e-12);
    EXPECT_NEAR(Otter::thrust(propeller.range.lo), -OtterHull::max_astern_n, 1e-12);
  }
}

TEST(Otter, RunsStraightWhereDragHoldsThrust) {
  const VehicleState x = driven({{100, {60, 60}}});
  EXPECT_NEAR(x.v_b.x(), 0.02216 * 60 * 60 / (24.4 * 9.81 / 3.0864), 1e-9);  // 79.776 / 77.554 = 1.0286
  EXPECT_LT(deviation(x, {1.02864527, 0, 0, 0, 0, 0, 101.739094, 0, 0.0377126086, 0, -0.0260164426, 0}),
            tolerance);

  // both propellers at their limit: 6 knots
  EXPECT_NEAR(driven({{100, {200, 200}}}).v_b.x(), 3.0864, 1e-9);
}

TEST(Otter, TurnsAsThePublishedModel) {
  const VehicleState x = driven({{100, {80, 60}}});
  EXPECT_NEAR(x.v_b.x(), 1.3998, 5e-5);
  EXPECT_NEAR(x.v_b.y(), -0.0965, 5e-5);
  EXPECT_NEAR(x.omega_b.z(), 0.1636, 5e-5);
  EXPECT_LT(
      deviation(x, {1.39982772, -0.096468584, -0.000219178407, -2.70835578e-05, -0.000764763611, 0.163626282,
                    -3.3686383, 16.4400842, 0.0376834144, -0.00512879697, -0.0258446687, 16.220345}),
      tolerance);

  const VehicleState spin = driven({{100, {60, -60}}});
  EXPECT_NEAR(spin.omega_b.z(), 0.1919, 5e-5);
  EXPECT_LT(deviation(spin, {0.214097505, -0.0170887359, -1.40425423e-05, -2.58506776e-07, -0.000160926245,
                             0.191894059, 0.158269075, 0.00419564724, 0.0377130524, -0.000920258323,
                             -0.0260150363, 19.1456822}),
            tolerance);
}

TEST(Otter, FollowsThePublishedModelThroughAllSortsOfManoeuvres) {
  EXPECT_LT(deviation(driven(all_sorts), {1.39888453, -0.0217874828, -1.09754629e-05, -2.32196856e-05,
                                          -2.81358685e-05, 0.0317929754, -40.1017641, 19.8192931,
                                          0.0377117435, -0.000985391506, -0.0260100157, 3.74351707}),
            tolerance);
}

TEST(Otter, FollowsThePublishedModelInACurrent) {
  // 0.3 m/s towards 30 degrees
  const Water water{.current_n = {0.3 * std::cos(pi / 6), 0.3 * std::sin(pi / 6), 0.0}, .density = 1025.0};
  EXPECT_LT(
      deviation(driven(all_sorts, {}, water),
                {1.09977933, 0.00136592051, 8.63681166e-06, -2.32693386e-05, -2.73576464e-05, 0.0317933302,
                 -14.3981229, 34.7101944, 0.0377098629, -0.000985413691, -0.0260085027, 3.74244719}),
      tolerance);
}

TEST(Otter, FollowsThePublishedModelWithOtherPayloads) {
  EXPECT_LT(
      deviation(
          driven(all_sorts, {.payload_kg = 40, .payload_x_m = -0.1, .payload_y_m = 0.1, .payload_z_m = -0.4}),
          {1.39733603, -0.0306006537, -2.59295965e-05, -3.75931551e-06, -7.55121072e-05, 0.041981481,
           -36.3138823, 19.682693, 0.0555200178, 0.0521907441, -0.0178290758, 4.10500511}),
      tolerance);
  EXPECT_LT(
      deviation(driven(all_sorts, {.payload_kg = 0, .payload_x_m = 0, .payload_z_m = 0}),
                {1.39978569, -0.0112077961, -1.73265659e-06, -5.54624728e-06, -5.0569089e-06, 0.0189615168,
                 -40.3087708, 11.2841435, -1.15694484e-07, -0.000269076386, 9.21498263e-07, 3.84784462}),
      tolerance);
}

/// Time [s] and way [m] from the steady speed of 80 rad/s to standstill with the propellers at -80 rad/s.
std::pair<double, double> crash_stop(const Otter::Params& params) {
  Vehicle vehicle{Otter{params}};
  const ActuatorValues ahead = values({80, 80}), astern = values({-80, -80});
  for (int i = 0; i < 20000; ++i) vehicle.step(ahead, {}, 0.005);
  EXPECT_NEAR(vehicle.state().v_b.x(), 1.829, 5e-4);

  const double start = vehicle.state().p_n.x();
  double time = 0.0;
  for (; vehicle.state().v_b.x() > 0.0; time += 0.005) vehicle.step(astern, {}, 0.005);
  return {time, vehicle.state().p_n.x() - start};
}

TEST(Otter, StopsWithinHalfItsLength) {
  // T = 85.28 / 77.55 = 1.100 s towards -82.5 / 155.1 = -1.064 m/s: T ln(2.893 / 1.064) = 1.10 s and
  // 1.829 T - 1.064 * 1.10 = 0.841 m
  const auto [time, way] = crash_stop({.propeller_time_constant_s = 0.0});
  EXPECT_NEAR(time, 1.10, 0.01);
  EXPECT_NEAR(way, 0.84, 0.005);

  // the lag of the propellers costs its 0.1 s, at 1.6 m/s
  const auto [lagging_time, lagging_way] = crash_stop({});
  EXPECT_NEAR(lagging_time, 1.2, 0.01);
  EXPECT_NEAR(lagging_way, 1.0036, 0.005);
}

TEST(Otter, LiesStillWhereItFloats) {
  for (const Otter::Params& params :
       {Otter::Params{}, Otter::Params{.payload_kg = 45, .payload_y_m = 0.5, .payload_z_m = -1}}) {
    Vehicle vehicle{Otter{params}};
    const VehicleState floating = OtterHull{params}.floating();
    vehicle.set_state(floating);
    const VehicleState x = driven(vehicle, {{100, {0, 0}}});
    EXPECT_LT((x.p_n - floating.p_n).norm(), 1e-12);
    EXPECT_LT(x.v_b.norm() + x.omega_b.norm(), 1e-12);
    EXPECT_LT(x.q_nb.angularDistance(floating.q_nb), 1e-12);
  }
  EXPECT_NEAR(OtterHull{{}}.floating().p_n.z(), 0.0377126, 1e-7);
}

TEST(Otter, LiesOnTheSurfaceOfTheWater) {
  // lifted by 0.3 m, on a slope: it floats to that surface as to the calm one
  const Water water{.elevation = 0.3, .slope_n = {0.04, -0.03}};
  for (const double yaw : {0.0, 1.0, -2.5}) {
    const VehicleState calm = OtterHull{{}}.floating();
    Vehicle vehicle{Otter{{}}};
    VehicleState start = calm;
    start.q_nb = quaternion_of({.yaw = yaw}) * calm.q_nb;
    vehicle.set_state(start);
    const VehicleState x = driven(vehicle, {{60, {0, 0}}}, water);
    EXPECT_NEAR(x.p_n.z(), calm.p_n.z() - 0.3, 1e-3);
    const Vec3 normal_b = x.q_nb.conjugate() * Vec3{0.04, -0.03, 1.0}.normalized();
    EXPECT_LT((normal_b - calm.q_nb.conjugate() * Vec3::UnitZ()).norm(), 1e-3) << yaw;
    EXPECT_LT(x.v_b.norm() + x.omega_b.norm(), 1e-3);
  }
}

TEST(Otter, RisesWithTheWaterThatItFloatsIn) {
  // the surface rises at 0.2 m/s: so does the boat, and lies in it as at rest
  Vehicle vehicle{Otter{{}}};
  vehicle.set_state(OtterHull{{}}.floating());
  for (int i = 0; i < 3000; ++i)
    vehicle.drift({.current_n = {0, 0, -0.2}, .elevation = 0.2 * 0.01 * (i + 0.5)}, 0.01);
  EXPECT_NEAR(vehicle.state().p_n.z(), OtterHull{{}}.floating().p_n.z() - 6.0, 2e-3);
  EXPECT_NEAR(vehicle.state().v_b.z(), -0.2, 1e-3);
}

TEST(Otter, PortAndStarboardAreMirrorImages) {
  const VehicleState port = driven({{30, {90, 20}}, {30, {-70, 40}}});
  const VehicleState starboard = driven({{30, {20, 90}}, {30, {40, -70}}});
  EXPECT_LT(deviation(port, mirrored(starboard)), 1e-12);
  EXPECT_GT(std::abs(port.p_n.y()), 1.0);
}

TEST(Otter, WaterOnlyTakesEnergyFromIt) {
  // at the attitude it floats at, G (eta - eta_0) = 0
  const OtterHull hull{{}};
  expect_water_to_take_energy(Vehicle{Otter{{}}}, hull.mass(), hull.floating());
}

TEST(Otter, ATopHeavyLoadIsRefused) {
  EXPECT_THROW((Otter{{.payload_kg = 45, .payload_z_m = -5}}), InputError);
}

TEST(Otter, ByThrustItIsTheSameBoat) {
  const double port = Otter::thrust(80), starboard = Otter::thrust(-40);
  const VehicleState by_thrust = driven(Vehicle{OtterByThrust{{}}}, {{60, {port, starboard}}});
  const VehicleState by_speed = driven({{60, {80, -40}}});
  EXPECT_EQ(by_thrust.p_n, by_speed.p_n);
  EXPECT_EQ(by_thrust.v_b, by_speed.v_b);

  EXPECT_EQ(OtterByThrust{{}}.power(values({port, starboard})), Otter{{}}.power(values({80, -40})));
}

TEST(Otter, ByThrustItsDragAheadIsThatOfItsPropulsion) {
  // there are no strips in surge
  const OtterByThrust otter{{}};
  VehicleState ahead = OtterHull{{}}.floating();
  ahead.v_b.x() = 1.5;
  const Wrench braked = otter.propulsion().mass * acceleration(otter.derivative(ahead, values({0, 0}), {}));
  EXPECT_NEAR(braked[0], -1.5 * otter.propulsion().linear_damping[0], 1e-10);
}

TEST(Otter, PowerIsThatOfItsDisks) {
  const double ahead = 0.01108 * 3600, astern = 0.006445 * 3600;
  const double expected =
      (std::pow(ahead, 1.5) + std::pow(astern, 1.5)) / std::sqrt(2 * 1025.0 * pi / 4 * 0.04);
  EXPECT_NEAR(Otter{{}}.power(values({60, -60})), expected, 1e-12 * expected);
}

}  // namespace
}  // namespace fairway
