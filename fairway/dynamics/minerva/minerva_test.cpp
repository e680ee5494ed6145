// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/minerva/minerva.hpp"

#include <gtest/gtest.h>

#include "fairway/dynamics/testing/held_actuators.hpp"

namespace fairway {
namespace {

/// From rest, by lateral, vertical port and starboard, main port and starboard thrust [N].
VehicleState driven(const Minerva::Params& params, const Leg& leg, const Water& water = {}) {
  return driven(Vehicle{Minerva{params}}, {leg}, water);
}

constexpr Minerva::Params paper_compat{.plant = MinervaPlant::paper_compat};

TEST(Minerva, MassAndDampingAreThoseOfTheTable) {
  // 460 + 293, 460 + 302, 460 + 326; 50.31 + 460 * 0.15^2 + 52, 104.02 + 460 * 0.15^2 + 52, 105.26 + 57
  const Minerva minerva{{}};
  fossen::Vector6 mass, linear, quadratic;
  mass << 753.0, 762.0, 786.0, 112.66, 166.37, 162.26;
  linear << 29, 41, 254, 34, 59, 45;
  quadratic << 292, 584, 635, 84, 148, 100;
  EXPECT_TRUE(minerva.body().mass().diagonal().isApprox(mass, 1e-12));
  EXPECT_NEAR(minerva.body().mass()(0, 4), 460.0 * 0.15, 1e-12);  // surge pitches a low centre of gravity
  EXPECT_TRUE(minerva.propulsion().linear_damping.isApprox(linear, 1e-14));
  EXPECT_TRUE(minerva.propulsion().quadratic_damping.isApprox(quadratic, 1e-14));
}

TEST(Minerva, PaperCompatSwapsTheInertiasAsTheFileDoesAndHasLinearDragAlone) {
  const Minerva minerva{paper_compat};
  EXPECT_NEAR(minerva.body().mass()(5, 5), 50.31 + 57.0, 1e-12);
  EXPECT_TRUE(minerva.propulsion().quadratic_damping.isZero(0.0));
  const VehicleState x = driven(paper_compat, {400.0, {0, 0, 0, 20.0, 20.0}});
  EXPECT_NEAR(x.v_b.x(), 0.985 * 40.0 / 29.0, 1e-5);  // e^(-400 * 29 / 753) = 2e-7 is left
}

TEST(Minerva, ThrustLimitsAreThoseOfItsPropellersAtTwelveHundredTurns) {
  // rho D^4 K_T theta n^2: 1025 * 0.19^4 * 0.24 * 1.04 * 400 and so on
  const Minerva minerva{{}};
  const auto range = [&](std::size_t i) { return minerva.actuators()[i].range; };
  EXPECT_NEAR(range(0).hi, 133.4, 0.05);
  EXPECT_NEAR(range(0).lo, -83.4, 0.05);
  EXPECT_NEAR(range(1).hi, 133.7, 0.05);
  EXPECT_NEAR(range(2).lo, -83.6, 0.05);
  EXPECT_NEAR(range(3).hi, 166.0, 0.05);
  EXPECT_NEAR(range(4).lo, -76.4, 0.05);
  // 1450 turns: two mains ahead give 477 N
  const Minerva faster{{.max_propeller_speed_hz = 1450.0 / 60.0}};
  EXPECT_NEAR(2 * 0.985 * faster.actuators()[3].range.hi, 477.0, 0.5);
}

TEST(Minerva, ThrustersPushWhereTheySit) {
  Eigen::Matrix<double, 6, 5> expected;
  expected.transpose() << 0, 1, 0, 0, 0, 0.166,  //
      0, 0, 1, -0.20, 0, 0,                      //
      0, 0, 1, 0.20, 0, 0,                       //
      0.985, -0.174, 0, 0, 0, 0.335,             //
      0.985, 0.174, 0, 0, 0, -0.335;
  const Minerva minerva{{}};
  EXPECT_TRUE(minerva.propulsion().effectiveness.isApprox(expected, 1e-15));
}

TEST(Minerva, SteadySurgeIsWhereDragHoldsThrust) {
  // 29 u + 292 u^2 = 0.985 * 160 N
  const double u = (-29.0 + std::sqrt(29.0 * 29.0 + 4.0 * 292.0 * 157.6)) / (2.0 * 292.0);
  const VehicleState x = driven({.degrees_of_freedom = DegreesOfFreedom::planar}, {120.0, {0.0, 80.0, 80.0}});
  EXPECT_NEAR(x.v_b.x(), u, 1e-9);
}

TEST(Minerva, PlanarHasNoVerticalThrusters) {
  const Minerva minerva{{.degrees_of_freedom = DegreesOfFreedom::planar}};
  ASSERT_EQ(minerva.actuators().size(), 3U);
  EXPECT_EQ(minerva.actuators()[0].name, "lateral_n");
  EXPECT_EQ(minerva.actuators()[1].name, "main_port_n");
  EXPECT_EQ(minerva.actuators()[2].name, "main_starboard_n");
}

TEST(Minerva, IsTrimmedAndRightsItself) {
  EXPECT_TRUE(Minerva{{}}.propulsion().restoring.isZero(1e-9));
  const VehicleState still = driven({}, {60.0, {0, 0, 0, 0, 0}}, {.density = 1000.0});
  EXPECT_LT(still.p_n.norm(), 1e-9);

  Vehicle vehicle{Minerva{{}}};
  VehicleState x;
  x.q_nb = quaternion_of({.roll = 0.3, .pitch = -0.2, .yaw = 0.0});
  vehicle.set_state(x);
  for (int i = 0; i < 2000; ++i) vehicle.drift({}, 0.05);
  EXPECT_LT(std::abs(euler_of(vehicle.state().q_nb).roll), 1e-4);
  EXPECT_LT(std::abs(euler_of(vehicle.state().q_nb).pitch), 1e-4);
}

TEST(Minerva, PowerIsThatOfItsDisks) {
  const double lateral = pi / 4 * 0.19 * 0.19, main = pi / 4 * 0.22 * 0.22;
  const double expected = std::pow(9.0, 1.5) / std::sqrt(2 * 1025.0 * lateral) +
                          2 * std::pow(16.0, 1.5) / std::sqrt(2 * 1025.0 * main);
  EXPECT_NEAR(Minerva{{}}.power(values({-9.0, 0, 16.0, 16.0, 0})), expected, 1e-12);
}

}  // namespace
}  // namespace fairway
