// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/watchdog.hpp"

#include <gtest/gtest.h>

namespace fairway::bridge {
namespace {

using namespace std::chrono_literals;

TEST(Watchdog, IsSilentWhileTheLoopComesRound) {
  std::atomic<int> alarms{0};
  Watchdog watchdog{1.0, [&](double) { ++alarms; }};
  for (int i = 0; i < 150; ++i) {
    watchdog.come_round();
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_EQ(alarms, 0);
}

TEST(Watchdog, RaisesTheAlarmOnceAPeriodWhileTheLoopStandsStill) {
  std::atomic<double> stood{0.0};
  std::atomic<int> alarms{0};
  Watchdog watchdog{0.1, [&](double seconds) {
                      stood = seconds;
                      ++alarms;
                    }};
  watchdog.come_round();
  std::this_thread::sleep_for(1050ms);
  EXPECT_GE(alarms, 3) << "a loaded machine may be late";
  EXPECT_LE(alarms, 10);
  EXPECT_GE(stood, 0.1);
  watchdog.come_round();
  std::this_thread::sleep_for(30ms);
  const int before = alarms;
  watchdog.come_round();
  std::this_thread::sleep_for(30ms);
  EXPECT_LE(alarms, before + 1);
}

TEST(Watchdog, EndsAtOnceWhenItIsNotNeededAnyMore) {
  const auto begin = std::chrono::steady_clock::now();
  {
    const Watchdog watchdog{60.0, [](double) {}};
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
}

}  // namespace
}  // namespace fairway::bridge
