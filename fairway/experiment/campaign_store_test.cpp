// SPDX-License-Identifier: Apache-2.0
// What a store knows of the campaigns that its runs are of.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/experiment/campaign.hpp"
#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/testing/sample_runs.hpp"

namespace fairway {
namespace {

using testing::HasSubstr;

constexpr std::string_view two_yaml = R"(fairway: 1
name: pair
defaults: {model: kinematic, avoider: orca3d}
vehicles:
  - start: {position_m: [0, {uniform: [-1, 1]}, 5]}
    mission: [{transit: {position_m: [20, 0, 5]}}]
)";

class CampaignStoreTest : public testing::Test {
 protected:
  CampaignStoreTest() { sample::write_bytes(folder_.file("pair.yaml"), two_yaml); }

  Campaign parse(const std::string& more) const {
    return parse_campaign("fairway_campaign: 1\nname: test\nscenario: pair.yaml\n" + more,
                          folder_.file("test.yaml"));
  }

  TemporaryFolder folder_;
};

std::vector<Measure> east_of(const Scenario& scenario) {
  return {{"east_m", 0, scenario.vehicles[0].position.y()}};
}

TEST_F(CampaignStoreTest, VersionsOfACellAreTheSameUnderEverySeedAndOfEveryOtherScenarioAnother) {
  const auto version = [&](const std::string& more) { return parse(more).specs.back().version; };
  const std::string some = version("algorithms: [apf, orca3d]\nseeds: {count: 3}\n");
  EXPECT_EQ(some.size(), 32U);
  EXPECT_EQ(version("algorithms: [orca3d]\nseeds: {first: 100, count: 9}\nsummary: more\n"), some);
  EXPECT_NE(version("algorithms: [apf]\n"), some);
  EXPECT_NE(version("algorithms: [orca3d]\nset: {step_s: 0.02}\n"), some);
  sample::write_bytes(folder_.file("pair.yaml"), "# a remark\n" + std::string(two_yaml));
  EXPECT_EQ(version("algorithms: [orca3d]\n"), some);
  sample::write_bytes(folder_.file("pair.yaml"), "step_s: 0.051\n" + std::string(two_yaml));
  EXPECT_NE(version("algorithms: [orca3d]\n"), some);
}

TEST_F(CampaignStoreTest, TellsItsRunsFromThoseOfOthersInOneStore) {
  Store store = Store::in_memory();
  run_campaign(parse("algorithms: [apf]\nseeds: {count: 3}\n"), east_of, store);
  run_campaign(parse("algorithms: [apf, orca3d]\nseeds: {first: 3, count: 2}\n"), east_of, store);
  EXPECT_EQ(store.size(), 6U);
  EXPECT_EQ(store.campaign_size(), 4U);

  // two versions of the scenario, under other seeds
  sample::write_bytes(folder_.file("pair.yaml"), "step_s: 0.051\n" + std::string(two_yaml));
  run_campaign(parse("algorithms: [apf]\nseeds: {first: 10, count: 2}\n"), east_of, store);
  EXPECT_EQ(store.campaign_size(), 2U);
  EXPECT_THAT(refusal_by([&] { compare(store.all()); }), HasSubstr("are of two versions of a scenario"));
}

TEST_F(CampaignStoreTest, FailuresThatWereThereAreCounted) {
  const Campaign campaign = parse("seeds: {count: 3}\n");
  const auto fail = [](const Scenario&) -> std::vector<Measure> { throw std::runtime_error("broke"); };
  Store store = Store::in_memory();
  EXPECT_EQ(run_campaign(campaign, fail, store).failed, 3U);
  const ExecutorReport again = run_campaign(campaign, fail, store);
  EXPECT_EQ(again.made, 0U);
  EXPECT_EQ(again.failed_before, 3U);
  const ExecutorReport mended = run_campaign(campaign, east_of, store, {.retry_failures = true});
  EXPECT_EQ(mended.failed + mended.failed_before, 0U);
}

TEST_F(CampaignStoreTest, WhatIsSetAnewIsToldOnceInTheCommandOfARunAlone) {
  Campaign c = parse("");
  c.cells[0].overrides = {{"step_s", "0.05"}, {"duration_s", "9"}, {"step_s", "0.1"}};
  resolve_runs(c, {}, 1, {});
  EXPECT_THAT(c.specs[0].command, testing::EndsWith("pair.yaml --set duration_s=9 --set step_s=0.1 --seed "));
}

}  // namespace
}  // namespace fairway
