// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/cola2/adapter.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace fairway::ros1::cola2 {
namespace {

// messages of our own that have no more than the fields that the adapter uses
struct Heading {
  ros::Time stamp;
};
struct TestNavigation {
  Heading header;
  struct {
    double north, east, depth;
  } position{};
  struct {
    double roll, pitch, yaw;
  } orientation{}, orientation_rate{};
  struct {
    double x, y, z;
  } body_velocity{};
};
struct TestRequest {
  Heading header;
  struct {
    std::string requester;
    std::uint32_t priority{};
  } goal;
  struct {
    struct {
      double x, y, z;
    } linear{}, angular{};
  } twist;
  struct {
    unsigned char x, y, z, roll, pitch, yaw;
  } disable_axis{};
};

TEST(Cola2Adapter, reads_navigation_as_it_is_north_east_down) {
  TestNavigation navigation;
  navigation.header.stamp = ros::Time{12, 500000000};
  navigation.position = {1.5, -2.5, 7.0};
  navigation.orientation = {0, 0, 1.5707963267948966};
  navigation.orientation_rate = {0.1, 0.2, 0.3};
  navigation.body_velocity = {0.5, 0.25, -0.125};
  const bridge::Motion motion = motion_from(navigation);
  EXPECT_EQ(motion.time, 12.5);
  EXPECT_EQ(motion.position_n, (bridge::Triple{1.5, -2.5, 7.0}));
  EXPECT_EQ(motion.v_b, (bridge::Triple{0.5, 0.25, -0.125}));
  EXPECT_EQ(motion.omega_b, (bridge::Triple{0.1, 0.2, 0.3}));
  EXPECT_NEAR(motion.q_nb[0], std::sqrt(0.5), 1e-15);  // heading east: a quarter turn about down
  EXPECT_NEAR(motion.q_nb[3], std::sqrt(0.5), 1e-15);
}

TEST(Cola2Adapter, composes_an_attitude_of_yaw_then_pitch_then_roll) {
  const double roll = 0.3, pitch = -0.4, yaw = 2.0;
  const auto [w, x, y, z] = attitude_of(roll, pitch, yaw);
  // the first column of the rotation matrix, in closed form: where the bow points, in NED
  EXPECT_NEAR(1 - 2 * (y * y + z * z), std::cos(yaw) * std::cos(pitch), 1e-15);
  EXPECT_NEAR(2 * (x * y + w * z), std::sin(yaw) * std::cos(pitch), 1e-15);
  EXPECT_NEAR(2 * (x * z - w * y), -std::sin(pitch), 1e-15);
  // the last row: where down is, in the body
  EXPECT_NEAR(2 * (y * z + w * x), std::cos(pitch) * std::sin(roll), 1e-15);
  EXPECT_NEAR(1 - 2 * (x * x + y * y), std::cos(pitch) * std::cos(roll), 1e-15);
}

TEST(Cola2Adapter, asks_for_the_steered_axes_only) {
  const auto request = request_of<TestRequest>({0.5, 0.1, -0.2, 0.3}, {true, false, true, true}, "fairway",
                                               42, ros::Time{3, 0});
  EXPECT_EQ(request.goal.requester, "fairway");
  EXPECT_EQ(request.goal.priority, 42U);
  EXPECT_EQ(request.header.stamp, (ros::Time{3, 0}));
  EXPECT_EQ(request.twist.linear.x, 0.5);
  EXPECT_EQ(request.twist.linear.z, -0.2);
  EXPECT_EQ(request.twist.angular.z, 0.3);
  EXPECT_FALSE(request.disable_axis.x || request.disable_axis.z || request.disable_axis.yaw);
  EXPECT_TRUE(request.disable_axis.y && request.disable_axis.roll && request.disable_axis.pitch);
}

TEST(Cola2Adapter, repeats_a_command_until_it_is_too_old) {
  CommandKeeper keeper{0.5};
  EXPECT_FALSE(keeper.at(0.0));
  keeper.hear({0.25, 0, 0, 0}, 10.0);
  ASSERT_TRUE(keeper.at(10.5));
  EXPECT_EQ(keeper.at(10.5)->surge_mps, 0.25);
  EXPECT_FALSE(keeper.at(10.6));
  EXPECT_FALSE(keeper.at(9.0)) << "a clock that has begun again";
  keeper.hear({0, std::numeric_limits<double>::quiet_NaN(), 0, 0}, 11.0);
  EXPECT_FALSE(keeper.at(11.1)) << "one that is no number is none";
}

TEST(Cola2Adapter, knows_the_names_of_the_axes) {
  const auto axes = axes_of("surge yaw");
  ASSERT_TRUE(axes);
  EXPECT_TRUE(axes->surge && axes->yaw);
  EXPECT_FALSE(axes->sway || axes->heave);
  EXPECT_FALSE(axes_of("surge sideways"));
}

}  // namespace
}  // namespace fairway::ros1::cola2
