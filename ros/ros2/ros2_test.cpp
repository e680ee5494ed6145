// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "ros/bridge/testing/message_laws.hpp"
#include "ros/ros2/middleware.hpp"
#include "ros/ros2/ros_args.hpp"
#include "ros/ros2/twin_readers.hpp"

namespace fairway {
namespace bridge {
INSTANTIATE_TYPED_TEST_SUITE_P(Ros2, Messages, ros2::Middleware);
}

namespace ros2 {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

TEST(Topics, AreResolvedAsRos2DoesIt) {
  const GraphOptions options{
      .node = "pilot", .space = "/auv", .remaps = {{"odometry", "/nav/odom"}, {"/diagnostics", "diag"}}};
  EXPECT_EQ(resolved(options, "goal"), "/auv/goal");
  EXPECT_EQ(resolved(options, "/clock"), "/clock");
  EXPECT_EQ(resolved(options, "~/state"), "/auv/pilot/state");
  EXPECT_EQ(resolved(options, "odometry"), "/nav/odom");
  EXPECT_EQ(resolved(options, "/auv/odometry"), "/nav/odom");
  EXPECT_EQ(resolved(options, "/diagnostics"), "/auv/diag");
  EXPECT_EQ(resolved({.node = "n", .space = "/"}, "goal"), "/goal");
}

TEST(TwinReaders, HandleAMessageOnceEvenOfAClockThatWasSetBack) {
  TwinReaders twins;
  constexpr std::int64_t second = 1'000'000'000;
  for (const std::int64_t sent : {10 * second, 11 * second, 6 * second, 7 * second}) {
    EXPECT_FALSE(twins.has_been_seen(1, sent, 5)) << sent;
    EXPECT_TRUE(twins.has_been_seen(1, sent, 6)) << sent;
  }
  EXPECT_FALSE(twins.has_been_seen(1, 12 * second, 5));
  EXPECT_FALSE(twins.has_been_seen(2, 12 * second, 6)) << "of another publisher";
  EXPECT_TRUE(twins.has_been_seen(1, 12 * second, 6));
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(twins.has_been_seen(1, i, 5)) << "which the other never has";
}

TEST(RosArguments, AreThoseOfALaunchFileAndOfPeople) {
  const std::string file = std::filesystem::temp_directory_path() / "fairway_ros2_params.yaml";
  std::ofstream{file} << "/**:\n  ros__parameters: {draw: true, params: {time_horizon_s: 7}, team: [b, c]}\n"
                         "other:\n  ros__parameters: {draw: false}\n";
  const RosArguments made =
      ros_arguments({"--frame", "ned", "--rate_hz=5", "--ros-args", "-r", "__ns:=/auv", "-r",
                     "pilot:__node:=helm", "-r", "odometry:=odom", "-p", "speed_mps:=0.4", "--params-file",
                     file, "--log-level", "info", "--", "--set", "a=b"},
                    "pilot");
  const bridge::Settings settings = settings_of(made);
  std::filesystem::remove(file);
  EXPECT_EQ(made.graph.space, "/auv");
  EXPECT_EQ(made.graph.node, "helm");
  EXPECT_THAT(made.graph.remaps, ElementsAre(Pair("odometry", "odom")));
  EXPECT_THAT(settings, ElementsAre(Pair("draw", "true"), Pair("params.time_horizon_s", "7"),
                                    Pair("team", "b c"), Pair("frame", "ned"), Pair("rate_hz", "5"),
                                    Pair("speed_mps", "0.4"), Pair("a", "b")));
  EXPECT_TRUE(made.words.empty());
  EXPECT_THROW(ros_arguments({"--ros-args", "-p", "speed"}, "n"), std::runtime_error);
  EXPECT_THROW(ros_arguments({"--ros-args", "-x"}, "n"), std::runtime_error);
  EXPECT_THROW(settings_of(ros_arguments({"--ros-args", "--params-file", "nowhere.yaml"}, "n")),
               std::runtime_error);
}

TEST(RosArguments, AValueIsYaml) {
  const auto given = [](const std::string& parameter) {
    return ros_arguments({"--ros-args", "-p", parameter}, "pilot").given;
  };
  EXPECT_THAT(given("team:=['auv_2','auv_3']"), ElementsAre(Pair("team", "auv_2 auv_3")));
  EXPECT_THAT(given("algorithm:='orca3d'"), ElementsAre(Pair("algorithm", "orca3d")));
  EXPECT_THAT(given("algorithm:=orca3d+stop_and_wait"),
              ElementsAre(Pair("algorithm", "orca3d+stop_and_wait")));
  EXPECT_THAT(given("record:="), ElementsAre(Pair("record", "")));
  EXPECT_THAT(given("params:={time_horizon_s: 7}"), ElementsAre(Pair("params.time_horizon_s", "7")));
  EXPECT_THROW(given("team:=['auv_2'"), std::runtime_error);
}

TEST(RosArguments, WhatIsForAnotherNodeIsLeftToIt) {
  const RosArguments made = ros_arguments(
      {"--ros-args", "-r", "other:__ns:=/elsewhere", "-r", "other:__node:=stranger", "-r", "other:goal:=aim",
       "-r", "pilot:__ns:=/auv", "-r", "pilot:__node:=helm", "-r", "helm:odometry:=odom", "-p",
       "other:draw:=true", "-p", "pilot:rate_hz:=5", "-p", "helm:frame:=ned"},
      "pilot");
  EXPECT_EQ(made.graph.space, "/auv");
  EXPECT_EQ(made.graph.node, "helm");
  EXPECT_THAT(made.graph.remaps, ElementsAre(Pair("odometry", "odom")));
  EXPECT_THAT(made.given, ElementsAre(Pair("rate_hz", "5"), Pair("frame", "ned")));
}

/// What a file says of /fleet/auv_1/pilot: the names that it sets, or what is warned of.
std::string told_by(const std::string& text) {
  const std::string file = std::filesystem::temp_directory_path() / "fairway_ros2_names.yaml";
  std::ofstream{file} << text;
  RosArguments arguments;
  arguments.graph = {.node = "pilot", .space = "/fleet/auv_1"};
  arguments.files = {file};
  std::string told, warned;
  for (const auto& [name, value] : settings_of(arguments, [&](const std::string& words) { warned = words; }))
    told += name + " ";
  std::filesystem::remove(file);
  return told + warned.substr(std::min(warned.size(), file.size()));
}

TEST(ParameterFiles, AreReadByNestedNamespacesAndWildcards) {
  const std::string none = ": has no parameters for /fleet/auv_1/pilot";
  const auto below = [](const std::string& key) { return key + ": {ros__parameters: {a: 1}}\n"; };
  for (const char* mine : {"/**", "/fleet/auv_1/pilot", "fleet/auv_1/pilot", "/fleet/*/pilot", "/**/pilot",
                           "/*/*/*", "/fleet/**", "pilot"})
    EXPECT_EQ(told_by(below(mine)), "a ") << mine;
  for (const char* others :
       {"/*", "/fleet/auv_2/pilot", "/fleet/pilot", "/*/pilot", "/fleet/auv_1", "/pilot", "helm"})
    EXPECT_EQ(told_by(below(others)), none) << others;
  EXPECT_EQ(told_by("fleet:\n  auv_1:\n    pilot:\n      ros__parameters: {b: 2}\n"
                    "  auv_2:\n    pilot:\n      ros__parameters: {c: 3}\n"),
            "b ");
  EXPECT_EQ(told_by("/fleet:\n  '*':\n    pilot:\n      ros__parameters: {b: 2}\n"), "b ");
  EXPECT_EQ(told_by(below("/**") + "/fleet:\n  '**':\n    ros__parameters: {b: 2}\n"), "a b ");
  EXPECT_EQ(told_by("a: 1\n"), none);
}

}  // namespace
}  // namespace ros2
}  // namespace fairway
