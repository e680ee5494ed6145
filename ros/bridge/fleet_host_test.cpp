// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/fleet_host.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "fairway/record/recording.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::bridge {
namespace {

const std::string scenarios = std::string(FAIRWAY_SOURCE_DIR) + "/scenarios/";

BodyVelocity body_velocity_of(const BodyRequest& request) {
  return {request.surge_mps, request.sway_mps, request.heave_mps, request.yaw_rate_radps};
}

/// What the agent's own avoider made it ask of its controller at this instant.
BodyVelocity asked_by(const Agent& agent) {
  return body_velocity_of(agent.pilot.request(agent.own, agent.estimated_current()));
}

void expect_same(const Motion& motion, const VehicleState& x) {
  ASSERT_EQ(motion.position_n, (Triple{x.p_n.x(), x.p_n.y(), x.p_n.z()})) << motion.time;
  ASSERT_EQ(motion.q_nb, (Quaternion{x.q_nb.w(), x.q_nb.x(), x.q_nb.y(), x.q_nb.z()})) << motion.time;
  ASSERT_EQ(motion.v_b, (Triple{x.v_b.x(), x.v_b.y(), x.v_b.z()})) << motion.time;
  ASSERT_EQ(motion.omega_b, (Triple{x.omega_b.x(), x.omega_b.y(), x.omega_b.z()})) << motion.time;
}

class FleetAsARun : public testing::TestWithParam<std::pair<const char*, bool>> {};

/// Drives a fleet beside a plain simulation, instant by instant.
TEST_P(FleetAsARun, ToldWhatTheOwnAvoidersWouldDoItGoesWhereTheSimulationGoesToTheBit) {
  const auto& [file, autonomous] = GetParam();
  const Scenario scenario = load_scenario(scenarios + file);
  Simulation plain{scenario, builtin_catalogs()};
  FleetHost fleet{{.scenario = scenarios + file, .seed = {}, .autonomous = autonomous}};
  int commands = 0;
  while (!plain.is_done()) {
    ASSERT_FALSE(fleet.is_done());
    ASSERT_EQ(fleet.time(), plain.time());
    plain.look();
    for (std::size_t i = 0; i < fleet.size(); ++i) {
      expect_same(fleet.vehicle(i).truth, plain.agents()[i].vehicle.state());
      expect_same(fleet.vehicle(i).estimate, plain.agents()[i].estimate());
    }
    plain.act({});
    for (std::size_t i = 0; i < fleet.size(); ++i) {
      if (fleet.vehicle(i).wants_command && fleet.command(i, asked_by(plain.agents()[i]))) ++commands;
    }
    fleet.step();
    if (HasFatalFailure()) return;
  }
  EXPECT_TRUE(fleet.is_done());
  EXPECT_TRUE(fleet.expectations_kept());
  EXPECT_EQ(commands > 0, !autonomous);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, FleetAsARun,
                         testing::Values(std::pair{"cube20_4.yaml", false}, std::pair{"cube20_8.yaml", false},
                                         std::pair{"priority_wait.yaml", false},  // holds on the way
                                         std::pair{"acoustic_pair.yaml", false},  // believes to be elsewhere
                                         std::pair{"cube20_8.yaml", true},
                                         std::pair{"survey_mission.yaml", false}));  // many legs

TEST(FleetHost, ItsSummaryIsThatOfTheCommand) {
  FleetHost fleet{{.scenario = scenarios + "head_on.yaml", .seed = 3, .autonomous = true}};
  while (!fleet.is_done()) fleet.step();
  const auto summary = nlohmann::json::parse(fleet.summary_json());
  EXPECT_EQ(summary["scenario"], "head_on");
  EXPECT_EQ(summary["seed"], 3);
  EXPECT_EQ(summary["fleet"]["pair_collision_count"], fleet.collisions());
  EXPECT_NE(fleet.summary(1.0).find("head_on: 2 vehicles"), std::string::npos);
}

TEST(FleetHost, BeforeTheFirstCommandAVehicleUnderWayHolds) {
  FleetHost fleet{{.scenario = scenarios + "head_on.yaml", .seed = {}}};
  const Triple begin = fleet.vehicle(0).truth.position_n;
  ASSERT_TRUE(fleet.vehicle(0).wants_command);
  while (fleet.time() < 20.0) fleet.step();
  EXPECT_TRUE(fleet.vehicle(0).holding);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(fleet.vehicle(0).truth.position_n[axis], begin[axis], 1.0);
}

TEST(FleetHost, AVehicleThatIsNoLongerToldHoldsAfterTheTimeout) {
  FleetHost fleet{{.scenario = scenarios + "head_on.yaml", .seed = {}, .command_timeout_s = 0.5}};
  while (fleet.time() < 10.0) {
    ASSERT_TRUE(fleet.command(0, {.surge_mps = 0.4}));
    fleet.step();
  }
  const double last = fleet.time() - fleet.step_period();
  while (fleet.time() <= last + 0.5 + 1e-9) {
    EXPECT_FALSE(fleet.vehicle(0).holding) << fleet.time();
    fleet.step();
  }
  EXPECT_TRUE(fleet.vehicle(0).holding);
  EXPECT_NEAR(fleet.time(), last + 0.5 + fleet.step_period(), 1e-9);

  // it stops within some seconds, and goes on when it is told again
  while (fleet.time() < 40.0) fleet.step();
  EXPECT_LT(std::abs(fleet.vehicle(0).truth.v_b[0]), 0.05);
  for (int i = 0; i < 200; ++i) {
    fleet.command(0, {.surge_mps = 0.4});
    fleet.step();
  }
  EXPECT_GT(fleet.vehicle(0).truth.v_b[0], 0.3);
}

TEST(FleetHost, ACommandThatIsNotFiniteIsNotTaken) {
  FleetHost fleet{{.scenario = scenarios + "head_on.yaml", .seed = {}}};
  EXPECT_FALSE(fleet.command(0, {.surge_mps = std::numeric_limits<double>::quiet_NaN()}));
  EXPECT_FALSE(fleet.command(0, {.yaw_rate_radps = std::numeric_limits<double>::infinity()}));
  EXPECT_TRUE(fleet.vehicle(0).holding);
}

TEST(FleetHost, WhoIsNotUnderWayIsNotSteeredFromOutside) {
  FleetHost fleet{{.scenario = scenarios + "cube20_4.yaml", .seed = {}}};
  ASSERT_EQ(fleet.vehicle(0).phase, "deploying");
  EXPECT_FALSE(fleet.command(0, {.surge_mps = 1.0}));
  EXPECT_FALSE(fleet.vehicle(0).goal_n.has_value());
}

TEST(FleetHost, SpheresTurnOrangeAndRedWhereTheMetricCounts) {
  // both steered straight at each other
  FleetHost fleet{{.scenario = scenarios + "head_on.yaml", .seed = {}}};
  bool detected = false;
  while (!fleet.is_done() && fleet.vehicle(0).alert != Alert::collided) {
    for (std::size_t i = 0; i < fleet.size(); ++i) fleet.command(i, {.surge_mps = 0.5});
    detected = detected || fleet.vehicle(0).alert == Alert::detected;
    fleet.step();
  }
  EXPECT_TRUE(detected);
  EXPECT_EQ(fleet.vehicle(0).alert, Alert::collided);
  EXPECT_EQ(fleet.collisions(), 1);
}

TEST(FleetHost, WhatIsRecordedIsWhereTheFleetWent) {
  const std::string file = testing::TempDir() + "fleet.mcap";
  std::vector<Motion> seen;
  {
    FleetHost fleet{{.scenario = scenarios + "head_on.yaml", .seed = {}, .record = file}};
    for (int i = 0; i < 50; ++i) {
      seen.push_back(fleet.vehicle(1).truth);
      fleet.command(1, {.surge_mps = 0.3});
      fleet.step();
    }
    fleet.finish();
  }
  const Recording recording = Recording::read(file);
  ASSERT_EQ(recording.size(), seen.size());
  for (std::size_t k = 0; k < seen.size(); ++k) expect_same(seen[k], recording.frame(k).vehicles[1].state);
  std::filesystem::remove(file);
}

TEST(FleetHost, WithoutFinishThereIsNoRecording) {
  const std::string file = testing::TempDir() + "unfinished.mcap";
  {
    FleetHost fleet{{.scenario = scenarios + "head_on.yaml", .seed = {}, .record = file}};
    fleet.step();
  }
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(FleetHost, ObstaclesAreDrawnWhereTheyAre) {
  const FleetHost fleet{{.scenario = scenarios + "static_obstacles.yaml", .seed = {}}};
  const Scenario scenario = load_scenario(scenarios + "static_obstacles.yaml");
  const std::vector<Mark> marks = fleet.obstacles();
  ASSERT_EQ(marks.size(), scenario.obstacles.size());
  EXPECT_GT(std::ranges::count(scenario.obstacles, Obstacle::Kind::sphere, &ObstacleSpec::kind), 0);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (scenario.obstacles[i].kind != Obstacle::Kind::sphere) continue;
    EXPECT_EQ(marks[i].kind, Mark::Kind::sphere);
    EXPECT_EQ(marks[i].points[0][0], scenario.obstacles[i].position.x());
    EXPECT_EQ(marks[i].radius, scenario.obstacles[i].radius);
  }
}

TEST(FleetHost, WhatItCannotUseIsSaidInOneLine) {
  const auto refusal = [](const FleetOptions& options) -> std::string {
    try {
      const FleetHost fleet{options};
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal({.scenario = "nowhere.yaml", .seed = {}}).find("nowhere.yaml"), std::string::npos);
  EXPECT_NE(refusal({.scenario = scenarios + "head_on.yaml", .overrides = {{"duraton_s", "5"}}, .seed = {}})
                .find("duration_s"),
            std::string::npos);
  EXPECT_NE(refusal({.scenario = scenarios + "head_on.yaml", .seed = {}, .command_timeout_s = -1.0})
                .find("command_timeout_s"),
            std::string::npos);
}

}  // namespace
}  // namespace fairway::bridge
