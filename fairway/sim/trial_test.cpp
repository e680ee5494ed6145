// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/trial.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "fairway/core/state.hpp"

namespace fairway {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

std::string trial(const std::string& csv, const ParamValues& settings = {},
                  std::string_view vehicle = "sparus2") {
  std::istringstream inputs{csv};
  std::ostringstream outputs;
  run_trial(builtin_vehicles(), vehicle, inputs, "in.csv", outputs, settings);
  return outputs.str();
}

/// Rows of numbers under the header.
std::vector<std::vector<double>> rows_of(const std::string& csv) {
  std::istringstream lines{csv};
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "time_s,x_m,y_m,z_m,roll_rad,pitch_rad,yaw_rad,u_mps,v_mps,w_mps,p_radps,q_radps,r_radps");
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    rows.emplace_back();
    std::istringstream cells{line};
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
    EXPECT_EQ(rows.back().size(), 13u);
  }
  return rows;
}

TEST(Trial, FirstRowIsTheInitialState) {
  const auto rows = rows_of(trial("time_s\n2.5\n", {{"state.x_m", 1.0},
                                                    {"state.y_m", -2.0},
                                                    {"state.z_m", 3.0},
                                                    {"state.roll_rad", 0.1},
                                                    {"state.pitch_rad", -0.2},
                                                    {"state.yaw_rad", 2.0},
                                                    {"state.u_mps", 0.4},
                                                    {"state.v_mps", 0.5},
                                                    {"state.w_mps", 0.6},
                                                    {"state.p_radps", 0.7},
                                                    {"state.q_radps", 0.8},
                                                    {"state.r_radps", 0.9}}));
  const std::vector<double> expected{2.5, 1, -2, 3, 0.1, -0.2, 2.0, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};
  ASSERT_EQ(rows.size(), 1u);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(rows[0][i], expected[i], 1e-15);
}

TEST(Trial, HoldsEachRowUntilTheNextAndKeepsTheLimits) {
  // 1000 N is cut to 71.5 N on either side; steady speed sqrt(143 / 14.2); then it coasts: u = u0 / (1 + d u0
  // t / m)
  const auto rows = rows_of(trial("time_s,surge_starboard_n,surge_port_n\n0,1000,1000\n100,0,0\n110,0,0\n",
                                  {{"buoyancy_kg", 52.0}}));
  ASSERT_EQ(rows.size(), 3u);
  const double steady = std::sqrt(143.0 / 14.2);
  EXPECT_NEAR(rows[1][7], steady, 1e-9);
  EXPECT_NEAR(rows[2][7], steady / (1 + 14.2 * steady * 10 / 54.0), 1e-6);
}

TEST(Trial, ThrustIsImmediateUnlessActuatorDynamicsAreAskedFor) {
  const std::string csv = "time_s,surge_port_n,surge_starboard_n\n0,10,10\n0.1,0,0\n";
  const ParamValues plain{{"buoyancy_kg", 52.0}};
  ParamValues lagging = plain;
  lagging.emplace_back("actuator_dynamics", true);
  EXPECT_NEAR(rows_of(trial(csv, plain))[1][7], 20.0 / 54.0 * 0.1, 1e-4);
  // u(t) = F / m (t - T (1 - exp(-t / T))) with T = 0.8 s
  EXPECT_NEAR(rows_of(trial(csv, lagging))[1][7], 20.0 / 54.0 * (0.1 - 0.8 * (1 - std::exp(-0.1 / 0.8))),
              1e-5);
}

TEST(Trial, CurrentCarriesAndDensityLifts) {
  const ParamValues current{{"current.north_mps", 0.5},
                            {"current.east_mps", -0.25},
                            {"state.u_mps", 0.5},
                            {"state.v_mps", -0.25},
                            {"buoyancy_kg", 52.0}};
  const auto drifted = rows_of(trial("time_s\n0\n10\n", current));
  EXPECT_NEAR(drifted[1][1], 5.0, 1e-9);
  EXPECT_NEAR(drifted[1][2], -2.5, 1e-9);
  const auto lifted = rows_of(trial("time_s\n0\n10\n", {{"water.density_kgpm3", 1025.0}}));
  EXPECT_LT(lifted[1][3], rows_of(trial("time_s\n0\n10\n"))[1][3] - 1.0);
}

TEST(Trial, ARegularWaveLiftsABoat) {
  // 0.3 m, 8 s and 100 m: at the crest, a whole period on, the boat is 0.3 m higher than in calm water
  const std::string csv = "time_s\n100\n140\n144\n";
  const auto calm = rows_of(trial(csv, {}, "otter"));
  const auto lifted = rows_of(
      trial(csv, {{"wave.amplitude_m", 0.3}, {"wave.period_s", 8.0}, {"wave.direction_deg", 90.0}}, "otter"));
  EXPECT_NEAR(lifted[1][3] - calm[1][3], -0.3, 0.01);
  EXPECT_NEAR(lifted[2][3] - calm[2][3], 0.3, 0.01);
  EXPECT_THAT(
      [&] {
        trial(csv, {{"wave.period_s", 0.0}}, "otter");
      },
      ThrowsMessage<InputError>(StartsWith("wave.period_s: is 0")));
}

