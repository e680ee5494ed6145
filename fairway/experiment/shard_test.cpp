// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/shard.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::Ge;
using ::testing::HasSubstr;
using ::testing::Le;

std::vector<double> loads_of(const std::vector<std::uint32_t>& shards, const std::vector<double>& costs,
                             std::size_t runs_per_cell, std::uint32_t count) {
  std::vector<double> loads(count, 0.0);
  for (std::size_t run = 0; run < shards.size(); ++run) loads[shards[run]] += costs[run / runs_per_cell];
  return loads;
}

TEST(Shard, IsReadAsItIsWritten) {
  const Shard shard = parse_shard("3/64");
  EXPECT_EQ(shard.index, 3U);
  EXPECT_EQ(shard.count, 64U);
  EXPECT_EQ(text_of(shard), "3/64");
  EXPECT_TRUE(parse_shard("0/1").is_all());
}

TEST(Shard, ThatIsNoneIsRefused) {
  for (const char* text : {"", "3", "/", "3/", "/4", "-1/4", "1/0", "1.5/4", "1/4/8", "1/ 4", "0x1/4",
                           "1/100001", "99999999999/4"}) {
    EXPECT_THAT(refusal_by([&] { parse_shard(text); }), HasSubstr("expected I/N, as 3/64")) << text;
  }
  EXPECT_THAT(refusal_by([] { parse_shard("5/4"); }), HasSubstr("they count from 0 to 3"));
  EXPECT_THAT(refusal_by([] { parse_shard("4/4"); }), HasSubstr("they count from 0 to 3"));
}

TEST(Shards, HaveAsManyRunsOfEachCellAsOthers) {
  const std::vector<double> costs{100.0, 1.0, 3.0};
  constexpr std::size_t runs_per_cell = 47;
  constexpr std::uint32_t count = 8;
  const std::vector<std::uint32_t> shards = dealt(costs, runs_per_cell, count);
  ASSERT_EQ(shards.size(), costs.size() * runs_per_cell);
  for (std::size_t cell = 0; cell < costs.size(); ++cell) {
    std::vector<std::size_t> runs(count, 0);
    for (std::size_t s = 0; s < runs_per_cell; ++s) ++runs.at(shards[cell * runs_per_cell + s]);
    EXPECT_THAT(runs, Each(AllOf(Ge(5U), Le(6U))));  // 47 / 8
  }
}

// Graham's bound of longest-first: no shard is above the mean by more than the dearest run.
TEST(Shards, CostAlikeWhereEachCellIsRunOnce) {
  std::vector<double> costs;
  for (int i = 0; i < 200; ++i) costs.push_back(i % 4 == 0 ? 100.0 : 1.0 + i % 7);
  for (const std::uint32_t count : {2U, 4U, 16U}) {
    const std::vector<double> loads = loads_of(dealt(costs, 1, count), costs, 1, count);
    const double mean = std::accumulate(costs.begin(), costs.end(), 0.0) / count;
    EXPECT_LE(*std::ranges::max_element(loads), mean + 100.0) << count;
    EXPECT_GE(*std::ranges::min_element(loads), mean - 100.0) << count;
  }
}

TEST(Shards, MayBeMoreThanThereAreRuns) {
  const std::vector<double> costs{5.0, 2.0};
  const std::vector<std::uint32_t> shards = dealt(costs, 2, 1000);
  EXPECT_THAT(shards, ::testing::UnorderedElementsAre(0, 1, 2, 3));
}

TEST(Shards, OfWhichThereIsOneHaveAll) {
  const std::vector<double> costs{5.0, 2.0};
  EXPECT_THAT(dealt(costs, 3, 1), Each(0U));
}

TEST(ExpectedCost, GrowsWithVehiclesStepsAndTheMethod) {
  Scenario scenario;
  scenario.vehicles.resize(2);
  scenario.vehicles[0].avoider.edit().name = scenario.vehicles[1].avoider.edit().name = "orca3d";
  const double orca = expected_cost(scenario);
  scenario.duration_s *= 2;
  EXPECT_DOUBLE_EQ(expected_cost(scenario), 2 * orca);
  scenario.duration_s /= 2;
  for (VehicleSpec& vehicle : scenario.vehicles) vehicle.avoider.edit().name = "avoa+stop_and_wait";
  EXPECT_GT(expected_cost(scenario), 50 * orca);
  scenario.vehicles.pop_back();
  EXPECT_GT(expected_cost(scenario), 25 * orca);
}

}  // namespace
}  // namespace fairway
