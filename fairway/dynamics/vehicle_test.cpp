// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/vehicle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/core/testing/allocations.hpp"
#include "fairway/dynamics/catalog.hpp"
#include "fairway/dynamics/testing/held_actuators.hpp"

namespace fairway {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

bool same_bits(const VehicleState& a, const VehicleState& b) {
  return a.p_n == b.p_n && a.q_nb.coeffs() == b.q_nb.coeffs() && a.v_b == b.v_b && a.omega_b == b.omega_b;
}

TEST(Vehicle, ActuatorsFollowTheirCommandByAnExactFirstOrderLagForAnyStep) {
  for (const double h : {0.01, 0.1, 0.4}) {
    Vehicle vehicle = builtin_vehicles().make("sparus2");
    const int steps = static_cast<int>(std::lround(1.2 / h));
    for (int i = 0; i < steps; ++i) vehicle.step(values({4.0, 20.0, -10.0}), {}, h);
    EXPECT_NEAR(vehicle.actuator_state()[0], 4.0 * (1 - std::exp(-1.2 / 0.4)), 1e-12);
    EXPECT_NEAR(vehicle.actuator_state()[1], 20.0 * (1 - std::exp(-1.2 / 0.8)), 1e-12);
    EXPECT_NEAR(vehicle.actuator_state()[2], -10.0 * (1 - std::exp(-1.2 / 0.8)), 1e-12);
  }
}

TEST(Vehicle, ChangingTheStepLengthKeepsTheLagExact) {
  Vehicle vehicle = builtin_vehicles().make("sparus2");
  for (const double h : {0.1, 0.3, 0.1, 0.7}) vehicle.step(values({4.0, 0, 0}), {}, h);
  EXPECT_NEAR(vehicle.actuator_state()[0], 4.0 * (1 - std::exp(-1.2 / 0.4)), 1e-12);
}

TEST(Vehicle, MotionUnderLaggingActuatorsConvergesWithOrderTwo) {
  const auto speed = [](double h) {
    Vehicle vehicle = builtin_vehicles().make("sparus2");
    for (int i = 0; i < std::lround(1.6 / h); ++i) vehicle.step(values({0, 30.0, 30.0}), {}, h);
    return vehicle.state().p_n.x();
  };
  const double exact = speed(0.0005);
  EXPECT_NEAR(std::log2((speed(0.1) - exact) / (speed(0.05) - exact)), 2.0, 0.2);
}

TEST(Vehicle, ActuatorsKeepTheirAsymmetricLimits) {
  Vehicle vehicle = builtin_vehicles().make("sparus2");
  vehicle.set_actuator_state(values({1e9, 1e9, -1e9}));
  EXPECT_NEAR(vehicle.actuator_state()[0], 12.702, 0.001);
  EXPECT_EQ(vehicle.actuator_state()[1], 71.5);
  EXPECT_EQ(vehicle.actuator_state()[2], -30.0);
  for (int i = 0; i < 1000; ++i) vehicle.step(values({-1e9, -1e9, 1e9}), {}, 0.05);
  EXPECT_NEAR(vehicle.actuator_state()[0], -6.277, 0.001);
  EXPECT_NEAR(vehicle.actuator_state()[1], -30.0, 1e-9);
  EXPECT_NEAR(vehicle.actuator_state()[2], 71.5, 1e-9);
}

TEST(Vehicle, ACommandThatIsNoNumberMovesNothing) {
  Vehicle vehicle = builtin_vehicles().make("sparus2");
  vehicle.set_actuator_state(values({1.0, 2.0, 3.0}));
  vehicle.step(values({std::nan(""), std::nan(""), 3.0}), {}, 0.1);
  EXPECT_EQ(vehicle.actuator_state(), values({1.0, 2.0, 3.0}));
  EXPECT_TRUE(is_finite(vehicle.state()));
}

TEST(Vehicle, SettingActuatorsAndDriftingIsAStepWithoutLag) {
  Vehicle held = builtin_vehicles().make("sparus2");
  Vehicle lagless =
      builtin_vehicles().make("sparus2", {{"surge_time_constant_s", 0.0}, {"heave_time_constant_s", 0.0}});
  for (int i = 0; i < 50; ++i) {
    held.set_actuator_state(values({3.0, 5.0, 1.0}));
    held.drift({}, 0.05);
    lagless.step(values({3.0, 5.0, 1.0}), {}, 0.05);
  }
  EXPECT_TRUE(same_bits(held.state(), lagless.state()));
}

TEST(Vehicle, ACopyIsASnapshot) {
  const VehicleCatalog catalog = builtin_vehicles();
  for (const VehicleCatalog::Entry& entry : catalog.entries()) {
    Vehicle vehicle = entry.make({});
    const ActuatorValues command = values({0.2, 0.3, 0.1});
    for (int i = 0; i < 20; ++i) vehicle.step(command, {}, 0.05);
    const Vehicle snapshot = vehicle;
    const VehicleState then = vehicle.state();
    for (int i = 0; i < 20; ++i) vehicle.step(command, {}, 0.05);
    EXPECT_TRUE(same_bits(snapshot.state(), then)) << entry.info.name;

    Vehicle replay = snapshot;
    for (int i = 0; i < 20; ++i) replay.step(command, {}, 0.05);
    EXPECT_TRUE(same_bits(replay.state(), vehicle.state())) << entry.info.name;
    EXPECT_EQ(replay.actuator_state(), vehicle.actuator_state());
  }
}

TEST(Vehicle, StepsWithoutAllocating) {
  const VehicleCatalog catalog = builtin_vehicles();
  for (const VehicleCatalog::Entry& entry : catalog.entries()) {
    Vehicle vehicle = entry.make({});
    const ActuatorValues command = values({0.2, 0.3, 0.1});
    const long before = allocation_count();
    for (int i = 0; i < 100; ++i) {
      vehicle.step(command, {}, i < 50 ? 0.05 : 0.1);
      vehicle.set_actuator_state(command);
      vehicle.drift({}, 0.05);
    }
    EXPECT_EQ(allocation_count(), before) << entry.info.name;
  }
}

TEST(VehicleCatalog, EveryVehicleIsDescribedAndStaysFiniteUnderFullCommands) {
  const VehicleCatalog catalog = builtin_vehicles();
  for (const VehicleCatalog::Entry& entry : catalog.entries()) {
    Vehicle vehicle = entry.make({});
    EXPECT_FALSE(entry.info.title.empty());
    EXPECT_FALSE(entry.info.source.empty());
    EXPECT_FALSE(entry.params.empty());
    for (int i = 0; i < 2000; ++i) {
      const double sign = i / 100 % 2 == 0 ? 1.0 : -1.0;
      vehicle.step(sign * values({1e6, 1e6, -1e6}), {.current_n = {0.5, 0.2, 0}, .density = 1025.0}, 0.05);
    }
    EXPECT_TRUE(is_finite(vehicle.state())) << entry.info.name;
  }
}

TEST(VehicleCatalog, NamesTheNearestKnownVehicleAndParameter) {
  const VehicleCatalog catalog = builtin_vehicles();
  EXPECT_THAT([&] { catalog.make("sparus"); }, ThrowsMessage<InputError>(HasSubstr("did you mean sparus2?")));
  EXPECT_THAT(
      [&] {
        catalog.make("sparus2", {{"mass", 3.0}});
      },
      ThrowsMessage<InputError>(HasSubstr("did you mean mass_kg?")));
  EXPECT_THAT(
      [&] {
        catalog.make("sparus2", {{"mass_kg", -3.0}});
      },
      ThrowsMessage<InputError>(HasSubstr("mass_kg: is -3; expected a number in")));
}

/// Every vehicle turns a little, so that body axes are not those of the rate.
VehicleState under_way() {
  VehicleState x;
  x.q_nb = quaternion_of({.roll = 0.0, .pitch = 0.0, .yaw = 0.7});
  x.v_b = {0.4, 0.1, 0.0};
  x.omega_b = {0.0, 0.0, 0.2};
  return x;
}

TEST(Vehicle, EveryVehicleIsCarriedAlongByWaterThatAccelerates) {
  // relative to the water nothing changes: over ground the acceleration of the water is added
  constexpr double h = 1e-4;
  const Vec3 rate{0.3, -0.2, 0.0};
  const VehicleCatalog catalog = builtin_vehicles();
  for (const VehicleCatalog::Entry& entry : catalog.entries()) {
    Vehicle steady = catalog.make(entry.info.name);
    steady.set_state(under_way());
    Vehicle carried = steady;
    const Vec3 current{0.1, 0.2, 0.0};
    steady.drift({.current_n = current}, h);
    carried.drift({.current_n = current, .current_rate_n = rate}, h);
    EXPECT_LT(((carried.state().v_n() - steady.state().v_n()) / h - rate).norm(), 2e-3) << entry.info.name;
  }
}

TEST(Vehicle, ASteadyCurrentOnlyCarriesItAlong) {
  const Vec3 current{0.3, -0.2, 0.0};
  const VehicleCatalog catalog = builtin_vehicles();
  for (const VehicleCatalog::Entry& entry : catalog.entries()) {
    SCOPED_TRACE(entry.info.name);
    Vehicle still = catalog.make(entry.info.name), carried = still;
    VehicleState x = under_way();
    still.set_state(x);
    x.v_b += x.q_nb.conjugate() * current;
    carried.set_state(x);
    ActuatorValues u(static_cast<Eigen::Index>(still.actuators().size()));
    for (Eigen::Index i = 0; i < u.size(); ++i)
      u[i] = (i % 2 == 0 ? 0.2 : 0.3) * still.actuators()[static_cast<std::size_t>(i)].range.hi;
    for (int i = 0; i < 1200; ++i) {
      still.step(u, {}, 0.05);
      carried.step(u, {.current_n = current}, 0.05);
    }
    // measured 4e-5 m of the otter, whose published model turns the current by its yaw alone
    EXPECT_LT((carried.state().p_n - still.state().p_n - 60.0 * current).norm(), 1e-4);
    EXPECT_GT((still.state().p_n - under_way().p_n).norm(), 1.0);
  }
}

TEST(Vehicle, ItsThrustersPushAsControllersAreTold) {
  const VehicleCatalog catalog = builtin_vehicles();
  int driven_by_thrust = 0;
  for (const VehicleCatalog::Entry& entry : catalog.entries()) {
    const Vehicle vehicle = catalog.make(entry.info.name);
    const Propulsion* propulsion = vehicle.propulsion();
    if (propulsion == nullptr) continue;
    ++driven_by_thrust;
    const ActuatorValues u = ActuatorValues::LinSpaced(propulsion->effectiveness.cols(), -2.0, 5.0);
    const auto force = [&](const ActuatorValues& thrust) -> Wrench {
      return propulsion->mass * acceleration(vehicle.rate({}, thrust, {}));
    };
    const Wrench missed = force(u) - force(0.0 * u) - propulsion->effectiveness * u;
    for (int axis = 0; axis < 6; ++axis) {  // what holds a planar one level pushes on the others
      if (propulsion->effectiveness.row(axis).isZero(0.0)) continue;
      EXPECT_NEAR(missed[axis], 0.0, 1e-9) << entry.info.name << " " << axis;
    }
  }
  EXPECT_EQ(driven_by_thrust, 5);
}

TEST(Vehicle, WaterThatRisesLiftsWhoeverMovesInThreeDimensions) {
  for (const char* name : {"sparus2", "kinematic", "minerva", "otter", "remus100"}) {
    Vehicle steady = builtin_vehicles().make(name), carried = steady;
    steady.drift({}, 1e-4);
    carried.drift({.current_rate_n = {0.0, 0.0, -0.5}}, 1e-4);
    EXPECT_NEAR((carried.state().v_b.z() - steady.state().v_b.z()) / 1e-4, -0.5, 1e-3) << name;
  }
}

}  // namespace
}  // namespace fairway
