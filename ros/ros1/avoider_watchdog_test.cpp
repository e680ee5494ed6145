// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/avoider_watchdog.hpp"

#include <gtest/gtest.h>

namespace fairway::ros1 {
namespace {

using namespace std::chrono_literals;

TEST(AvoiderWatchdog, is_silent_while_the_loop_comes_round) {
  AvoiderWatchdog watchdog{1.0, [](double) {}};
  for (int i = 0; i < 150; ++i) {
    watchdog.come_round();
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_EQ(watchdog.alarms(), 0);
}

TEST(AvoiderWatchdog, raises_the_alarm_once_a_period_while_the_loop_stands_still) {
  std::atomic<double> stood{0.0};
  AvoiderWatchdog watchdog{0.1, [&](double seconds) { stood = seconds; }};
  watchdog.come_round();
  std::this_thread::sleep_for(1050ms);
  EXPECT_GE(watchdog.alarms(), 3) << "a loaded machine may be late";
  EXPECT_LE(watchdog.alarms(), 10);
  EXPECT_GE(stood, 0.1);
  watchdog.come_round();
  std::this_thread::sleep_for(30ms);
  const auto before = watchdog.alarms();
  watchdog.come_round();
  std::this_thread::sleep_for(30ms);
  EXPECT_LE(watchdog.alarms(), before + 1);
}

TEST(AvoiderWatchdog, ends_at_once_when_it_is_not_needed_any_more) {
  const auto begin = std::chrono::steady_clock::now();
  {
    const AvoiderWatchdog watchdog{60.0, [](double) {}};
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
}

}  // namespace
}  // namespace fairway::ros1
