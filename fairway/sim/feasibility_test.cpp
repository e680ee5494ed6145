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
            "expected "
            "depth 0, got -1");
  EXPECT_THAT(
      refusal(boat("[0, 0, 0]", "[9, 0, 0]", "{min_depth_m: 2}")),
      StartsWith("f.yaml:7:11: vehicles[0].limits.min_depth_m: otter_by_thrust lives on the surface"));
  EXPECT_THAT(refusal(boat("[0, 0, 0]", "[9, 0, 0]", "{max_depth_m: -2}")), HasSubstr("max_depth_m"));
  EXPECT_EQ(refusal(boat("[0, 0, 0]", "[9, 0, 0]", "{min_depth_m: 0, max_depth_m: 0}")), "");
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

TEST(Feasibility, EveryScenarioThatComesWithFairwayIsAccepted) {
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator{FAIRWAY_SOURCE_DIR "/scenarios"}) {
    EXPECT_NO_THROW((Simulation{load_scenario(file.path().string()), builtin_catalogs()})) << file.path();
    ++count;
  }
  EXPECT_GT(count, 20);
}

Vehicle runaway(double growth) { return Vehicle{Runaway{{.growth_hz = growth}}}; }

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
