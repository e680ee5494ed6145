// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/avoider_host.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"
#include "ros/bridge/avoider_setup.hpp"

namespace fairway::bridge {
namespace {

using testing::HasSubstr;

const std::string cube = FAIRWAY_SOURCE_DIR "/scenarios/cube20_8.yaml";

AvoiderOptions named(const Settings& settings = {}) {
  AvoiderOptions options{
      .scenario = "", .vehicle = "auv_1", .settings = {{"team", "auv_2 auv_3"}}, .seed = {}};
  for (const auto& setting : settings) options.settings.push_back(setting);
  return options;
}

AvoiderOptions of_cube(const Settings& settings = {}) {
  return {.scenario = cube, .vehicle = "robot3", .settings = settings, .seed = {}};
}

std::string refusal(const AvoiderOptions& options) {
  try {
    const AvoiderHost host{options};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// On its way north from `from` since time 0.
Motion northward(double time, const Triple& from = {0, 0, 10}, double speed = 0.5) {
  return {.time = time, .position_n = {from[0] + speed * time, from[1], from[2]}, .v_b = {speed, 0, 0}};
}

std::string value(const Diagnosis& diagnosis, const std::string& name) {
  for (const auto& [key, text] : diagnosis.values) {
    if (key == name) return text;
  }
  ADD_FAILURE() << "nothing is said of " << name;
  return "";
}

TEST(AvoiderHost, AVehicleOfAScenarioIsSetUpFromItsFile) {
  const AvoiderHost host{of_cube()};
  EXPECT_EQ(host.algorithm(), "orca3d");
  EXPECT_THAT(host.team(),
              testing::ElementsAre("robot0", "robot1", "robot2", "robot4", "robot5", "robot6", "robot7"));
  EXPECT_EQ(host.period(), 0.05);
  EXPECT_EQ(host.watchdog_period(), 1.0);
}

TEST(AvoiderHost, SettingsWinOverTheScenario) {
  const AvoiderHost host{of_cube({{"algorithm", "orca3d+stop_and_wait"},
                                  {"params.crit_dist_m", "6"},
                                  {"period_s", "0.2"},
                                  {"policy.watchdog_s", "2.5"},
                                  {"team", "robot0, robot7"}})};
  EXPECT_EQ(host.algorithm(), "orca3d+stop_and_wait");
  EXPECT_EQ(host.period(), 0.2);
  EXPECT_EQ(host.watchdog_period(), 2.5);
  EXPECT_THAT(host.team(), testing::ElementsAre("robot0", "robot7"));
}

TEST(AvoiderHost, AnotherAlgorithmKeepsWhatItHasOfTheScenariosParameters) {
  EXPECT_EQ(refusal(of_cube({{"algorithm", "apf"}})), "");
  EXPECT_EQ(refusal(of_cube({{"algorithm", "vo"}})), "");
}

TEST(AvoiderHost, WithoutAScenarioSettingsSayEverything) {
  AvoiderHost host{
      named({{"algorithm", "apf"}, {"radius_m", "2"}, {"max_speed_mps", "0.7"}, {"model", "sparus2"}})};
  EXPECT_EQ(host.algorithm(), "apf");
  EXPECT_THAT(host.team(), testing::ElementsAre("auv_2", "auv_3"));
  host.own_motion(northward(0), 0);
  ASSERT_TRUE(host.go_to({50, 0, 10}, 1.0));
  const Order order = host.update(0);
  EXPECT_TRUE(order.in_charge);
  EXPECT_TRUE(order.decided);
  EXPECT_EQ(order.state, "under_way");
  EXPECT_NEAR(std::hypot(order.velocity_n[0], order.velocity_n[1], order.velocity_n[2]), 0.7, 1e-9);
}

TEST(AvoiderHost, WhatTheVehicleCannotDoIsSaidByTheModelOrTheSettings) {
  const auto note_towards_astern = [](Settings settings) {
    settings.insert(settings.end(), {{"algorithm", "direct"}, {"max_speed_mps", "1.5"}});
    AvoiderHost host{named(settings)};
    host.own_motion(northward(0), 0);
    EXPECT_TRUE(host.go_to({-100, 0, 0}, 1.5));
    host.update(0);
    return value(host.diagnosis(0), "note");
  };
  EXPECT_THAT(note_towards_astern({{"model", "remus100"}}), testing::HasSubstr("astern"));
  EXPECT_THAT(note_towards_astern({{"min_speed_mps", "1"}, {"sternway", "false"}}),
              testing::HasSubstr("astern"));
  EXPECT_EQ(note_towards_astern({}), "");
}

TEST(AvoiderHost, WhatTheVehicleCanDoIsGivenAsNumbers) {
  // towards what is abeam, a boat of these numbers is told to turn no faster than nine tenths of what it can
  const Settings boat{
      {"envelope.ahead_mps", "1.6"},         {"envelope.acceleration_mps2", "0.3"},
      {"envelope.deceleration_mps2", "0.2"}, {"envelope.turn_acceleration_radps2", "0.4"},
      {"envelope.turn_lag_s", "0.5"},        {"envelope.turn_rates_radps", "0.2 0.2 0.2 0.2"}};
  const auto request = [](const Settings& settings) {
    AvoiderHost host{named(settings)};
    host.own_motion(northward(0), 0);
    EXPECT_TRUE(host.go_to({0, 100, 0}, 1.0));
    const Order order = host.update(0);
    return std::pair{order.request.yaw_rate_radps, host.algorithm()};
  };
  const auto [turn_rate, algorithm] = request(boat);
  EXPECT_NEAR(turn_rate, 0.18, 1e-12);
  EXPECT_EQ(algorithm, "orca3d+trackable");
  EXPECT_EQ(request({}).second, "orca3d");
}

TEST(AvoiderHost, TheModelChoosesTheSteering) {
  // across the wanted course Sparus turns on the spot; a vehicle of unknown dynamics turns while it goes
  for (const auto& [model, surge] :
       {std::pair{"sparus2", 0.0}, std::pair{"kinematic", 0.5 * std::cos(1.0)}}) {
    AvoiderHost host{named({{"model", model}, {"algorithm", "direct"}, {"max_speed_mps", "0.5"}})};
    host.own_motion(northward(0, {0, 0, 0}, 0.0), 0);
    ASSERT_TRUE(host.go_to({100 * std::cos(1.0), 100 * std::sin(1.0), 0}, 0.5));
    EXPECT_NEAR(host.update(0).request.surge_mps, surge, 1e-9) << model;
  }
}

TEST(AvoiderHost, WhatIsWrongIsSaidInOneLineWithTheNearestName) {
  const std::vector<std::pair<AvoiderOptions, std::string>> cases{
      {{.scenario = cube, .vehicle = "robot33", .settings = {}, .seed = {}}, "did you mean robot3?"},
      {{.scenario = cube, .vehicle = "", .settings = {}, .seed = {}}, "vehicle: is empty"},
      {{.scenario = "no_such.yaml", .vehicle = "robot0", .settings = {}, .seed = {}}, "no_such.yaml"},
      {named({{"algoritm", "apf"}}), "algoritm: unknown setting; did you mean algorithm?"},
      {named({{"algorithm", "orca3"}}), "did you mean orca3d?"},
      {named({{"sternway", "no"}}), "sternway: is \"no\"; expected true or false"},
      {named({{"params.time_horizn_s", "5"}}), "did you mean time_horizon_s?"},
      {named({{"params.time_horizon_s", "long"}}), "is \"long\"; expected a number"},
      {named({{"policy.own_stal_s", "1"}}),
       "policy.own_stal_s: unknown parameter; did you mean own_stale_s?"},
      {named({{"own_stale_s", "1"}}), "did you mean policy.own_stale_s?"},
      {named({{"policy.own_stale_s", "-1"}}), "policy.own_stale_s: is -1; expected a number in [0.01, 600]"},
      {named({{"policy.neighbour_lost", "panic"}}), "expected one of inflate, hold, forget"},
      {named({{"model", "sparus"}}), "did you mean sparus2?"},
      {named({{"steering", "turn_and_go"}}), "expected one of turn_then_go"},
      {named({{"steering.rot_vel", "1"}}), "did you mean rot_vel_radps?"},
      {named({{"radius_m", "nan"}}), "radius_m: is \"nan\"; expected a number in [0, 10000]"},
      {named({{"priority", "1.5"}}), "priority: is \"1.5\"; expected a whole number"},
      {named({{"team.auv_22.radius_m", "2"}}), "nobody of the team is called auv_22; did you mean auv_2?"},
      {named({{"team.auv_2.radius", "2"}}), "did you mean radius_m?"},
      {named({{"id", "1"}}), "id: 1 is that of two vehicles, one of them auv_2"},
      {named({{"id", "1025"}}), "id: 1, of auv_2, and 1025 are the same in a team record"},
      {named({{"min_depth_m", "30"}, {"max_depth_m", "20"}}), "min_depth_m: is 30, below max_depth_m, 20"},
      {named({{"envelope.ahed_mps", "1"}}), "envelope.ahed_mps: unknown number; did you mean ahead_mps?"},
      {named({{"envelope.ahead_mps", "-1"}}), "envelope.ahead_mps: is \"-1\"; expected a number, 0 or more"},
      {named({{"envelope.astern_mps", "1"}}), "envelope.ahead_mps: is missing"},
      {of_cube({{"team", "robot0 robot9"}}), "\"robot9\" is not in"},
  };
  for (const auto& [options, part] : cases) {
    const std::string message = refusal(options);
    EXPECT_THAT(message, HasSubstr(part));
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(AvoiderHost, WhatAProgramTakesItselfIsKnownToSuggestions) {
  AvoiderOptions options = named({{"lockstp", "true"}});
  options.also_known = {"lockstep", "advisory"};
  EXPECT_EQ(refusal(options), "lockstp: unknown setting; did you mean lockstep?");
}

TEST(AvoiderHost, ThePageNamesEverySetting) {
  std::ifstream file{FAIRWAY_SOURCE_DIR "/docs/onboard.md"};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  for (const std::string_view name : setting_names())
    EXPECT_THAT(page, HasSubstr("`" + std::string(name) + "`"));
}

TEST(AvoiderHost, EveryoneToldTheSameNamesNumbersThemAlike) {
  // auv_3's words are known to auv_1 by auv_3's number
  AvoiderHost one{named()};
  AvoiderOptions options = named();
  options.vehicle = "auv_3";
  options.settings = {{"team", "auv_1 auv_2"}};
  AvoiderHost three{options};
  EXPECT_TRUE(three.own_record(0).empty());
  three.own_motion(northward(1, {20, 5, 10}), 1);
  const std::vector<std::uint8_t> record = three.own_record(1);
  ASSERT_EQ(record.size(), 25U);
  EXPECT_STREQ(one.team_record(record.data(), record.size(), 1.1), "accepted");
  EXPECT_STREQ(one.team_record(record.data(), 24, 1.1), "invalid");
  EXPECT_EQ(value(one.diagnosis(1.1), "auv_3.state"), "ok");
  EXPECT_EQ(value(one.diagnosis(1.1), "auv_2.state"), "never heard");
  EXPECT_EQ(value(one.diagnosis(1.1), "record_refused_count"), "1");
}

TEST(AvoiderHost, WhoGetsNowhereSaysSo) {
  AvoiderHost host{
      named({{"algorithm", "direct"}, {"max_speed_mps", "0.5"}, {"policy.progress_window_s", "10"}})};
  ASSERT_TRUE(host.go_to({100, 0, 10}, 0.5));
  for (int i = 0; i <= 220; ++i) {
    host.own_motion({.time = 0.05 * i, .position_n = {0, 0, 10}}, 0.05 * i);
    host.update(0.05 * i);
  }
  const Diagnosis diagnosis = host.diagnosis(11.0);
  EXPECT_EQ(diagnosis.summary,
            "under way, no progress: trapped, and nobody is near who could clear the way (11.00 s)");
  EXPECT_EQ(value(diagnosis, "progress"), "trapped");
  EXPECT_EQ(value(diagnosis, "no_progress_s"), "11.00");
  EXPECT_EQ(value(diagnosis, "progress_with"), "");
}

TEST(AvoiderHost, APathIsFollowedPointByPoint) {
  AvoiderHost host{named({{"algorithm", "direct"}, {"max_speed_mps", "0.5"}, {"arrival_m", "0.5"}})};
  const std::vector<Triple> path{{5, 0, 10}, {5, 20, 10}, {5, 20, 10}, {25, 20, 12}};
  Triple at{0, 0, 10};
  Triple velocity{};
  host.own_motion({.time = 0, .position_n = at}, 0);
  ASSERT_TRUE(host.follow_path(path, 0.5));
  std::vector<Triple> goals;
  double aside = 0.0;
  double time = 0.0;
  for (int i = 0; host.order().state != "arrived"; ++i) {
    ASSERT_LT(i, 4000) << "it never comes to the end";
    time = 0.05 * i;
    host.own_motion({.time = time, .position_n = at, .v_b = velocity}, time);
    const Order& order = host.update(time);
    ASSERT_TRUE(order.state == "under_way" || order.state == "arrived") << order.state;
    if (host.goal() && (goals.empty() || goals.back() != *host.goal())) goals.push_back(*host.goal());
    if (goals.size() == 3) aside = std::fmax(aside, std::fabs(at[1] - 20.0));
    velocity = order.velocity_n;
    for (std::size_t k = 0; k < 3; ++k) at[k] += 0.05 * velocity[k];
  }
  EXPECT_THAT(goals, testing::ElementsAre(path[0], path[1], path[3]));
  EXPECT_LT(aside, 0.6) << "it keeps to the line";
  EXPECT_FALSE(host.goal());
}

TEST(AvoiderHost, WhatCannotBeGoneToIsRefusedAndChangesNothing) {
  AvoiderHost host{named({{"max_depth_m", "30"}})};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  host.own_motion(northward(0), 0);
  ASSERT_TRUE(host.go_to({50, 0, 10}, 0.5));
  EXPECT_FALSE(host.go_to({50, nan, 10}, 0.5));
  EXPECT_FALSE(host.go_to({50, 0, 10}, 0.0));
  EXPECT_FALSE(host.go_to({50, 0, 10}, nan));
  EXPECT_FALSE(host.go_to({50, 0, 40}, 0.5)) << "below the floor";
  EXPECT_FALSE(host.follow({1, 1, 1}, {1, 1, 1}, 0.5)) << "a line without length";
  EXPECT_FALSE(host.follow_path({}, 0.5));
  EXPECT_FALSE(host.follow_path({{60, 0, 10}, {70, 0, nan}}, 0.5));
  EXPECT_EQ(host.goal(), (Triple{50, 0, 10}));
}

TEST(AvoiderHost, TheDiagnosisSaysWhatItIsAbout) {
  AvoiderHost host{named({{"max_speed_mps", "0.5"}})};
  EXPECT_EQ(host.diagnosis(0).level, Diagnosis::Level::stale);
  EXPECT_EQ(host.diagnosis(0).summary, "waiting for own navigation");

  const auto tell_all = [&](double time) {
    host.own_motion(northward(time), time);
    host.neighbour_motion(0, northward(time, {0, 60, 10}), time);
    host.neighbour_motion(1, northward(time, {6, 4, 10}), time);
    host.update(time);
  };
  tell_all(0.0);
  EXPECT_EQ(host.diagnosis(0).summary, "idle: no goal");
  EXPECT_EQ(host.diagnosis(0).level, Diagnosis::Level::ok);

  host.go_to({200, 0, 10}, 0.5);
  for (int i = 1; i <= 20; ++i) tell_all(0.1 * i);
  EXPECT_THAT(host.diagnosis(2.0).summary, HasSubstr("under way, "));
  EXPECT_THAT(host.diagnosis(2.0).summary, HasSubstr("2 of 2"));
  EXPECT_EQ(host.diagnosis(2.0).level, Diagnosis::Level::ok);

  Motion unsure = northward(2.05);
  unsure.position_sigma = 0.4;
  host.own_motion(unsure, 2.05);
  EXPECT_EQ(value(host.diagnosis(2.05), "own.position_sigma_m"), "0.40");

  Motion broken = northward(2.1);
  broken.position_n[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_STREQ(host.neighbour_motion(0, broken, 2.1), "invalid");
  EXPECT_EQ(host.diagnosis(2.1).level, Diagnosis::Level::warning) << "for a while";
  EXPECT_EQ(value(host.diagnosis(2.1), "auv_2.invalid_count"), "1");
  for (int i = 22; i <= 80; ++i) tell_all(0.1 * i);
  EXPECT_EQ(host.diagnosis(8.0).level, Diagnosis::Level::ok);

  host.update(8.8);
  EXPECT_EQ(host.diagnosis(8.8).level, Diagnosis::Level::error);
  EXPECT_EQ(host.diagnosis(8.8).summary, "holding: own navigation is stale (0.80 s old)");
  host.update(11.2);
  EXPECT_EQ(host.diagnosis(11.2).summary, "handed back: own navigation is lost (3.20 s old)");
  EXPECT_EQ(value(host.diagnosis(11.2), "auv_3.growth_m"), "0.55") << "0.25 m/s since it was a second old";
}

TEST(AvoiderHost, WhatTheMethodDrewBecomesMarksRoundTheVehicle) {
  AvoiderHost host{named({{"max_speed_mps", "0.5"}})};
  host.own_motion(northward(0), 0);
  host.neighbour_motion(0, northward(0, {10, 1, 10}, -0.5), 0);
  host.go_to({200, 0, 10}, 0.5);
  host.update(0);
  EXPECT_TRUE(host.marks().empty()) << "nobody looks";
  host.own_motion(northward(0.1), 0.1);
  host.update(0.1, true);
  const std::vector<Mark> marks = host.marks();
  ASSERT_FALSE(marks.empty());
  bool has_plane = false;
  for (const Mark& mark : marks) {
    EXPECT_FALSE(mark.meaning.empty());
    has_plane = has_plane || mark.kind == Mark::Kind::triangles;
    for (const Triple& point : mark.points) EXPECT_LT(std::hypot(point[0], point[1], point[2] - 10.0), 40.0);
  }
  EXPECT_TRUE(has_plane) << "ORCA's half-space";
}

TEST(AvoiderHost, IsCompleteOnceEveryoneWasHeardOfThatInstant) {
  AvoiderHost host{named()};
  host.own_motion(northward(1), 1);
  host.neighbour_motion(0, northward(1, {0, 60, 10}), 1);
  EXPECT_FALSE(host.is_complete(1.0));
  host.neighbour_motion(1, northward(1, {0, 90, 10}), 1);
  EXPECT_TRUE(host.is_complete(1.0));
  EXPECT_FALSE(host.is_complete(1.05));
}

/// What a simulated vehicle believes, as a message has it.
Motion motion_of(const VehicleState& x, double time) {
  return {.time = time,
          .position_n = {x.p_n.x(), x.p_n.y(), x.p_n.z()},
          .q_nb = {x.q_nb.w(), x.q_nb.x(), x.q_nb.y(), x.q_nb.z()},
          .v_b = {x.v_b.x(), x.v_b.y(), x.v_b.z()},
          .omega_b = {x.omega_b.x(), x.omega_b.y(), x.omega_b.z()}};
}

TEST(AvoiderHost, WithAScenarioAndPerfectMessagesItDecidesAsTheSimulationDoesToTheBit) {
  const Scenario scenario = load_scenario(cube);
  Simulation simulation{scenario, builtin_catalogs()};
  std::vector<AvoiderHost> hosts;
  for (const VehicleSpec& spec : scenario.vehicles) {
    hosts.emplace_back(AvoiderOptions{.scenario = cube, .vehicle = spec.name, .settings = {}, .seed = {}});
  }
  int decisions = 0;
  while (!simulation.is_done()) {
    simulation.look();
    const double now = simulation.time();
    for (std::size_t i = 0; i < hosts.size(); ++i) {
      for (std::size_t k = 0; k < hosts.size(); ++k) {
        const Motion motion = motion_of(simulation.agents()[k].estimate(), now);
        if (k == i) hosts[i].own_motion(motion, now);
        if (k != i) hosts[i].neighbour_motion(k < i ? k : k - 1, motion, now);
      }
      const Agent& agent = simulation.agents()[i];
      if (!simulation.is_deciding(i)) continue;
      const Leg& leg = *agent.mission.leg();
      ASSERT_TRUE(hosts[i].go_to({leg.position.x(), leg.position.y(), leg.position.z()}, leg.speed_mps));
      ASSERT_TRUE(hosts[i].is_complete(now));
      const Order& order = hosts[i].update(now);
      const Command command = Avoider{agent.avoider}.decide(simulation.situation(i));
      ASSERT_EQ(order.velocity_n, (Triple{command.velocity.x(), command.velocity.y(), command.velocity.z()}));
      ++decisions;
    }
    simulation.act({});
  }
  EXPECT_GT(decisions, 8 * 1000);
}

}  // namespace
}  // namespace fairway::bridge
