// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/race.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

constexpr std::size_t blocks = 40;

/// A setting of one number, which is its relative time; below 0.5 it is unsafe in half of the runs.
Outcome outcome(double setting, std::size_t seed) {
  Rng rng = Rng{7}.stream("run", seed);
  const double time = 100.0 * setting * rng.uniform(0.8, 1.2);
  return {.is_safe = setting >= 0.5 || rng.uniform(0.0, 1.0) < 0.5, .arrived = 1.0, .time_s = time};
}

Outcomes outcomes(double setting, std::size_t first, std::size_t count) {
  Outcomes all;
  for (std::size_t seed = first; seed < first + count; ++seed) all.push_back(outcome(setting, seed));
  return all;
}

std::vector<Outcomes> run(const std::vector<Setting>& settings, std::size_t first, std::size_t count) {
  std::vector<Outcomes> all;
  for (const Setting& setting : settings) all.push_back(outcomes(setting[0], first, count));
  return all;
}

std::vector<Contender> contenders(std::initializer_list<double> settings) {
  std::vector<Contender> all;
  for (const double setting : settings) all.push_back({.setting = {setting}});
  return all;
}

const RaceCourse course{.scenarios = 1, .blocks = blocks};
const Outcomes champion = outcomes(1.0, 0, blocks);

TEST(Race, WhoeverIsWorseIsOutEarlyAndTheBestRunsTheWholeCourse) {
  std::size_t budget = 10'000;
  const auto order = race(contenders({1.5, 0.9, 0.2, 0.7, 2.0}), champion, champion, course, run, budget);
  EXPECT_EQ(order.front().setting[0], 0.7);
  EXPECT_EQ(order.front().outcomes.size(), blocks);
  for (const Contender& contender : order) {
    if (contender.setting[0] == 0.7) continue;
    EXPECT_TRUE(contender.is_out) << contender.setting[0];
    EXPECT_LT(contender.outcomes.size(), blocks) << contender.setting[0];
  }
  std::size_t spent = 0;
  for (const Contender& contender : order) spent += contender.outcomes.size();
  EXPECT_EQ(budget, 10'000 - spent);
  EXPECT_LT(spent, 5 * blocks / 2) << "racing saves runs";
}

TEST(Race, AnUnsafeOneIsOutHoweverFastItIs) {
  std::size_t budget = 10'000;
  const auto order = race(contenders({0.1, 0.99}), champion, champion, course, run, budget);
  EXPECT_EQ(order.front().setting[0], 0.99);
  EXPECT_TRUE(order.back().is_out);
}

TEST(Race, EndsWhereTheBudgetDoes) {
  std::size_t budget = 23;
  const auto order = race(contenders({0.9, 0.91, 0.92}), champion, champion, course, run, budget);
  // three run five blocks, the one that is left five more, and the next five would cost more than three
  EXPECT_EQ(budget, 23U - 3 * 5 - 5);
  EXPECT_EQ(order.front().outcomes.size(), 10U);
}

TEST(Score, CountsSafetyThenArrivalsThenTime) {
  const Score good{.runs = 10, .unsafe = 0, .arrived = 1.0, .time_ratio = 1.0};
  Score other = good;
  other.time_ratio = 0.9;
  EXPECT_TRUE(is_better(other, good));
  other.arrived = 0.99;
  EXPECT_FALSE(is_better(other, good));
  other = {.runs = 10, .unsafe = 1, .arrived = 1.0, .time_ratio = 0.5};
  EXPECT_FALSE(is_better(other, good));
  EXPECT_FALSE(is_dominated(other, good)) << "it is faster, though not better";
  EXPECT_TRUE(is_dominated({.runs = 10, .unsafe = 1, .arrived = 1.0, .time_ratio = 1.0}, good));
}

TEST(Score, TakesAFailedRunForAnUnsafeOneWithoutATime) {
  const Outcomes usual = outcomes(1.0, 0, 4);
  Outcomes some = usual;
  some[2] = failed_outcome();
  const Score score = score_of(some, usual);
  EXPECT_EQ(score.unsafe, 1U);
  EXPECT_EQ(score.arrived, 0.75);
  EXPECT_EQ(score.time_ratio, 1.0);
}

TEST(Score, ReadsARunsMeasures) {
  std::vector<Measure> measures{{.quantity = "pair_collision_count", .value = 0},
                                {.quantity = "arrived_ratio", .value = 0.5},
                                {.quantity = "navigation_time_s", .vehicle = 0, .value = 90},
                                {.quantity = "navigation_time_s", .vehicle = 1, .value = 110}};
  EXPECT_TRUE(outcome_of(measures).is_safe);
  EXPECT_EQ(outcome_of(measures).time_s, 100.0);
  EXPECT_EQ(outcome_of(measures).arrived, 0.5);
  measures.push_back({.quantity = "footprint_clearance_m", .vehicle = 1, .value = -0.01});
  EXPECT_FALSE(outcome_of(measures).is_safe) << "it touched an obstacle";
  measures.back().value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(outcome_of(measures).is_safe) << "there are no obstacles";
  measures[0].value = 1;
  EXPECT_FALSE(outcome_of(measures).is_safe);
}

TEST(Score, NoiseAloneBeatsNobodyOften) {
  int beaten = 0;
  for (std::size_t trial = 0; trial < 200; ++trial)
    beaten += is_beaten(outcomes(1.0, 1000 * trial, 20), outcomes(1.0, 1000 * trial + 500, 20), 1) ? 1 : 0;
  EXPECT_LT(beaten, 20);
}

}  // namespace
}  // namespace fairway
