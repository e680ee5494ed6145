// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/avoider_settings.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>

namespace fairway::ros1 {
namespace {

using XmlRpc::XmlRpcValue;

std::string what(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

std::string setting(const AvoiderSettings& settings, const std::string& name) {
  for (const auto& [key, value] : settings.host.settings) {
    if (key == name) return value;
  }
  return "(none)";
}

TEST(AvoiderSettings, are_those_of_a_vehicle_that_is_told_nothing) {
  const AvoiderSettings settings = read_avoider_settings(XmlRpcValue{}, "robot3");
  EXPECT_EQ(settings.host.vehicle, "robot3");
  EXPECT_EQ(settings.frame, bridge::Frame::enu);
  EXPECT_EQ(settings.input, AvoiderInput::odometry);
  EXPECT_TRUE(settings.host.settings.empty());
}

TEST(AvoiderSettings, keep_their_own_and_hand_on_the_rest_as_it_was_written) {
  XmlRpcValue parameters;
  parameters["scenario"] = "cube.yaml";
  parameters["frame"] = "ned";
  parameters["input"] = "both";
  parameters["seed"] = 7;
  parameters["speed_mps"] = 0.5;
  parameters["advisory"] = true;
  parameters["algorithm"] = "orca3d+stop_and_wait";
  parameters["params"]["time_horizon_s"] = 5.1;
  parameters["policy"]["neighbour_lost"] = "hold";
  const AvoiderSettings settings = read_avoider_settings(parameters, "robot3");
  EXPECT_EQ(settings.host.scenario, "cube.yaml");
  EXPECT_EQ(settings.frame, bridge::Frame::ned);
  EXPECT_EQ(settings.input, AvoiderInput::both);
  EXPECT_EQ(settings.host.seed, 7U);
  EXPECT_EQ(settings.speed_mps, 0.5);
  EXPECT_TRUE(settings.advisory);
  EXPECT_EQ(setting(settings, "algorithm"), "orca3d+stop_and_wait");
  EXPECT_EQ(setting(settings, "params.time_horizon_s"), "5.1");
  EXPECT_EQ(setting(settings, "policy.neighbour_lost"), "hold");
  EXPECT_EQ(settings.host.settings.size(), 3U);
}

TEST(AvoiderSettings, take_a_team_as_a_list_as_words_or_as_a_folder) {
  XmlRpcValue list;
  list["team"][0] = "auv_2";
  list["team"][1] = "auv_3";
  EXPECT_EQ(setting(read_avoider_settings(list, "auv_1"), "team"), "auv_2 auv_3");

  XmlRpcValue words;
  words["team"] = "auv_2 auv_3";
  EXPECT_EQ(setting(read_avoider_settings(words, "auv_1"), "team"), "auv_2 auv_3");

  XmlRpcValue folder;
  folder["team"]["auv_2"]["radius_m"] = 3.5;
  folder["team"]["auv_3"]["priority"] = 2;
  const AvoiderSettings settings = read_avoider_settings(folder, "auv_1");
  EXPECT_EQ(setting(settings, "team"), "auv_2 auv_3");
  EXPECT_EQ(setting(settings, "team.auv_2.radius_m"), "3.5");
  EXPECT_EQ(setting(settings, "team.auv_3.priority"), "2");
}

TEST(AvoiderSettings, say_in_a_line_what_is_wrong) {
  const auto said = [](const char* name, const XmlRpcValue& value) {
    XmlRpcValue parameters;
    parameters[name] = value;
    return what([&] { read_avoider_settings(parameters, "robot3"); });
  };
  EXPECT_EQ(said("advisory", "perhaps"), "~advisory: 'perhaps': expected true or false");
  EXPECT_EQ(said("rate_hz", -1.0), "~rate_hz: -1: expected a number from 0.1 to 1000");
  EXPECT_NE(said("seed", "three").find("'three': expected a number"), std::string::npos);
  EXPECT_NE(said("input", "sonar").find("'sonar': expected odometry, team_record or both"),
            std::string::npos);
  EXPECT_NE(said("frame", "nwu").find("nwu"), std::string::npos);
}

TEST(AvoiderSettings, refuse_to_wait_for_odometry_that_nobody_sends) {
  XmlRpcValue parameters;
  parameters["lockstep"] = true;
  parameters["input"] = "team_record";
  EXPECT_NE(what([&] { read_avoider_settings(parameters, "robot3"); }).find("lockstep"), std::string::npos);
}

TEST(AvoiderSettings, are_all_on_their_page) {
  std::ifstream file{FAIRWAY_SOURCE_DIR "/docs/ros_avoider.md"};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  for (const std::string& name : read_avoider_settings(XmlRpcValue{}, "robot3").host.also_known)
    EXPECT_NE(page.find("`" + name + "`"), std::string::npos) << name;
}

}  // namespace
}  // namespace fairway::ros1