TEST(Trial, StepLengthDoesNotShow) {
  const std::string csv = "time_s,heave_n,surge_port_n\n0,5,3\n7.3,-2,1\n20,0,0\n";
  const auto coarse = rows_of(trial(csv)), fine = rows_of(trial(csv, {{"step_s", 0.001}}));
  for (std::size_t i = 0; i < 13; ++i) EXPECT_NEAR(coarse[2][i], fine[2][i], 1e-4);  // measured 2e-6
}

TEST(Trial, DrivesAKinematicVehicleAndReadsUntidyFiles) {
  const auto rows =
      rows_of(trial("\xEF\xBB\xBF yaw_rate_radps , time_s,surge_mps\r\n\r\n 0 , +0 , 0.5\r\n0,10,0.5\r\n\n",
                    {{"state.u_mps", 0.5}}, "kinematic"));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NEAR(rows[1][1], 5.0, 1e-9);
}

TEST(Trial, RefusesWhatItCannotUseAndSaysWhere) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "in.csv:1:1: empty"},
      {"time_s,heave_n\n", "in.csv:1:1: no rows"},
      {"heave_n\n0\n", "in.csv:1:1: time_s: column missing"},
      {"time_s,heave\n0,0\n", "in.csv:1:8: heave: unknown column; did you mean heave_n?"},
      {"time_s,,heave_n\n0,0,0\n", "in.csv:1:8: \"\": unknown column"},
      {"time_s,heave_n,heave_n\n0,0,0\n", "in.csv:1:16: heave_n: column given twice"},
      {"time_s,heave_n\n0,0\n1,two\n", "in.csv:3:3: heave_n: is \"two\"; expected a finite number"},
      {"time_s,heave_n\n0,\n", "in.csv:2:3: heave_n: is \"\""},
      {"time_s,heave_n\n0,nan\n", "in.csv:2:3: heave_n: is \"nan\""},
      {"time_s,heave_n\n0,0\n1e300,0\n",
       "in.csv:3:1: time_s: is 1e+300; expected a number in [-1e+07, 1e+07]"},
      {"time_s,heave_n\ninf,0\n", "in.csv:2:1: time_s: is \"inf\""},
      {"time_s,heave_n\n0,true\n", "in.csv:2:3: heave_n: is \"true\""},
      {"time_s,heave_n\n0,1\n0.5\n", "in.csv:3:1: 1 cells under a header of 2"},
      {"time_s,heave_n\n0,1,2\n", "in.csv:2:5: 3 cells under a header of 2"},
      {"time_s,heave_n\n0,1\n2,1\n2,1\n", "in.csv:4:1: time_s: is 2, not after 2"},
  };
  for (const auto& [csv, message] : cases) {
    std::istringstream inputs{csv};
    std::ostringstream outputs;
    EXPECT_THAT([&] { run_trial(builtin_vehicles(), "sparus2", inputs, "in.csv", outputs, {}); },
                ThrowsMessage<InputError>(StartsWith(message)))
        << csv;
    EXPECT_EQ(outputs.str(), "");
  }
}

TEST(Trial, RefusesUnknownSettingsAndVehicles) {
  const std::string csv = "time_s\n0\n1\n";
  EXPECT_THAT([&] { trial(csv, {{"state.u", 1.0}}); }, ThrowsMessage<InputError>(HasSubstr("state.u_mps?")));
  EXPECT_THAT(
      [&] {
        trial(csv, {{"curent.north_mps", 1.0}});
      },
      ThrowsMessage<InputError>(HasSubstr("did you mean current.north_mps?")));
  EXPECT_THAT(
      [&] {
        trial(csv, {{"state.u_mps", std::string("fast")}});
      },
      ThrowsMessage<InputError>(StartsWith("state.u_mps: is \"fast\"; expected a number in")));
  EXPECT_THAT([&] { trial(csv, {{"step_s", 0.0}}); }, ThrowsMessage<InputError>(StartsWith("step_s: is 0")));
  EXPECT_THAT(
      [&] {
        trial(csv, {{"mass", 50.0}});
      },
      ThrowsMessage<InputError>(HasSubstr("did you mean mass_kg?")));
  EXPECT_THAT([&] { trial(csv, {}, "sparus"); },
              ThrowsMessage<InputError>(HasSubstr("did you mean sparus2?")));
}

}  // namespace
}  // namespace fairway
