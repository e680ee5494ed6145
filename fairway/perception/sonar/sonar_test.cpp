// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/sonar/sonar.hpp"

#include <gtest/gtest.h>

#include "fairway/core/testing/allocations.hpp"
#include "fairway/perception/testing/quiet_sonar.hpp"

namespace fairway {
namespace {

TEST(Sonar, EchoesComeFromPortToStarboardInHullCoordinates) {
  VehicleState own;
  own.p_n = {5, 5, 5};
  own.q_nb = quaternion_of({.yaw = pi / 2});
  // heading east: north is to port
  const std::vector<Echo> echoes = echoes_of(quiet_sonar(), own, {ball({15, 25, 5}, 1), ball({5, 35, 5}, 1)});
  ASSERT_GT(echoes.size(), 4U);
  EXPECT_TRUE(std::ranges::is_sorted(echoes, {}, &Echo::bearing));
  EXPECT_NEAR(echoes.front().bearing, std::atan2(-10.0, 20.0), 0.06);
  EXPECT_NEAR(echoes.back().bearing, 0.0, 0.05);
  EXPECT_NEAR(echoes.back().range, 29.5, 0.5);
}

TEST(Sonar, ItDoesNotHearItsOwnVehicle) { EXPECT_TRUE(echoes_of(quiet_sonar(), {}, {}).empty()); }

TEST(Sonar, WhatIsTooNearIsNotHeardAndHidesTheRest) {
  const std::vector<Mover> two{ball({1, 0, 0}, 0.9), ball({20, 0, 0}, 1)};
  EXPECT_TRUE(echoes_of(quiet_sonar(), {}, two).empty());
  EXPECT_FALSE(echoes_of(quiet_sonar(), {}, {two[1]}).empty());
}

TEST(Sonar, AtZeroRangeNothingIsNotANumber) {
  SonarParams params;
  params.min_range_m = 0.0;
  const std::vector<Obstacle> obstacles{
      {.kind = Obstacle::Kind::sphere, .radius = 1.0},
      {.kind = Obstacle::Kind::segment, .from = {0, 0, 0}, .to = {0, 0, 0}},
      {.kind = Obstacle::Kind::segment, .from = {-1, 0, 0}, .to = {1, 0, 0}}};
  for (const double radius : {0.0, 1.0}) {
    const auto echoes = echoes_of(params, {}, {ball({0, 0, 0}, radius)}, obstacles);
    EXPECT_FALSE(echoes.empty());
    for (const Echo& echo : echoes) {
      EXPECT_TRUE(std::isfinite(echo.bearing));
      EXPECT_GE(echo.range, 0.0);
    }
  }
}

/// All the echoes of `pings` of one wall of a ball that fills the fan, 15 m to 20 m away.
std::vector<Echo> many(const SonarParams& params, int pings) {
  std::vector<Echo> all;
  for (int i = 0; i < pings; ++i) {
    const auto echoes = echoes_of(params, {}, {ball({40, 0, 0}, 30)}, {}, Rng{3}.stream("ping", i));
    all.insert(all.end(), echoes.begin(), echoes.end());
  }
  return all;
}

TEST(Sonar, EchoesAreMissedAsOftenAsSaid) {
  SonarParams params = quiet_sonar();
  const double there = static_cast<double>(many(params, 100).size());
  params.missed_ratio = 0.1;
  const double heard = static_cast<double>(many(params, 100).size());
  const double sigma = std::sqrt(there * 0.1 * 0.9);  // binomial
  EXPECT_NEAR(heard, 0.9 * there, 3.0 * sigma);
}

TEST(Sonar, RangeAndBearingHaveTheNoiseThatIsSaid) {
  SonarParams params = quiet_sonar();
  params.beams_count = 1;
  params.echo_range_sigma_m = 0.2;
  params.echo_bearing_sigma_deg = 2.0;
  const std::vector<Echo> echoes = many(params, 4000);
  ASSERT_EQ(echoes.size(), 4000U);
  Vec2 mean = Vec2::Zero();
  Vec2 square = Vec2::Zero();
  for (const Echo& echo : echoes) {
    const Vec2 error{(echo.range - 10.0) / 0.2, echo.bearing / radians(2.0)};
    mean += error / 4000.0;
    square += error.cwiseAbs2() / 4000.0;
  }
  for (const int i : {0, 1}) {
    EXPECT_NEAR(mean[i], 0.0, 3.0 / std::sqrt(4000.0));
    EXPECT_NEAR(square[i], 1.0, 3.0 * std::sqrt(2.0 / 4000.0));
  }
}

TEST(Sonar, FalseEchoesArePoissonAndSpreadOverTheFan) {
  SonarParams params = quiet_sonar();
  params.false_echoes_count = 2.0;
  const int pings = 4000;
  double count = 0.0;
  double count2 = 0.0;
  double range = 0.0;
  double bearing = 0.0;
  for (int i = 0; i < pings; ++i) {
    const auto echoes = echoes_of(params, {}, {}, {}, Rng{4}.stream("ping", i));
    const auto n = static_cast<double>(echoes.size());
    count += n;
    count2 += n * n;
    for (const Echo& echo : echoes) {
      EXPECT_LE(std::abs(echo.bearing), radians(65));
      range += echo.range;
      bearing += echo.bearing;
    }
  }
  const double mean = count / pings;
  EXPECT_NEAR(mean, 2.0, 3.0 * std::sqrt(2.0 / pings));
  // the variance of a sample variance of Poisson is about (2 m^2 + m) / n
  EXPECT_NEAR(count2 / pings - mean * mean, 2.0, 3.0 * std::sqrt(10.0 / pings));
  EXPECT_NEAR(range / count, 50.5, 3.0 * 99.0 / std::sqrt(12.0 * count));
  EXPECT_NEAR(bearing / count, 0.0, 3.0 * radians(130) / std::sqrt(12.0 * count));
}

TEST(Sonar, FalseEchoesDoNotShiftTheNoiseOfTrueOnes) {
  SonarParams params;
  params.false_echoes_count = 0.0;
  const auto without = echoes_of(params, {}, {ball({30, 0, 0}, 3)});
  params.false_echoes_count = 5.0;
  const auto with = echoes_of(params, {}, {ball({30, 0, 0}, 3)});
  ASSERT_FALSE(without.empty());
  EXPECT_GT(with.size(), without.size());
  for (const Echo& echo : without) EXPECT_NE(std::ranges::find(with, echo), with.end());
}

TEST(Sonar, TheSameSeedGivesTheSameBits) {
  const SonarParams params;
  EXPECT_EQ(echoes_of(params, {}, {ball({30, 0, 0}, 3)}), echoes_of(params, {}, {ball({30, 0, 0}, 3)}));
  EXPECT_NE(echoes_of(params, {}, {ball({30, 0, 0}, 3)}),
            echoes_of(params, {}, {ball({30, 0, 0}, 3)}, {}, Rng{2}));
}

TEST(Sonar, APingAllocatesNothing) {
  const std::vector<Mover> movers = movers_round({}, {ball({30, 0, 0}, 3), ball({20, 9, 1}, 2)});
  Sonar sonar{{}};
  std::vector<Echo> echoes;
  echoes.reserve(echo_capacity({}));
  Rng rng{1};
  Rng false_rng{2};
  const long before = allocation_count();
  for (int i = 0; i < 100; ++i) sonar.ping({}, {.movers = movers}, rng, false_rng, echoes);
  EXPECT_EQ(allocation_count() - before, 0);
}

TEST(Sonar, TheFanCoversWhatAPingHears) {
  VehicleState own;
  own.p_n = {1, 2, 3};
  own.q_nb = quaternion_of({.pitch = 0.2, .yaw = 1.0});
  const Fan fan = Sonar{quiet_sonar()}.fan(own);
  EXPECT_TRUE(fan.covers(own.p_n + own.q_nb * Vec3{50, 30, 2}));
  EXPECT_FALSE(fan.covers(own.p_n + own.q_nb * Vec3{101, 0, 0}));
  EXPECT_FALSE(fan.covers(own.p_n + own.q_nb * Vec3{0.5, 0, 0}));
  EXPECT_FALSE(fan.covers(own.p_n + own.q_nb * Vec3{10, 30, 0}));
  EXPECT_FALSE(fan.covers(own.p_n + own.q_nb * Vec3{50, 0, 10}));
}

}  // namespace
}  // namespace fairway
