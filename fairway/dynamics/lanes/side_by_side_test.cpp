// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/lanes/side_by_side.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "fairway/core/rng.hpp"
#include "fairway/dynamics/catalog.hpp"
#include "fairway/dynamics/sparus2/sparus2.hpp"
#include "fairway/dynamics/testing/held_actuators.hpp"

namespace fairway {
namespace {

Vec3 drawn(Rng& rng, double size) {
  return {rng.uniform(-size, size), rng.uniform(-size, size), rng.uniform(-size, size)};
}

VehicleState drawn_state(Rng& rng) {
  const Vec3 axis = drawn(rng, 1.0);
  VehicleState x{.p_n = drawn(rng, 50.0), .v_b = drawn(rng, 1.0), .omega_b = drawn(rng, 0.5)};
  x.q_nb = Eigen::Quaterniond{rng.uniform(-1.0, 1.0), axis.x(), axis.y(), axis.z()}.normalized();
  return x;
}

/// Still, moving, or accelerated, and of another density for each.
Water drawn_water(Rng& rng) {
  Water water;
  water.density = rng.uniform(990.0, 1030.0);
  const std::uint64_t kind = rng.index(3);
  if (kind > 0) water.current_n = drawn(rng, 0.3);
  if (kind > 1) water.current_rate_n = drawn(rng, 0.1);
  return water;
}

/// A diagonal body, and one whose centre of gravity is nowhere near its origin.
std::array<SubmergedBody, 2> bodies() {
  const Sparus2::Params eccentric{
      .cg_x_m = 0.1, .cg_y_m = -0.05, .cg_z_m = 0.03, .cb_x_m = 0.02, .munk_moment = true};
  return {Sparus2{{}}.body(), Sparus2{eccentric}.body()};
}

std::array<std::uint64_t, 13> bits_of(const VehicleState& x) {
  std::array<double, 13> numbers;
  const auto& [p, q, v, omega] = x;
  numbers = {p.x(), p.y(), p.z(), q.w(),     q.x(),     q.y(),    q.z(),
             v.x(), v.y(), v.z(), omega.x(), omega.y(), omega.z()};
  return std::bit_cast<std::array<std::uint64_t, 13>>(numbers);
}

TEST(SideBySide, EachBodyMovesAsItDoesAlone) {
  for (const lanes::MotionKernel* kernel : lanes::motion_kernels()) {
    for (const SubmergedBody& body : bodies()) {
      for (std::uint64_t scene = 0; scene < 300; ++scene) {
        Rng rng = Rng{1}.stream("side by side", scene);
        const std::size_t count = 1 + rng.index(2 * kernel->lanes);
        std::vector<VehicleState> moved, alone;
        for (std::size_t i = 0; i < count; ++i) moved.push_back(drawn_state(rng));
        alone = moved;
        SideBySide side_by_side{body, 0.05, *kernel};
        for (std::size_t i = 0; i < count; ++i) {
          const lanes::PushOf<double> push{drawn(rng, 20.0), drawn(rng, 5.0)};
          const Water water = drawn_water(rng);
          alone[i] = body.advanced(alone[i], push, water, 0.05);
          side_by_side.add(moved[i], push, water);
        }
        side_by_side.finish();
        for (std::size_t i = 0; i < count; ++i)
          EXPECT_EQ(bits_of(moved[i]), bits_of(alone[i])) << kernel->name << ", scene " << scene << ", " << i;
      }
    }
  }
}

TEST(SideBySide, VehiclesOfAllKindsStepTogetherAsTheyDoAlone) {
  const VehicleCatalog catalog = builtin_vehicles();
  Rng rng{3};
  std::vector<Vehicle> together;
  for (const VehicleCatalog::Entry& entry : catalog.entries())
    together.insert(together.end(), 1 + rng.index(10), catalog.make(entry.info.name));
  for (Vehicle& vehicle : together) {
    VehicleState x;
    x.p_n = drawn(rng, 20.0);
    vehicle.set_state(x);
  }
  std::vector<Vehicle> alone = together;
  for (int step = 0; step < 40; ++step) {
    std::vector<Eigen::VectorXd> commands;
    std::vector<Vehicle::Errand> errands;
    for (const Vehicle& vehicle : together) {
      Eigen::VectorXd command{static_cast<Eigen::Index>(vehicle.actuators().size())};
      for (double& value : command) value = rng.uniform(-1.0, 1.0);
      commands.push_back(command);
    }
    for (std::size_t i = 0; i < together.size(); ++i) {
      const Water water = drawn_water(rng);
      errands.push_back({&together[i], &commands[i], water});
      alone[i].step(commands[i], water, 0.05);
    }
    Vehicle::step_many(errands, 0.05);
  }
  for (std::size_t i = 0; i < together.size(); ++i) {
    EXPECT_EQ(bits_of(together[i].state()), bits_of(alone[i].state())) << alone[i].info().name;
    EXPECT_EQ(together[i].actuator_state(), alone[i].actuator_state()) << alone[i].info().name;
  }
}

}  // namespace
}  // namespace fairway
