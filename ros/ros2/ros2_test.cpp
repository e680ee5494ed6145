// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "ros/ros2/convert.hpp"
#include "ros/ros2/ros_args.hpp"

namespace fairway::ros2 {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(Stamps, AreToTheNearestNanosecondAndReadBackTheSame) {
  EXPECT_EQ(stamp_of(55.55).sec, 55);
  EXPECT_EQ(stamp_of(55.55).nanosec, 550000000U);
  EXPECT_EQ(stamp_of(1.9999999999).sec, 2) << "no stamp has a thousand million nanoseconds";
  EXPECT_EQ(stamp_of(1.9999999999).nanosec, 0U);
  EXPECT_EQ(stamp_of(-1).sec, 0);
  EXPECT_EQ(stamp_of(std::nan("")).sec, 0);
  for (int tick = 0; tick < 100000; ++tick) {
    const Time stamp = stamp_of(tick * 0.05), again = stamp_of(seconds_of(stamp));
    ASSERT_TRUE(stamp.sec == again.sec && stamp.nanosec == again.nanosec) << tick;
    ASSERT_EQ(stamp.nanosec % 50000000U, 0U) << tick;
  }
}

TEST(Odometry, NorthBoundNoseDownIsAsRep103HasIt) {
  // heading north, 0.2 rad nose down, 3 m north, 4 m east, 5 m deep, diving: all in NED and FRD
  const double half = -0.1;
  const Motion motion{
      7.5, {3, 4, 5}, {std::cos(half), 0, std::sin(half), 0}, {0.5, 0.1, 0.2}, {0.01, 0.02, 0.03}};
  Memory memory;
  const Odometry odometry = odometry_of(motion, Frame::enu, "world", "auv", memory);
  EXPECT_STREQ(odometry.header.frame_id, "world");
  EXPECT_STREQ(odometry.child_frame_id, "auv");
  const auto& [p, q] = odometry.pose.pose;
  EXPECT_EQ(p.x, 4);
  EXPECT_EQ(p.y, 3);
  EXPECT_EQ(p.z, -5);
  EXPECT_EQ(odometry.twist.twist.linear.y, -0.1) << "left, not starboard";
  EXPECT_EQ(odometry.twist.twist.angular.z, -0.03) << "anticlockwise from above";
  // forward in ENU: to the north and down
  EXPECT_NEAR(1 - 2 * (q.y * q.y + q.z * q.z), 0, 1e-12);
  EXPECT_NEAR(2 * (q.x * q.y + q.w * q.z), std::cos(0.2), 1e-12);
  EXPECT_NEAR(2 * (q.x * q.z - q.w * q.y), -std::sin(0.2), 1e-12);
}

TEST(Odometry, InNedNothingChangesNotABitAndInEnuItComesBack) {
  const Motion motion{7.5, {1.0 / 3, -4e-7, 5e5}, {0.5, -0.5, 0.5, 0.5}, {0.1, 0.2, 0.3}, {-0.1, 1e-9, 3}};
  for (const Frame frame : {Frame::ned, Frame::enu}) {
    Memory memory;
    const Motion back = motion_of(odometry_of(motion, frame, "world", "auv", memory), frame);
    EXPECT_EQ(back.time, motion.time);
    EXPECT_EQ(back.position_n, motion.position_n);
    EXPECT_EQ(back.v_b, motion.v_b);
    EXPECT_EQ(back.omega_b, motion.omega_b);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(back.q_nb[i], motion.q_nb[i], frame == Frame::ned ? 0.0 : 1e-15) << i;
  }
}

TEST(Commands, AreTurnedOverAndComeBack) {
  const BodyVelocity request{0.5, 0.1, -0.2, 0.3};
  Memory memory;
  const TwistStamped enu = twist_of(request, 1.25, Frame::enu, "auv", memory);
  EXPECT_EQ(enu.twist.linear.y, -0.1);
  EXPECT_EQ(enu.twist.linear.z, 0.2) << "up";
  EXPECT_EQ(enu.twist.angular.z, -0.3);
  const BodyVelocity back = body_velocity_of(enu, Frame::enu);
  EXPECT_EQ(back.heave_mps, -0.2);
  EXPECT_EQ(back.yaw_rate_radps, 0.3);
}

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

TEST(Markers, ClearWhatWasAndShowWhatIs) {
  const Mark ball{Mark::Kind::sphere, "safety", {{1, 2, 3}}, 1.5, {1, 0, 0, 0.5F}};
  const Mark line{Mark::Kind::line, "", {{0, 0, 0}, {1, 0, 0}}};
  Memory memory;
  const MarkerArray array = markers_of({ball, line}, 2.0, Frame::enu, "world", "auv", memory);
  const auto markers = elements(array.markers);
  ASSERT_EQ(markers.size(), 3U);
  EXPECT_EQ(markers[0].action, 3) << "DELETEALL";
  EXPECT_STREQ(markers[1].ns, "auv/safety");
  EXPECT_EQ(markers[1].scale.x, 3.0) << "a diameter";
  EXPECT_EQ(markers[1].pose.position.z, -3);
  EXPECT_EQ(elements(markers[2].points).size(), 2U);
  EXPECT_EQ(elements(markers[2].points)[1].y, 1) << "north";
}

}  // namespace
}  // namespace fairway::ros2
