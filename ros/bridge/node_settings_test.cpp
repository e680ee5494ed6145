// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/node_settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace fairway::bridge {
namespace {

using testing::HasSubstr;

TEST(NodeSettings, WhatIsNotTheNodesOwnGoesToTheAvoiderOrIsRefusedWithTheNearestName) {
  const AvoiderNodeSettings made =
      avoider_node_settings({{"frame", "ned"}, {"params.time_horizon_s", "7"}}, "auv");
  EXPECT_EQ(made.frame, Frame::ned);
  EXPECT_EQ(made.vehicle, "auv");
  EXPECT_EQ(made.settings, (Settings{{"params.time_horizon_s", "7"}}));
  const FleetNodeSettings fleet = fleet_node_settings({{"scenario", "a.yaml"}, {"override.duration_s", "9"}});
  EXPECT_EQ(fleet.overrides, (Settings{{"duration_s", "9"}}));
  EXPECT_EQ(topic_name("AUV 1-b"), "AUV_1_b");
  EXPECT_THROW(fleet_node_settings({{"scenario", "a.yaml"}, {"locksteps", "true"}}), std::runtime_error);
  EXPECT_THROW(fleet_node_settings({{"scenario", "a.yaml"}, {"speed", "-1"}}), std::runtime_error);
  EXPECT_THROW(avoider_node_settings({{"lockstep", "true"}, {"input", "team_record"}}, "auv"),
               std::runtime_error);
}

TEST(NodeSettings, SayInALineWhatIsWrong) {
  const auto said = [](const char* name, const char* text) -> std::string {
    try {
      fleet_node_settings({{"scenario", "a.yaml"}, {name, text}});
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(said("lockstep", "perhaps"), "lockstep: is \"perhaps\"; expected true or false");
  EXPECT_EQ(said("speed", "-1"), "speed: is -1; expected a number in [0, 1e+06]");
  EXPECT_THAT(said("speed", "nan"), HasSubstr("expected a number in"));
  EXPECT_EQ(said("frame", "nwu"), "frame: is \"nwu\"; expected one of enu, ned");
  EXPECT_EQ(said("seed", "1.5"), "seed: is 1.5; expected a whole number");
  EXPECT_THAT(said("seed", "three"), HasSubstr("is \"three\"; expected a number"));
  EXPECT_EQ(said("sped", "3"), "sped: unknown setting; did you mean seed?");
  EXPECT_EQ(said("seed", "12345678901"), "");
}

TEST(NodeSettings, ASeedIsAnyNumberOf64Bits) {
  const auto seed = [](const char* text) {
    return fleet_node_settings({{"scenario", "a.yaml"}, {"seed", text}}).seed;
  };
  EXPECT_EQ(seed("18446744073709551615"), 18446744073709551615U);
  EXPECT_EQ(seed("9007199254740993"), 9007199254740993U);
  EXPECT_EQ(seed("1e3"), 1000U);
  EXPECT_THROW(seed("18446744073709551616"), std::runtime_error);
  EXPECT_THROW(seed("-1"), std::runtime_error);
}

TEST(NodeSettings, AreAllOnTheirPages) {
  const auto page = [](const char* name) {
    std::ifstream file{std::string{FAIRWAY_SOURCE_DIR} + "/docs/" + name};
    return std::string{std::istreambuf_iterator<char>{file}, {}};
  };
  const auto names_in = [](const std::string& listing) {
    std::istringstream lines{listing};
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line);) names.push_back(line.substr(2, line.find(' ', 2) - 2));
    return names;
  };
  const std::string avoider = page("ros_avoider.md") + page("ros2.md"), fleet = page("ros.md");
  ASSERT_GT(names_in(avoider_node_words()).size(), 10U);
  for (const std::string& name : names_in(avoider_node_words()))
    EXPECT_THAT(avoider, HasSubstr("`" + name + "`"));
  for (const std::string& name : names_in(fleet_node_words()))
    EXPECT_THAT(fleet, HasSubstr("`" + name + "`"));
}

}  // namespace
}  // namespace fairway::bridge
