// SPDX-License-Identifier: Apache-2.0
#include "fairway/world/sea/current.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fairway/core/angles.hpp"

namespace fairway {
namespace {

TEST(ShearedCurrent, IsLinearBetweenItsPointsAndConstantBeyond) {
  const ShearedCurrent current{{.direction_rad = pi / 2, .profile = {{2.0, 1.0}, {10.0, 0.2}, {12.0, -0.2}}}};
  EXPECT_EQ(current.at(0.0).speed, 1.0);
  EXPECT_EQ(current.at(0.0).gradient, 0.0);
  EXPECT_NEAR(current.at(6.0).speed, 0.6, 1e-15);
  EXPECT_NEAR(current.at(6.0).gradient, -0.1, 1e-15);
  EXPECT_NEAR(current.at(11.0).speed, 0.0, 1e-15);
  EXPECT_EQ(current.at(12.0).speed, -0.2);
  EXPECT_EQ(current.at(99.0).gradient, 0.0);
  EXPECT_NEAR(current.direction().y(), 1.0, 1e-15);
}

struct Statistics {
  double mean{}, deviation{}, correlation{};  // the last one at a lag of 20 s
};

/// The statistics of 200 processes of mean 0.5, deviation 0.2 and a correlation time of 40 s, after 4000 s in
/// steps of `h`.
Statistics statistics_at(double h) {
  constexpr int processes = 200;
  const auto steps = static_cast<int>(std::lround(20.0 / h));
  double sum = 0.0, squares = 0.0, products = 0.0, samples = 0.0;
  for (int p = 0; p < processes; ++p) {
    GaussMarkov process{0.5, 0.2, 40.0, Rng{1}.stream("process", static_cast<std::uint64_t>(p))};
    double before = process.value();
    for (int block = 0; block < 200; ++block) {
      for (int i = 0; i < steps; ++i) process.advance(h);
      const double now = process.value();
      sum += now;
      squares += (now - 0.5) * (now - 0.5);
      products += (now - 0.5) * (before - 0.5);
      samples += 1.0;
      before = now;
    }
  }
  return {sum / samples, std::sqrt(squares / samples), products / squares};
}

TEST(GaussMarkov, ItsStatisticsDoNotDependOnTheStep) {
  // 40000 samples 20 s apart are worth 40000 (1 - a^2) / (1 + a^2) = 18000 independent ones with a = e^-0.5:
  // the standard errors are 0.0028 for the mean (worth 9800), 0.0011 for the deviation and 0.004 for the
  // correlation
  for (const double h : {0.5, 5.0, 20.0}) {
    const Statistics s = statistics_at(h);
    EXPECT_NEAR(s.mean, 0.5, 3 * 0.0028) << h;
    EXPECT_NEAR(s.deviation, 0.2, 3 * 0.0011) << h;
    EXPECT_NEAR(s.correlation, std::exp(-20.0 / 40.0), 3 * 0.004) << h;
  }
}

TEST(GaussMarkov, BeginsAnywhereOnTheProcess) {
  double squares = 0.0;
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const double offset = GaussMarkov{1.0, 0.2, 40.0, Rng{i}}.value() - 1.0;
    squares += offset * offset;
  }
  EXPECT_NEAR(std::sqrt(squares / 1e4), 0.2, 3 * 0.2 / std::sqrt(2e4));
}

TEST(GaussMarkov, WithoutDeviationItKeepsItsMean) {
  GaussMarkov process{0.3, 0.0, 10.0, Rng{1}};
  for (int i = 0; i < 100; ++i) process.advance(0.1);
  EXPECT_EQ(process.value(), 0.3);
}

TEST(GaussMarkovCurrent, StaysWithinItsSpeedsAndComesBackFromThem) {
  GaussMarkovCurrent current{
      {.mean_speed_mps = 0.3, .deviation_mps = 0.2, .min_speed_mps = 0.2, .max_speed_mps = 0.4}, Rng{1}};
  int lowest = 0, highest = 0;
  for (int i = 0; i < 20'000; ++i) {
    current.advance(10.0);
    const double speed = current.velocity().norm();
    ASSERT_GE(speed, 0.2 - 1e-12);
    ASSERT_LE(speed, 0.4 + 1e-12);
    if (speed < 0.2 + 1e-9) ++lowest;
    if (speed > 0.4 - 1e-9) ++highest;
  }
  // half a deviation to either side: 30.9 %, 38.3 %, 30.9 %, whatever the step
  EXPECT_NEAR(lowest / 2e4, 0.309, 0.03);
  EXPECT_NEAR(highest / 2e4, 0.309, 0.03);
}

TEST(GaussMarkovCurrent, ItsDirectionWandersWithoutItsSpeed) {
  GaussMarkovCurrent current{{.mean_speed_mps = 0.3,
                              .deviation_mps = 0.0,
                              .direction_rad = 1.0,
                              .direction_deviation_rad = 0.1,
                              .direction_correlation_time_s = 50.0},
                             Rng{2}};
  double squares = 0.0;
  for (int i = 0; i < 5000; ++i) {
    current.advance(25.0);
    EXPECT_NEAR(current.velocity().norm(), 0.3, 1e-12);
    const double off = std::atan2(current.velocity().y(), current.velocity().x()) - 1.0;
    squares += off * off / 5000.0;
  }
  EXPECT_NEAR(std::sqrt(squares), 0.1, 0.005);
}

}  // namespace
}  // namespace fairway
