// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/minerva_transport/minerva_transport.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/dynamics/catalog.hpp"

namespace fairway {
namespace {

using fossen::Matrix6;
using testing::HasSubstr;
using testing::ThrowsMessage;
using Params = MinervaTransport::Params;
using Station = MinervaTransport::Station;

constexpr int surge = 0, sway = 1, yaw = 5;

Params aligned() {
  Params params;
  for (Station& station : params.layout) station.yaw_deg = 0.0;
  return params;
}

Params with_layout(std::vector<Station> layout) {
  Params params;
  params.layout = std::move(layout);
  return params;
}

/// Expects surge, sway and yaw of a diagonal within 0.5 % of the hand-derived table.
void expect_table(const fossen::Vector6& diagonal, double x, double y, double n) {
  EXPECT_NEAR(diagonal[surge] / x, 1.0, 0.005);
  EXPECT_NEAR(diagonal[sway] / y, 1.0, 0.005);
  EXPECT_NEAR(diagonal[yaw] / n, 1.0, 0.005);
}

TEST(MinervaTransport, RadialLayoutHasTheMassAndDragDerivedByHand) {
  // the file's inertias are those of paper_compat, whose quadratic drag is off
  Params params;
  params.plant = MinervaPlant::paper_compat;
  expect_table(MinervaTransport{params}.body().mass().diagonal(), 4800, 4800,
               16285);  // measured 4800.3, 16285
  const MinervaTransport physical{Params{}};
  expect_table(physical.propulsion().linear_damping, 140, 140, 1018);        // measured 140, 1017.6
  expect_table(physical.propulsion().quadratic_damping, 2403, 2403, 27680);  // measured 2402.9, 27667
}

TEST(MinervaTransport, AlignedLayoutHasTheMassAndDragDerivedByHand) {
  Params params = aligned();
  params.plant = MinervaPlant::paper_compat;
  expect_table(MinervaTransport{params}.body().mass().diagonal(), 4782, 4818, 16193);
  const MinervaTransport physical{aligned()};
  expect_table(physical.propulsion().linear_damping, 116, 164, 895);
  expect_table(physical.propulsion().quadratic_damping, 1819, 2987, 20939);
}

TEST(MinervaTransport, YawInertiaOfTheHullAddsOnePointThreePercent) {
  Params params;
  const double physical = MinervaTransport{params}.body().mass()(yaw, yaw);
  params.plant = MinervaPlant::paper_compat;
  EXPECT_NEAR(physical - MinervaTransport{params}.body().mass()(yaw, yaw), 4 * (105.26 - 50.31), 1e-9);
}

TEST(MinervaTransport, SurgeSwayAndYawOfTheCrossAreNotCoupled) {
  const MinervaTransport transport{Params{}};
  for (const Matrix6& matrix : {transport.body().mass(), transport.body().linear_damping()}) {
    for (const auto& [i, k] : {std::pair{surge, sway}, {surge, yaw}, {sway, yaw}}) {
      EXPECT_NEAR(matrix(i, k), 0.0, 1e-11);  // measured 6e-15
    }
  }
}

TEST(MinervaTransport, ThrustersPushWhereTheySit) {
  Eigen::Matrix<double, 3, 12> expected;
  expected << 0, .985, .985, -1, .174, -.174, 0, -.985, -.985, 1, -.174, .174,  //
      1, -.174, .174, 0, .985, .985, -1, .174, -.174, 0, -.985, -.985,          //
      2.426, -.05824, .05824, 2.426, -.05824, .05824, 2.426, -.05824, .05824, 2.426, -.05824, .05824;
  const MinervaTransport transport{Params{}};
  const auto& B = transport.propulsion().effectiveness;
  ASSERT_EQ(B.cols(), 12);
  EXPECT_TRUE(B.topRows<2>().isApprox(expected.topRows<2>(), 1e-14));
  EXPECT_TRUE(B.row(yaw).isApprox(expected.row(2), 1e-14));
  EXPECT_TRUE(B.middleRows<3>(2).isZero(0.0));
}

TEST(MinervaTransport, ActuatorsAreNamedAfterTheirVehicle) {
  const MinervaTransport planar{Params{}};
  ASSERT_EQ(planar.actuators().size(), 12U);
  EXPECT_EQ(planar.actuators()[0].name, "vehicle0_lateral_n");
  EXPECT_EQ(planar.actuators()[11].name, "vehicle3_main_starboard_n");
  Params params;
  params.degrees_of_freedom = DegreesOfFreedom::six;
  const MinervaTransport six{params};
  ASSERT_EQ(six.actuators().size(), 20U);
  EXPECT_EQ(six.actuators()[6].name, "vehicle1_vertical_port_n");
}

TEST(MinervaTransport, SteadySpeedIsWhereDragHoldsThrust) {
  Params params;
  params.plant = MinervaPlant::paper_compat;
  const MinervaTransport linear{params};
  Vehicle vehicle{linear};
  ActuatorValues u = ActuatorValues::Zero(12);
  u[1] = u[2] = 35.0;  // both mains of vehicle 0
  vehicle.set_actuator_state(u);
  for (int i = 0; i < 12000; ++i) vehicle.drift({}, 0.05);
  EXPECT_NEAR(vehicle.state().v_b.x(), 70.0 * 0.985 / 140.0, 1e-6);  // 0.4925 m/s, measured 1e-8 off

  Vehicle physical{MinervaTransport{Params{}}};
  physical.set_actuator_state(u);
  for (int i = 0; i < 12000; ++i) physical.drift({}, 0.05);
  const double d_q = MinervaTransport{Params{}}.propulsion().quadratic_damping[surge];
  const double speed = physical.state().v_b.x();
  EXPECT_NEAR(140.0 * speed + d_q * speed * speed, 70.0 * 0.985, 1e-6);
}

TEST(MinervaTransport, InPaperCompatAPureForceMovesItStraightWhileItTurns) {
  // without Coriolis terms body velocities do not exchange: u' = X / m whatever r
  Params params;
  params.plant = MinervaPlant::paper_compat;
  const MinervaTransport transport{params};
  VehicleState turning;
  turning.v_b = {0.5, 0.0, 0.0};
  turning.omega_b = {0.0, 0.0, 0.3};
  const StateRate rate = transport.derivative(turning, ActuatorValues::Zero(12), {});
  EXPECT_NEAR(rate.v_b.y(), 0.0, 1e-12);
  const StateRate physical = MinervaTransport{Params{}}.derivative(turning, ActuatorValues::Zero(12), {});
  EXPECT_NEAR(physical.v_b.y(), -0.15, 1e-12);  // -r u: the isotropic body keeps its way in NED
}

TEST(MinervaTransport, DeadThrustersPushNothingAndAreNotCountedOn) {
  Params params;
  params.layout[2].thrust_ratio = 0.0;
  params.layout[1].thrust_ratio = 0.5;
  const MinervaTransport transport{params};
  ASSERT_EQ(transport.actuators().size(), 12U);
  EXPECT_EQ(transport.actuators()[6].range.hi, 0.0);
  EXPECT_TRUE(transport.propulsion().effectiveness.middleCols<3>(6).isZero(0.0));
  EXPECT_NEAR(transport.actuators()[4].range.hi, 0.5 * transport.actuators()[1].range.hi, 1e-12);
}

TEST(MinervaTransport, SixDegreesOfFreedomStayLevelAndNeutral) {
  Params params;
  params.degrees_of_freedom = DegreesOfFreedom::six;
  Vehicle vehicle{MinervaTransport{params}};
  EXPECT_TRUE(vehicle.propulsion()->restoring.isZero(1e-9));
  for (int i = 0; i < 1000; ++i) vehicle.drift({.current_n = {0.2, 0.1, 0}, .density = 1000.0}, 0.05);
  EXPECT_LT(std::abs(vehicle.state().p_n.z()),
            2e-3);  // measured 0.8 mm: it pitches while the current takes it
  EXPECT_NEAR(vehicle.propulsion()->effectiveness.row(2).sum(), 8.0, 1e-12);  // eight vertical thrusters
}

TEST(MinervaTransport, LayoutIsSetFlat) {
  const Vehicle vehicle = builtin_vehicles().make(
      "minerva_transport",
      {{"layout", 2.0}, {"layout[0].x_m", 2.0}, {"layout[1].x_m", -2.0}, {"layout[1].yaw_deg", 180.0}});
  EXPECT_EQ(vehicle.actuators().size(), 6U);
}

TEST(MinervaTransport, RefusesLayoutsThatCannotBe) {
  const auto making = [](Params params) { return [params] { MinervaTransport{params}; }; };
  EXPECT_THAT(making(with_layout({})), ThrowsMessage<InputError>("layout: has no vehicle"));
  EXPECT_THAT(making(with_layout({{.x_m = 2.0}, {.x_m = -2.0}, {.x_m = 2.0, .y_m = 0.5}})),
              ThrowsMessage<InputError>("layout[2] puts a vehicle into that of layout[0]"));
  EXPECT_THAT(making(with_layout({{.x_m = 0.3}})),
              ThrowsMessage<InputError>("layout[0] puts a vehicle into the payload"));
  EXPECT_THAT(making(with_layout({{.x_m = 2.0, .thrust_ratio = 0.0}})),
              ThrowsMessage<InputError>(HasSubstr("cannot push along yaw alone")));
  std::vector<Station> row;
  for (int i = 0; i < 11; ++i) row.push_back({.x_m = 2.0 + i});
  EXPECT_THAT(making(with_layout(row)), ThrowsMessage<InputError>("a vehicle has more than 32 thrusters"));
}

}  // namespace
}  // namespace fairway
