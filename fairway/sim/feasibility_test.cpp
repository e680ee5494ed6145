// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/feasibility.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "fairway/core/text.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"
#include "fairway/sim/stability.hpp"
#include "fairway/sim/testing/runaway.hpp"

namespace fairway {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// Why this scenario is refused, or empty.
std::string refusal(const std::string& yaml, const Overrides& overrides = {}) {
  try {
    const Simulation accepted{parse_scenario(yaml, "f.yaml", overrides), builtin_catalogs()};
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string boat(const std::string& start, const std::string& goal, const std::string& limits = "{}") {
  return "fairway: 1\nname: boat\nvehicles:\n- model: otter_by_thrust\n  avoider: direct\n  start: "
         "{position_m: " +
         start + "}\n  limits: " + limits + "\n  mission: [{transit: {position_m: " + goal + "}}]\n";
}

TEST(Feasibility, WhatFloatsIsRefusedElsewhereThanAtTheSurface) {
  EXPECT_EQ(refusal(boat("[0, 0, 0]", "[9, 0, 0]")), "");
  EXPECT_EQ(refusal(boat("[0, 0, 5]", "[9, 0, 0]")),
            "f.yaml:6:23: vehicles[0].start.position_m: otter_by_thrust lives on the surface: expected depth "
            "0, got 5");
  EXPECT_EQ(refusal(boat("[0, 0, 0]", "[9, 0, -1]")),
            "f.yaml:8:13: vehicles[0].mission[0].transit.position_m: otter_by_thrust lives on the surface: "
            "expected depth 0, got -1");
  EXPECT_THAT(
      refusal(boat("[0, 0, 0]", "[9, 0, 0]", "{min_depth_m: 2}")),
      StartsWith("f.yaml:7:11: vehicles[0].limits.min_depth_m: otter_by_thrust lives on the surface"));
  EXPECT_THAT(refusal(boat("[0, 0, 0]", "[9, 0, 0]", "{max_depth_m: -2}")), HasSubstr("max_depth_m"));
  EXPECT_EQ(refusal(boat("[0, 0, 0]", "[9, 0, 0]", "{min_depth_m: 0, max_depth_m: 0}")), "");
}

/// How fast a Sparus II is ahead two seconds after it was told to go at 0.5 m/s [m/s].
double speed_after_two_seconds(const Overrides& overrides) {
  Simulation simulation{load_scenario(FAIRWAY_SOURCE_DIR "/scenarios/sparus2_head_on.yaml", overrides),
                        builtin_catalogs()};
  while (simulation.time() < 2.0) simulation.step({});
  return simulation.agents()[0].vehicle.state().v_b.x();
}

TEST(Feasibility, AnAutopilotIsThatOfThrusters) {
  const std::string slow = "vehicles[*].autopilot.surge_bandwidth_radps";
  EXPECT_LT(speed_after_two_seconds({{slow, "0.2"}}), 0.9 * speed_after_two_seconds({}));
  EXPECT_EQ(speed_after_two_seconds({{slow, "0.8"}}), speed_after_two_seconds({}));

  const std::string yaml = boat("[0, 0, 0]", "[9, 0, 0]");
  EXPECT_EQ(refusal(yaml, {{"vehicles[0].autopilot", "velocity_controller"}}), "");
  EXPECT_EQ(refusal(yaml, {{"vehicles[0].autopilot", "pid"}}),
            "--set vehicles[0].autopilot: vehicles[0].autopilot: kind: is \"pid\"; expected one of "
            "velocity_controller");
  EXPECT_THAT(refusal(yaml, {{"vehicles[0].autopilot.surge_bandwidth_radps", "0"}}), HasSubstr("0.01"));
  EXPECT_THAT(
      refusal(yaml, {{"vehicles[0].model", "kinematic"}, {"vehicles[0].autopilot", "velocity_controller"}}),
      HasSubstr("has no thrusters that it could drive: leave it out"));
}

TEST(Feasibility, AStepThatIsTooLongForABoatIsRefusedAndTheOneThatIsNamedWouldDo) {
  const std::string yaml = boat("[0, 0, 0]", "[9, 0, 0]");
  const std::string said = refusal(yaml, {{"step_s", "1"}});
  EXPECT_THAT(said, AllOf(StartsWith("--set step_s: 1 is too long for robot0 (otter_by_thrust): its "),
                          HasSubstr(" mode "), HasSubstr("1/s, would grow; at most ")));
  const std::string longest =
      said.substr(said.find("at most ") + 8, said.rfind(" would do") - said.find("at most ") - 8);
  EXPECT_EQ(refusal(yaml, {{"step_s", longest}}), "");
  EXPECT_NE(refusal(yaml, {{"step_s", number_text(1.1 * std::stod(longest))}}), "");
}

TEST(Feasibility, AHullIsRefusedWhereTheWaterIsFarFasterThanItself) {
  // a boat that goes 3.09 m/s by itself
  const std::string yaml = boat("[0, 0, 0]", "[9, 0, 0]");
  EXPECT_EQ(refusal(yaml, {{"vehicles[0].start.speed_mps", "6"}}), "");
  EXPECT_EQ(refusal(yaml, {{"water", "{current_mps: [3, 0, 0]}"}, {"vehicles[0].start.speed_mps", "-3"}}),
            "");
  EXPECT_EQ(
      refusal(yaml, {{"water", "{current_mps: [8, 0, 0]}"}}),
      "f.yaml:6:23: vehicles[0].start: otter_by_thrust starts at 0 m/s in currents of up to 8 m/s; its model "
      "holds up to 6.1 m/s through the water together");
  EXPECT_THAT(refusal(yaml, {{"vehicles[0].start.speed_mps", "-50"}}), HasSubstr("starts at -50 m/s"));
  // a vehicle without forces has no such limit
  EXPECT_EQ(refusal(yaml, {{"vehicles[0].model", "kinematic"}, {"water", "{current_mps: [8, 0, 0]}"}}), "");
}

TEST(Feasibility, EveryScenarioThatComesWithFairwayIsAccepted) {
  int count = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator{FAIRWAY_SOURCE_DIR "/scenarios"}) {
    if (file.is_directory()) continue;
    EXPECT_NO_THROW((Simulation{load_scenario(file.path().string()), builtin_catalogs()})) << file.path();
    ++count;
  }
  EXPECT_GT(count, 20);
}

Vehicle runaway(double growth) { return Vehicle{Runaway{{.growth_hz = growth}}}; }

TEST(Feasibility, AJumpOfTheModelIsNoMode) {
  // across the current the flow is at a Reynolds number, to 2 in a million, at which the drag of a cylinder
  // jumps
  const std::string yaml = R"(
fairway: 1
name: at_a_jump
vehicles:
  - model: remus100
    start: {position_m: [0, 0, 20], speed_mps: 1.5}
    avoider: direct
    mission: [{transit: {position_m: [100, 0, 20], speed_mps: 1.5}}]
)";
  EXPECT_EQ(refusal(yaml, {{"water", "{current_mps: [0.14, 0.124998658, 0]}"}}), "");
}

TEST(Feasibility, AHullThatWaterMeetsExactlyAbeamIsAccepted) {
  for (const std::string current : {"[0, 0.3, 0]", "[0, -0.2, 0]", "[0.0001, 0.3, 0]", "[0.005, 0.3, 0]"})
    EXPECT_EQ(refusal("{fairway: 1, name: abeam, water: {current_mps: " + current +
                      "}, vehicles: [{model: remus100, avoider: direct, start: {position_m: [0, 0, 10]}, "
                      "mission: [{transit: {position_m: [100, 0, 10], speed_mps: 1.5}}]}]}"),
              "")
        << current;
}

TEST(Stability, ADecayingModeIsCarriedByRungeKuttaUpToItsLimitOnTheRealAxis) {
  // |R(z)| = 1 at z = -2.7853 (Hairer and Wanner, table 2.1)
  const Vehicle vehicle = runaway(-10.0);
  const ActuatorValues u = vehicle.actuator_state();
  EXPECT_FALSE(step_limit(vehicle, {}, u, {}, 0.278));
  const auto limit = step_limit(vehicle, {}, u, {}, 0.3);
  ASSERT_TRUE(limit);
  EXPECT_NEAR(limit->step_s, 0.27853, 2e-4);  // by growth_tolerance
  EXPECT_NEAR(limit->mode.rate.real(), -10.0, 1e-6);
  EXPECT_EQ(limit->mode.axis, "surge");
  EXPECT_EQ(text_of(limit->mode), "-10 1/s");
}

TEST(Stability, AModeThatGrowsByItselfIsTheVehiclesBusiness) {
  const Vehicle vehicle = runaway(3.0);
  EXPECT_FALSE(step_limit(vehicle, {}, vehicle.actuator_state(), {}, 1.0));
}

/// The longest step up to 1 s of a vehicle at rest and at full speed ahead.
double longest_step(const Vehicle& vehicle, const VehicleState& steady, const ActuatorValues& ahead) {
  double longest = 1.0;
  if (const auto limit = step_limit(vehicle, {}, vehicle.actuator_state(), {}, longest))
    longest = limit->step_s;
  if (const auto limit = step_limit(vehicle, steady, ahead, {}, longest)) longest = limit->step_s;
  return longest;
}

/// Lets the autopilot hold a surge for `duration` [s] in steps of `h`.
void hold(Vehicle& vehicle, Autopilot& autopilot, double surge, double duration, double h) {
  for (double t = 0.0; t < duration; t += h) {
    const VehicleState& x = vehicle.state();
    vehicle.step(autopilot.control({.surge_mps = surge}, x.v_b, x.omega_b, h, x.q_nb), {}, h);
  }
}

double velocity_between(const Vehicle& a, const Vehicle& b) {
  return (a.state().v_b - b.state().v_b).norm() + (a.state().omega_b - b.state().omega_b).norm();
}

TEST(Stability, NoVehiclesControllersAreWhatALongStepBreaksFirst) {
  const VehicleCatalog catalog = builtin_vehicles();
  for (const VehicleCatalog::Entry& entry : catalog.entries()) {
    if (entry.info.name == "otter") continue;  // driven by propeller speeds: no autopilot
    const Vehicle vehicle = entry.make({});
    const Autopilot autopilot{vehicle};
    Vehicle full = vehicle;
    Autopilot pushing = autopilot;
    full.set_actuator_state(pushing.control({.surge_mps = 1e3}, Vec3::Zero(), Vec3::Zero(), 0.05));
    const auto steady = steady_state(vehicle, {}, full.actuator_state(), {});
    ASSERT_TRUE(steady) << entry.info.name;
    const double h = 0.95 * longest_step(vehicle, *steady, full.actuator_state());
    for (const double share : {0.0, 0.5}) {
      const double surge = share * steady->v_b.x();
      Vehicle a = vehicle;
      Autopilot pilot_a = autopilot;
      a.set_state({.v_b = {surge, 0, 0}});
      hold(a, pilot_a, surge, 120.0, h);
      EXPECT_NEAR(a.state().v_b.x(), surge, 0.01) << entry.info.name << " at " << h << " s";

      // a disturbance does not grow; a controller that is too slow for its step doubles it in seconds
      Vehicle b = a;
      Autopilot pilot_b = pilot_a;
      VehicleState disturbed = b.state();
      disturbed.v_b += Vec3::Constant(1e-4);
      disturbed.omega_b += Vec3::Constant(1e-4);
      b.set_state(disturbed);
      const double first = velocity_between(a, b);
      hold(a, pilot_a, surge, 60.0, h);
      hold(b, pilot_b, surge, 60.0, h);
      EXPECT_LT(velocity_between(a, b), 20.0 * first) << entry.info.name << " at " << h << " s, " << surge;
    }
  }
}

TEST(Stability, ASteadyStateIsWhereABoatComesToAtFullThrust) {
  // zarco: 2 x 55 N against 20 u + 20 u^2: u = (-20 + sqrt(400 + 80 x 110)) / 40 = 1.898 m/s
  const Vehicle vehicle = builtin_vehicles().make("zarco");
  ActuatorValues ahead(2);
  ahead << 55.0, 55.0;
  const auto steady = steady_state(vehicle, {}, ahead, {});
  ASSERT_TRUE(steady);
  EXPECT_NEAR(steady->v_b.x(), 1.898, 1e-3);
  EXPECT_NEAR(steady->omega_b.norm(), 0.0, 1e-9);
}

}  // namespace
}  // namespace fairway
