// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "ros/bridge/testing/message_laws.hpp"
#include "ros/ros2/middleware.hpp"
#include "ros/ros2/ros_args.hpp"

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

TEST(RosArguments, AreThoseOfALaunchFileAndOfPeople) {
  const std::string file = std::filesystem::temp_directory_path() / "fairway_ros2_params.yaml";
  std::ofstream{file} << "/**:\n  ros__parameters: {draw: true, params: {time_horizon_s: 7}, team: [b, c]}\n"
                         "other:\n  ros__parameters: {draw: false}\n";
  const RosArguments made =
      ros_arguments({"--frame", "ned", "--rate_hz=5", "--ros-args", "-r", "__ns:=/auv", "-r",
                     "pilot:__node:=helm", "-r", "odometry:=odom", "-p", "speed_mps:=0.4", "--params-file",
                     file, "--log-level", "info", "--", "--set", "a=b"},
                    "pilot");
  std::filesystem::remove(file);
  EXPECT_EQ(made.graph.space, "/auv");
  EXPECT_EQ(made.graph.node, "helm");
  EXPECT_THAT(made.graph.remaps, ElementsAre(Pair("odometry", "odom")));
  EXPECT_THAT(made.settings, ElementsAre(Pair("draw", "true"), Pair("params.time_horizon_s", "7"),
                                         Pair("team", "b c"), Pair("frame", "ned"), Pair("rate_hz", "5"),
                                         Pair("speed_mps", "0.4"), Pair("a", "b")));
  EXPECT_TRUE(made.words.empty());
  EXPECT_THROW(ros_arguments({"--ros-args", "-p", "speed"}, "n"), std::runtime_error);
  EXPECT_THROW(ros_arguments({"--ros-args", "-x"}, "n"), std::runtime_error);
  EXPECT_THROW(ros_arguments({"--ros-args", "--params-file", "nowhere.yaml"}, "n"), std::runtime_error);
}

}  // namespace
}  // namespace ros2
}  // namespace fairway
