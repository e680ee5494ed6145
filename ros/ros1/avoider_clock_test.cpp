// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/avoider_clock.hpp"

#include <gtest/gtest.h>

namespace fairway::ros1 {
namespace {

TEST(AvoiderClock, takes_navigation_that_is_ahead_of_a_clock_on_its_way) {
  AvoiderClock clock;
  EXPECT_EQ(clock.at(10.0), 10.0);
  EXPECT_EQ(clock.at(10.0, 10.05), 10.05);
  EXPECT_EQ(clock.at(10.0), 10.05) << "it does not go back when the clock is asked again";
  EXPECT_EQ(clock.at(10.1), 10.1);
}

TEST(AvoiderClock, does_not_follow_navigation_from_the_future_or_the_past) {
  AvoiderClock clock;
  EXPECT_EQ(clock.at(10.0, 20.0), 10.0);
  EXPECT_EQ(clock.at(10.0, 3.0), 10.0);
  EXPECT_EQ(clock.at(10.0, std::numeric_limits<double>::quiet_NaN()), 10.0);
}

TEST(AvoiderClock, is_never_more_than_a_tenth_of_a_second_ahead_of_the_clock) {
  AvoiderClock clock;
  double now = clock.at(10.0);
  for (int i = 1; i <= 100; ++i) now = clock.at(10.0, 10.0 + 0.01 * i);
  EXPECT_LE(now, 10.1);
}

TEST(AvoiderClock, begins_again_with_a_simulation_that_does) {
  AvoiderClock clock;
  clock.at(500.0);
  EXPECT_EQ(clock.at(0.05), 0.05);
}

}  // namespace
}  // namespace fairway::ros1
