// SPDX-License-Identifier: Apache-2.0
// Distances by the way of sound, between vehicles at known places.
#include "fairway/comms/ranging.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fairway/comms/testing/acoustic_sea.hpp"
#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

using namespace acoustic_sea;

/// Two or more that speak once in their slots, in packets that have room for answers.
AcousticParams measuring(RangingKind kind, double deviation = 0.0) {
  return {.update_rate_hz = 1, .ranging = kind, .range_deviation_m = deviation, .modem_max_bytes_count = 100};
}

AcousticRange range(const Sea& sea, std::size_t by, std::size_t to) {
  const std::optional<AcousticRange> measured = sea.channel.ranges_by(by)[to];
  EXPECT_TRUE(measured);
  return measured.value_or(AcousticRange{});
}

TEST(Ranging, WithRightClocksOneWordTellsTheDistance) {
  Sea sea{measuring(RangingKind::one_way), {{0, 0, 0}, {0, 30, 40}, {7, 0, 0}}};
  sea.run(5);
  for (std::size_t by = 0; by < 3; ++by) {
    for (std::size_t to = 0; to < 3; ++to) {
      if (by == to) continue;
      EXPECT_NEAR(range(sea, by, to).distance, (sea.places[to] - sea.places[by]).norm(), 1e-9);
      EXPECT_EQ(number(range(sea, by, to).to), to);
      EXPECT_EQ(range(sea, by, to).out, range(sea, by, to).back);
    }
    EXPECT_FALSE(sea.channel.ranges_by(by)[by]);
  }
}

TEST(Ranging, OneWayHasTheClocksInIt) {
  AcousticParams params = measuring(RangingKind::one_way);
  params.clock_offset_s = 0.1;
  Sea sea{params, pair(40)};
  sea.run(5);
  const double one = range(sea, 0, 1).distance, other = range(sea, 1, 0).distance;
  const double ahead = sea.channel.clock_ahead(0, sea.now) - sea.channel.clock_ahead(1, sea.now);
  EXPECT_GT(std::abs(ahead), 0.01);
  EXPECT_NEAR(one, 40 + 1500 * ahead, 1e-6);
  EXPECT_NEAR(one + other, 80, 1e-6) << "what one clock adds the other takes away";
}

TEST(Ranging, ThereAndBackClocksNeedNotGoAlike) {
  AcousticParams params = measuring(RangingKind::two_way);
  params.clock_offset_s = 10.0;
  params.clock_drift_ratio = 1e-5;
  Sea sea{params, pair(40)};
  sea.run(100);
  // while the other waits to answer, at most 1 s, two clocks part by some 1e-5 of that
  EXPECT_NEAR(range(sea, 0, 1).distance, 40, 0.05);
  EXPECT_NEAR(range(sea, 1, 0).distance, 40, 0.05);
  EXPECT_NE(range(sea, 0, 1).distance, 40);
}

TEST(Ranging, ThereAndBackIsTheMeanOfTwoWays) {
  Sea sea{measuring(RangingKind::two_way), pair(20)};
  std::vector<double> distance_at;  // by tick
  for (int i = 0; i < 200; ++i) {
    sea.places[1].y() += 0.05;  // 1 m/s
    distance_at.push_back((sea.places[1] - sea.places[0]).norm());
    sea.tick();
  }
  for (const std::size_t by : {0U, 1U}) {
    const AcousticRange measured = range(sea, by, 1 - by);
    EXPECT_GT(measured.back - measured.out, 0.3);
    EXPECT_LT(measured.back - measured.out, 2 * sea.channel.turn_period());
    const auto at = [&](double time) { return distance_at[static_cast<std::size_t>(time / tick_s + 1e-6)]; };
    EXPECT_NEAR(measured.distance, 0.5 * (at(measured.out) + at(measured.back)), 0.05);
  }
}

TEST(Ranging, ErrorsHaveTheDeviationAskedFor) {
  Sea sea{measuring(RangingKind::one_way, 0.5), pair(30)};
  sea.said[1].told = false;
  double sum = 0.0, squares = 0.0;
  constexpr int words = 4000;
  for (int i = 0; i < words; ++i) {
    sea.run(1.2);
    const double error = range(sea, 1, 0).distance - 30;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(sum / words, 0.0, 0.03);
  EXPECT_NEAR(std::sqrt(squares / words), 0.5, 0.02);
}

TEST(Ranging, WhatIsLostIsNotMeasuredAndNothingElseChanges) {
  AcousticParams plain{.update_rate_hz = 1, .loss_ratio = 0.5};
  AcousticParams with = plain;
  with.ranging = RangingKind::one_way;
  Sea silent{plain, pair(30)}, measuring_too{with, pair(30)};
  for (int i = 0; i < 2000; ++i) {
    silent.tick();
    measuring_too.tick();
    ASSERT_EQ(silent.heard(0, 1).sent, measuring_too.heard(0, 1).sent);
    ASSERT_EQ(silent.heard(0, 1).told, measuring_too.channel.ranges_by(0)[1].has_value());
  }
  EXPECT_TRUE(silent.channel.ranges_by(0).empty());
  EXPECT_EQ(silent.counts().lost, measuring_too.counts().lost);
}

TEST(Ranging, AnswersTakeRoomAndTime) {
  const AcousticParams params = measuring(RangingKind::two_way);
  const Sea two{params, pair(10)}, five{params, row(5)};
  EXPECT_NEAR(five.channel.transmission_time() - two.channel.transmission_time(), 3 * 3 * 8 / 1600.0, 1e-12);

  AcousticParams tight = params;
  tight.modem_max_bytes_count = 64;
  EXPECT_EQ(
      refusal_by([&] { const Sea none(tight, row(5)); }),
      "modem_max_bytes_count: 25 bytes and 39 of overhead and 12 of answers are more than the 64 that the "
      "modem takes");
  AcousticParams relayed = params;
  relayed.relay = true;
  EXPECT_EQ(refusal_by([&] { const Sea none(relayed, row(2)); }),
            "ranging: what comes by a relay tells no distance; relay: false goes with it");
}

}  // namespace
}  // namespace fairway
