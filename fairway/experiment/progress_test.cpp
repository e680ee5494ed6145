// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/progress.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <thread>

namespace fairway {
namespace {

using testing::HasSubstr;

/// What can be read from `descriptor` now.
std::string read_all(int descriptor) {
  ::fcntl(descriptor, F_SETFL, O_NONBLOCK);
  std::string text;
  char piece[4096];
  for (auto size = ::read(descriptor, piece, sizeof piece); size > 0;
       size = ::read(descriptor, piece, sizeof piece)) {
    text.append(piece, static_cast<std::size_t>(size));
  }
  return text;
}

TEST(ProgressTest, SaysHowManyHowFastAndHowLong) {
  EXPECT_EQ(progress_text("crit_dist", {.total = 480, .present = 100, .made = 20, .failed = 3}, 1.6),
            "crit_dist: 120 of 480 runs, 3 failed, 12.5 runs/s, 0:29 left");
  EXPECT_EQ(progress_text("long", {.total = 1000, .made = 10}, 600.0),
            "long: 10 of 1000 runs, 0.0167 runs/s, 16:30:00 left");
  EXPECT_EQ(progress_text("done", {.total = 5, .present = 5}, 0.0), "done: 5 of 5 runs");
}

TEST(ProgressTest, IsSilentInAPipe) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  Progress progress{"quiet", ends[1]};
  progress.begin({.total = 2});
  progress.update({.total = 2, .made = 1});
  progress.end({.total = 2, .made = 2});
  EXPECT_EQ(read_all(ends[0]), "");
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(ProgressTest, RedrawsOneLineOfATerminalAtMostFiveTimesASecond) {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (master < 0 || ::grantpt(master) != 0 || ::unlockpt(master) != 0)
    GTEST_SKIP() << "no pseudo terminal here";
  const int terminal = ::open(::ptsname(master), O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);

  Progress progress{"seen", terminal};
  const auto began = std::chrono::steady_clock::now();
  ProgressCount count{.total = 1000};
  progress.begin(count);
  for (int i = 0; i < 100; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
    count.made += 10;
    progress.update(count);
  }
  progress.end(count);
  const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();

  const std::string shown = read_all(master);
  EXPECT_THAT(shown, HasSubstr("seen: 1000 of 1000 runs"));
  // each drawing goes back to the line's beginning; the last line break adds a return of its own
  const auto drawn = std::count(shown.begin(), shown.end(), '\r') - 1;
  EXPECT_LE(drawn, 2 + static_cast<long>(5.0 * elapsed_s));
  EXPECT_GE(drawn, 3);
  ::close(terminal);
  ::close(master);
}

}  // namespace
}  // namespace fairway
