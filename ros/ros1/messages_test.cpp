// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ros/ros1/conversions.hpp"
#include "ros/ros1/hull_mesh.hpp"
#include "ros/ros1/markers.hpp"
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
  EXPECT_EQ(triple_of(odometry.pose.pose.position), (Triple{3, 10, -5}));
  EXPECT_NEAR(odometry.pose.pose.orientation.w, half_sqrt2, 1e-15);  // yaw of 90 degrees
  EXPECT_NEAR(odometry.pose.pose.orientation.z, half_sqrt2, 1e-15);
  EXPECT_EQ(triple_of(odometry.twist.twist.linear), (Triple{0.5, -0.1, -0.2}));
  EXPECT_EQ(triple_of(odometry.twist.twist.angular), (Triple{0.01, -0.02, -0.03}));
}

TEST(Messages, AMotionComesBackFromItsOdometry) {
  const Motion motion{2.5, {10.1, 3.2, 5.3}, {0.5, 0.5, -0.5, 0.5}, {0.5, 0.1, 0.2}, {0.01, 0.02, 0.03}};
  for (const Frame frame : {Frame::enu, Frame::ned}) {
    const Motion back = motion_of(odometry_of(motion, frame, "world", "auv"), frame);
    EXPECT_EQ(back.time, motion.time);
    EXPECT_EQ(back.position_n, motion.position_n);
    EXPECT_EQ(back.v_b, motion.v_b);
    EXPECT_EQ(back.omega_b, motion.omega_b);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(back.q_nb[i], motion.q_nb[i], 1e-15);
  }
}

TEST(Messages, WhatIsNotANumberStaysSo) {
  nav_msgs::Odometry odometry;
  odometry.pose.pose.position.x = nan;
  EXPECT_TRUE(std::isnan(motion_of(odometry, Frame::enu).position_n[1]));
}

TEST(Messages, ATurnToStarboardAndADiveAreNegativeInForwardLeftUp) {
  const BodyVelocity request{0.5, 0.1, 0.2, 0.3};
  const geometry_msgs::TwistStamped twist = twist_of(request, 1.0, Frame::enu, "auv");
  EXPECT_EQ(triple_of(twist.twist.linear), (Triple{0.5, -0.1, -0.2}));
  EXPECT_EQ(twist.twist.angular.z, -0.3);
  for (const Frame frame : {Frame::enu, Frame::ned}) {
    const BodyVelocity back = body_velocity_of(twist_of(request, 1.0, frame, "auv"), frame);
    EXPECT_EQ(back.surge_mps, 0.5);
    EXPECT_EQ(back.sway_mps, 0.1);
    EXPECT_EQ(back.heave_mps, 0.2);
    EXPECT_EQ(back.yaw_rate_radps, 0.3);
  }
}

TEST(Markers, WhatIsNoLongerThereIsDeleted) {
  MarkerSet markers{Frame::enu, "world"};
  markers.begin(1.0);
  markers.add_sphere("a", {}, {}, 1.0);
  markers.add_sphere("a", {}, {}, 1.0);
  markers.add_sphere("b", {}, {}, 1.0);
  EXPECT_EQ(markers.finish().markers.size(), 3U);

  markers.begin(2.0);
  markers.add_sphere("a", {}, {}, 1.0);
  const visualization_msgs::MarkerArray shown = markers.finish();
  ASSERT_EQ(shown.markers.size(), 3U);
  EXPECT_EQ(shown.markers[0].action, visualization_msgs::Marker::ADD);
  EXPECT_EQ(shown.markers[0].id, 0);
  for (const std::size_t gone : {1U, 2U})
    EXPECT_EQ(shown.markers[gone].action, visualization_msgs::Marker::DELETE);

  markers.begin(3.0);
  EXPECT_EQ(markers.finish().markers.size(), 1U);  // each is deleted once
}

TEST(Markers, ALineOfOnePointIsNotDrawn) {
  MarkerSet markers{Frame::enu, "world"};
  markers.begin(1.0);
  markers.add_mark(bridge::Mark{bridge::Mark::Kind::line, "path", {{1, 2, 3}}});
  markers.add_mark(bridge::Mark{bridge::Mark::Kind::sphere, "nothing", {}});
  EXPECT_TRUE(markers.finish().markers.empty());
}

/// Enclosed volume, positive if the triangles are counter-clockwise from outside.
double volume_of(const std::vector<Triple>& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < mesh.size(); i += 3) {
    const auto& [a, b, c] = std::array{mesh[i], mesh[i + 1], mesh[i + 2]};
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6.0;
}

TEST(Hulls, AreClosedOfTheirSizeAndSeenFromOutside) {
  for (const char* shape : {"auv", "torpedo", "rov", "catamaran", "transport", "point"}) {
    const std::vector<Triple> mesh = hull_mesh(shape, 2.0, 0.5);
    ASSERT_GT(mesh.size(), 0U) << shape;
    EXPECT_EQ(mesh.size() % 3, 0U) << shape;
    EXPECT_GT(volume_of(mesh), 0.0) << shape;
    double bow = 0.0, stern = 0.0;
    for (const Triple& point : mesh) {
      bow = std::fmax(bow, point[0]);
      stern = std::fmin(stern, point[0]);
    }
    EXPECT_NEAR(bow - stern, 2.0, 1e-9) << shape;
  }
  // a box is what it says
  EXPECT_NEAR(volume_of(hull_mesh("transport", 2.0, 0.5)), 2.0 * 0.5 * 0.5, 1e-12);
}

TEST(Parameters, AreTakenAsRoslaunchMayHoldThem) {
  EXPECT_EQ(number_in("speed", XmlRpc::XmlRpcValue{4}, 0, 10), 4.0);
  EXPECT_EQ(number_in("speed", XmlRpc::XmlRpcValue{"0.5"}, 0, 10), 0.5);
  EXPECT_EQ(count_in("seed", XmlRpc::XmlRpcValue{"12345678901"}), 12345678901U);
  EXPECT_TRUE(truth_in("paused", XmlRpc::XmlRpcValue{"true"}));
  EXPECT_EQ(list_in("overrides", XmlRpc::XmlRpcValue{"a=1;b=2"}), (std::vector<std::string>{"a=1", "b=2"}));
}

TEST(Parameters, ARefusalNamesTheParameterAndWhatIsExpected) {
  const auto refusal = [](auto&& read) -> std::string {
    try {
      read();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal([] { number_in("speed", XmlRpc::XmlRpcValue{"fast"}, 0, 10); }),
            "~speed: 'fast': expected a number from 0 to 10");
  EXPECT_EQ(refusal([] { number_in("speed", XmlRpc::XmlRpcValue{nan}, 0, 10); }),
            "~speed: nan: expected a number from 0 to 10");
  EXPECT_EQ(refusal([] { count_in("seed", XmlRpc::XmlRpcValue{1.5}); }),
            "~seed: 1.5: expected a whole number");
  EXPECT_EQ(refusal([] { truth_in("paused", XmlRpc::XmlRpcValue{1}); }),
            "~paused: 1: expected true or false");
}

}  // namespace
}  // namespace fairway::ros1
