// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/avoider_setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "fairway/core/testing/refusal.hpp"

namespace fairway::bridge {
namespace {

using testing::HasSubstr;

AvoiderOptions of_scenario(const Settings& settings) {
  return {.scenario = FAIRWAY_SOURCE_DIR "/scenarios/cube20_8.yaml",
          .vehicle = "robot3",
          .settings = settings,
          .seed = {}};
}

std::string refused_with(const Settings& settings) {
  return refusal_by([&] { avoider_setup(of_scenario(settings)); });
}

TEST(AvoiderSetup, AnAlgorithmMayBeAFileAsTuneLeavesIt) {
  const std::string file = std::filesystem::temp_directory_path() / "fairway_avoider_best.yaml";
  const auto with = [&](const std::string& text, Settings settings) {
    std::ofstream{file} << text;
    settings.emplace_back("algorithm", file);
    return settings;
  };
  const std::string tuned = "# Tuned by fairway\nalgorithm: orca3d+stop_and_wait\ncrit_dist_m: 6\n";
  const Settings settings = with(tuned, {{"params.time_horizon_s", "7"}});
  EXPECT_EQ(avoider_setup(of_scenario(settings)).algorithm, "orca3d+stop_and_wait");
  EXPECT_EQ(avoider_setup({.scenario = "", .vehicle = "auv", .settings = settings, .seed = {}}).algorithm,
            "orca3d+stop_and_wait");
  EXPECT_THAT(refused_with(with("algorithm: orca3d\ntime_horizon: 6\n", {})),
              HasSubstr("did you mean time_horizon_s?"));
  EXPECT_THAT(refused_with(with("algorithm: orca3\n", {})), HasSubstr("did you mean orca3d?"));
  EXPECT_THAT(refused_with(with("crit_dist_m: 6\n", {})), HasSubstr("fairway_avoider_best.yaml"));
  std::filesystem::remove(file);
  EXPECT_THAT(refused_with({{"algorithm", "nowhere.yaml"}}),
              HasSubstr("nowhere.yaml: cannot be opened for reading"));
}

TEST(AvoiderSetup, ATeamInBracketsOrQuotesIsNoTeam) {
  for (const char* team : {"['robot0','robot7']", "\"robot0 robot7\"", "[robot0, robot7]"})
    EXPECT_THAT(refused_with({{"team", team}}), HasSubstr("expected names with blanks or commas between"));
}

}  // namespace
}  // namespace fairway::bridge
