// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ros/ros1/conversions.hpp"
#include "ros/ros1/parameters.hpp"

namespace fairway::ros1 {
namespace {

constexpr double half_sqrt2 = 0.70710678118654752440;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Messages, AStampIsTheNearestNanosecond) {
  EXPECT_EQ(stamp_of(0.15), ros::Time(0, 150000000));
  EXPECT_EQ(stamp_of(3 * 0.05), ros::Time(0, 150000000));  // 0.15000000000000002
  EXPECT_EQ(stamp_of(1.9999999999), ros::Time(2, 0));
  EXPECT_EQ(stamp_of(nan), ros::Time(0, 0));
  EXPECT_EQ(stamp_of(-1.0), ros::Time(0, 0));
  EXPECT_EQ(seconds_of(ros::Time(12, 345678901)), 12.345678901);
}

TEST(Messages, OdometryIsEastNorthUpAndForwardLeftUp) {
  const Motion north{2.5, {10, 3, 5}, {1, 0, 0, 0}, {0.5, 0.1, 0.2}, {0.01, 0.02, 0.03}};
  const nav_msgs::Odometry odometry = odometry_of(north, Frame::enu, "world", "auv");
  EXPECT_EQ(odometry.header.stamp, ros::Time(2, 500000000));
  EXPECT_EQ(odometry.header.frame_id, "world");
  EXPECT_EQ(odometry.child_frame_id, "auv");
  EXPECT_EQ(triple_in(odometry.pose.pose.position), (Triple{3, 10, -5}));
  EXPECT_NEAR(odometry.pose.pose.orientation.w, half_sqrt2, 1e-15);  // yaw of 90 degrees
  EXPECT_NEAR(odometry.pose.pose.orientation.z, half_sqrt2, 1e-15);
  EXPECT_EQ(triple_in(odometry.twist.twist.linear), (Triple{0.5, -0.1, -0.2}));
  EXPECT_EQ(triple_in(odometry.twist.twist.angular), (Triple{0.01, -0.02, -0.03}));
}

TEST(Messages, WhatIsNotANumberStaysSo) {
  nav_msgs::Odometry odometry;
  odometry.pose.pose.position.x = nan;
  EXPECT_TRUE(std::isnan(motion_of(odometry, Frame::enu).position_n[1]));
}

TEST(Messages, ATurnToStarboardAndADiveAreNegativeInForwardLeftUp) {
  const BodyVelocity request{0.5, 0.1, 0.2, 0.3};
  const geometry_msgs::TwistStamped twist = twist_of(request, 1.0, Frame::enu, "auv");
  EXPECT_EQ(triple_in(twist.twist.linear), (Triple{0.5, -0.1, -0.2}));
  EXPECT_EQ(twist.twist.angular.z, -0.3);
  for (const Frame frame : {Frame::enu, Frame::ned}) {
    const BodyVelocity back = body_velocity_of(twist_of(request, 1.0, frame, "auv"), frame);
    EXPECT_EQ(back.surge_mps, 0.5);
    EXPECT_EQ(back.sway_mps, 0.1);
    EXPECT_EQ(back.heave_mps, 0.2);
    EXPECT_EQ(back.yaw_rate_radps, 0.3);
  }
}

TEST(Markers, ClearWhatWasAndShowWhatIs) {
  const Mark ball{Mark::Kind::sphere, "safety", {{1, 2, 3}}, 1.5};
  const Mark name{Mark::Kind::words, "names", {{0, 0, 0}}, 0.0, {}, 2.0, "auv"};
  const Mark line{Mark::Kind::line, "trails", {{0, 0, 0}, {1, 0, 0}}, 0.0, {}, 0.1};
  const auto markers = markers_of({ball, name, line}, 2.0, Frame::enu, "world").markers;
  ASSERT_EQ(markers.size(), 4U);
  EXPECT_EQ(markers[0].action, visualization_msgs::Marker::DELETEALL);
  EXPECT_EQ(markers[1].type, visualization_msgs::Marker::SPHERE);
  EXPECT_EQ(markers[1].ns, "safety");
  EXPECT_EQ(triple_in(markers[1].scale), (Triple{3, 3, 3})) << "diameters";
  EXPECT_EQ(triple_in(markers[1].pose.position), (Triple{2, 1, -3}));
  EXPECT_EQ(markers[2].type, visualization_msgs::Marker::TEXT_VIEW_FACING);
  EXPECT_EQ(markers[2].text, "auv");
  EXPECT_EQ(markers[2].scale.z, 2.0);
  EXPECT_EQ(markers[3].type, visualization_msgs::Marker::LINE_STRIP);
  EXPECT_EQ(triple_in(markers[3].points[1]), (Triple{0, 1, 0})) << "north";
}

TEST(Parameters, AreSettingsAsTheyWereWritten) {
  XmlRpc::XmlRpcValue parameters;
  parameters["frame"] = "ned";
  parameters["seed"] = 7;
  parameters["advisory"] = true;
  parameters["params"]["time_horizon_s"] = 5.1;
  EXPECT_EQ(settings_of(parameters),
            (bridge::Settings{
                {"advisory", "true"}, {"frame", "ned"}, {"params.time_horizon_s", "5.1"}, {"seed", "7"}}));
  EXPECT_TRUE(settings_of(XmlRpc::XmlRpcValue{}).empty());
}

TEST(Parameters, TakeATeamAsAListAsWordsOrAsAFolder) {
  XmlRpc::XmlRpcValue list, words, folder;
  list["team"][0] = "auv_2";
  list["team"][1] = "auv_3";
  words["team"] = "auv_2 auv_3";
  folder["team"]["auv_2"]["radius_m"] = 3.5;
  folder["team"]["auv_3"]["priority"] = 2;
  const bridge::Settings both{{"team", "auv_2 auv_3"}};
  EXPECT_EQ(settings_of(list), both);
  EXPECT_EQ(settings_of(words), both);
  EXPECT_EQ(settings_of(folder),
            (bridge::Settings{
                {"team", "auv_2 auv_3"}, {"team.auv_2.radius_m", "3.5"}, {"team.auv_3.priority", "2"}}));
}

TEST(Parameters, TakeOverridesAsAListOrBetweenSemicolons) {
  XmlRpc::XmlRpcValue text, list, wrong;
  text["overrides"] = "a=1;b=x=2";
  list["overrides"][0] = "a=1";
  list["overrides"][1] = "b=x=2";
  const bridge::Settings both{{"override.a", "1"}, {"override.b", "x=2"}};
  EXPECT_EQ(settings_of(text), both);
  EXPECT_EQ(settings_of(list), both);
  wrong["overrides"] = "duration_s";
  EXPECT_THROW(settings_of(wrong), std::runtime_error);
}

}  // namespace
}  // namespace fairway::ros1
