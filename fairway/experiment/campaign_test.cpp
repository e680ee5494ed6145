// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "fairway/core/error.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/core/text.hpp"
#include "fairway/experiment/campaign_file.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/experiment/testing/sample_runs.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::string_view pair_yaml = R"(fairway: 1
name: pair
defaults:
  model: sparus2
  avoider: {algorithm: orca3d, time_horizon_s: 5}
vehicles:
  - start: {position_m: [0, {uniform: [-1, 1]}, 5]}
    mission: [{transit: {position_m: [20, 0, 5]}}]
  - start: {position_m: [20, 0, 5]}
    mission: [{transit: {position_m: [0, 0, 5]}}]
)";

constexpr std::string_view minimal = "fairway_campaign: 1\nname: test\nscenario: pair.yaml\n";

class CampaignTest : public testing::Test {
 protected:
  CampaignTest() { sample::write_bytes(folder_.file("pair.yaml"), pair_yaml); }

  Campaign parse(const std::string& more, const CheckScenario& check = {}, unsigned jobs = 1) const {
    return parse_campaign(std::string(minimal) + more, folder_.file("test.yaml"), check, jobs);
  }

  std::string refusal(const std::string& yaml) const {
    return refusal_by([&] { parse_campaign(yaml, folder_.file("test.yaml")); });
  }

  /// Refusal of a line 4 and on, without the folder.
  std::string refusal_of(const std::string& more) const {
    const std::string message = refusal(std::string(minimal) + more);
    const std::string prefix = folder_.file("");
    return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
  }

  TemporaryFolder folder_;
};

/// Something that any change of the scenario changes.
std::vector<Measure> simulate(const Scenario& scenario) {
  std::vector<Measure> measures{{"crit_dist_m", Measure::fleet, scenario.exam.crit_dist_m}};
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i) {
    const VehicleSpec& vehicle = scenario.vehicles[i];
    measures.push_back({"east_m", static_cast<int>(i), vehicle.position.y()});
    measures.push_back(
        {"name_count", static_cast<int>(i), static_cast<double>(vehicle.avoider->name.size())});
    measures.push_back(
        {"params_count", static_cast<int>(i), static_cast<double>(vehicle.avoider->params.size())});
  }
  return measures;
}

TEST_F(CampaignTest, IsEveryCombinationUnderTheSameSeeds) {
  const Campaign c = parse(R"(algorithms: [apf, {algorithm: apf, w2_ratio: 2.5, label: strong}]
grid: {exam.crit_dist_m: [6, 7, 10], step_s: [0.1, 0.05]}
zip: [{exam.safety_distance_m: 2, duration_s: 100}, {exam.safety_distance_m: 3, duration_s: 200}]
seeds: {first: 5, count: 4}
quantities: [makespan_s]
)");
  EXPECT_EQ(c.cells.size(), 2U * 2U * 3U * 2U);
  EXPECT_EQ(c.specs.size(), c.cells.size() * 4U);
  EXPECT_THAT(c.quantities, ElementsAre("makespan_s"));
  EXPECT_EQ(labels_text(c.specs[0].labels),
            "case=pair method=apf exam.safety_distance_m=2 duration_s=100 exam.crit_dist_m=6 step_s=0.1");
  EXPECT_EQ(
      labels_text(c.specs.back().labels),
      "case=pair method=strong exam.safety_distance_m=3 duration_s=200 exam.crit_dist_m=10 step_s=0.05");

  const std::string file = shell_word(c.scenarios[0].file);
  EXPECT_EQ(command_of(c.specs[1]),
            "fairway run " + file +
                " --set 'vehicles[*].avoider=apf' --set exam.safety_distance_m=2 --set duration_s=100"
                " --set exam.crit_dist_m=6 --set step_s=0.1 --seed 6");

  std::set<std::string> keys;
  for (std::size_t i = 0; i < c.specs.size(); ++i) {
    EXPECT_EQ(c.specs[i].seed, 5 + i % 4);
    EXPECT_EQ(c.specs[i].key.size(), 32U);
    keys.insert(c.specs[i].key);
  }
  EXPECT_EQ(keys.size(), c.specs.size());

  const Scenario last = c.scenario_of(c.specs.size() - 1);
  EXPECT_EQ(last.seed, 8U);
  EXPECT_EQ(last.exam.crit_dist_m, 10.0);
  EXPECT_EQ(last.exam.safety_distance_m, 3.0);
  EXPECT_EQ(last.duration_s, 200.0);
  EXPECT_EQ(last.step_s, 0.05);
  EXPECT_EQ(last.vehicles[1].avoider->name, "apf");
  EXPECT_EQ(last.vehicles[1].avoider->params, (ParamValues{{"w2_ratio", 2.5}}));
  EXPECT_EQ(c.scenario_of(0).vehicles[1].avoider->params, ParamValues{});
}

TEST_F(CampaignTest, SeedsAreSharedSoThatCellsMeetTheSameCase) {
  const Campaign c = parse("algorithms: [apf, orca3d]\nseeds: {count: 2}\n");
  const auto east = [&](std::size_t run) { return c.scenario_of(run).vehicles[0].position.y(); };
  EXPECT_EQ(east(0), east(2));
  EXPECT_EQ(east(1), east(3));
  EXPECT_NE(east(0), east(1));
}

TEST_F(CampaignTest, AvoiderParametersCanBeVariedWithinAnAlgorithm) {
  const Campaign c = parse("algorithms: [apf]\ngrid: {\"vehicles[*].avoider.crit_dist_m\": [6, 7]}\n");
  EXPECT_EQ(c.scenario_of(1).vehicles[1].avoider->params, (ParamValues{{"crit_dist_m", 7.0}}));
}

TEST_F(CampaignTest, WhatIsLaidOverEveryScenarioMakesNoColumn) {
  const Campaign c = parse("set: {duration_s: 7, \"vehicles[*].tracking\": raw}\nalgorithms: [apf]\n");
  EXPECT_EQ(c.specs[0].labels, (Labels{{"case", "pair"}, {"method", "apf"}}));
  EXPECT_EQ(c.scenario_of(0).duration_s, 7.0);
  EXPECT_THAT(c.specs[0].command, HasSubstr("--set duration_s=7 --set 'vehicles[*].tracking=raw'"));
  EXPECT_NE(c.specs[0].key, parse("algorithms: [apf]\n").specs[0].key);
}

TEST_F(CampaignTest, WithoutAlgorithmsEachScenarioKeepsItsOwn) {
  const Campaign c = parse("");
  ASSERT_EQ(c.specs.size(), 1U);
  EXPECT_EQ(c.specs[0].seed, 1U);
  EXPECT_EQ(c.specs[0].labels, (Labels{{"case", "pair"}, {"method", "as_written"}}));
  EXPECT_EQ(c.scenario_of(0).vehicles[0].avoider->name, "orca3d");
}

TEST_F(CampaignTest, KeysFollowWhatDecidesTheOutcomeAndNothingElse) {
  const std::string before = parse("").specs[0].key;
  sample::write_bytes(folder_.file("pair.yaml"),
                      "# a comment\nsummary: says more\nstep_s: 0.050\nexpect: {collision_count: 0}\n" +
                          std::string(pair_yaml));
  EXPECT_EQ(parse("").specs[0].key, before);
  sample::write_bytes(folder_.file("pair.yaml"), "step_s: 0.051\n" + std::string(pair_yaml));
  EXPECT_NE(parse("").specs[0].key, before);
}

TEST_F(CampaignTest, ResolvesTheSameOnAnyNumberOfThreads) {
  const std::string more =
      "algorithms: [apf, orca3d]\ngrid: {exam.crit_dist_m: [4, 5, 6, 7]}\nseeds: {count: 10}\n";
  const Campaign one = parse(more);
  const Campaign eight = parse(more, {}, 8);
  ASSERT_EQ(one.specs.size(), eight.specs.size());
  for (std::size_t i = 0; i < one.specs.size(); ++i) EXPECT_EQ(one.specs[i].key, eight.specs[i].key);
}

TEST_F(CampaignTest, RunsResumesAndForgetsOlderVersions) {
  const std::string more =
      "algorithms: [apf, orca3d]\ngrid: {exam.crit_dist_m: [6, 10]}\nseeds: {count: 3}\n";
  Store store = Store::in_memory();
  const Campaign first = parse(more);
  EXPECT_EQ(run_campaign(first, simulate, store, {.jobs = 2}).made, 12U);
  EXPECT_EQ(run_campaign(first, simulate, store).made, 0U);
  EXPECT_THAT(sample::csv_of(store), HasSubstr("pair,orca3d,10,3,,crit_dist_m,10\n"));

  sample::write_bytes(folder_.file("pair.yaml"), "step_s: 0.051\n" + std::string(pair_yaml));
  const Campaign second = parse(more);
  EXPECT_EQ(run_campaign(second, simulate, store).made, 12U);
  EXPECT_EQ(store.size(), 24U);
  EXPECT_EQ(records_of(second, store).size(), 12U);
}

TEST_F(CampaignTest, TheStoreRemembersTheOrderOfTheFile) {
  const Campaign campaign = parse("algorithms: [orca3d, apf]\ngrid: {exam.crit_dist_m: [10, 6]}\n");
  Store store = Store::in_memory();
  run_campaign(campaign, simulate, store, {.jobs = 4});
  EXPECT_EQ(store.origin().campaign, campaign.name);
  EXPECT_EQ(values_of(store.origin().order, "method"), (std::vector<std::string>{"orca3d", "apf"}));
  EXPECT_EQ(values_of(store.origin().order, "exam.crit_dist_m"), (std::vector<std::string>{"10", "6"}));
}

TEST_F(CampaignTest, TheScenarioIsTheOneThatWasLoaded) {
  const Campaign c = parse("");
  std::filesystem::remove(folder_.file("pair.yaml"));
  EXPECT_EQ(c.scenario_of(0).name, "pair");
}

TEST_F(CampaignTest, EachCellIsCheckedBeforeAnythingIsRun) {
  std::vector<std::string> seen;
  const auto check = [&](const Scenario& s) {
    seen.push_back(s.vehicles[0].avoider->name);
    if (s.vehicles[0].avoider->name == "orca") throw InputError("unknown algorithm orca");
  };
  parse("algorithms: [apf, orca3d]\nseeds: {count: 3}\n", check);
  EXPECT_THAT(seen, ElementsAre("apf", "orca3d"));
  EXPECT_THAT(
      refusal_by([&] { parse("algorithms: [apf, orca, orca3d]\nseeds: {first: 4, count: 3}\n", check); }),
      HasSubstr("test.yaml: in case=pair method=orca seed=4: unknown algorithm orca"));
}

TEST_F(CampaignTest, AnAlgorithmThatDoesNotFitIsToldWhereItIsWritten) {
  const auto check = [](const Scenario& scenario) { Simulation{scenario, builtin_catalogs()}; };
  const auto told = [&](const std::string& more) {
    return refusal_by([&] { parse(more, check); }).substr(folder_.file("").size());
  };
  EXPECT_EQ(told("algorithms: [apf, orcad]\n"),
            "test.yaml:4:19: algorithms[1]: unknown algorithm \"orcad\"; did you mean orca3d?");
  EXPECT_EQ(
      told("algorithms:\n  - {algorithm: orca3d, time_horizn_s: 4}\n"),
      "test.yaml:5:17: algorithms[0].time_horizn_s: unknown parameter of orca3d+trackable; did you mean "
      "time_horizon_s?");
  sample::write_bytes(folder_.file("best.yaml"), "algorithm: orca3d\ntime_horizn_s: 4\n");
  EXPECT_THAT(told("algorithms: [{file: best.yaml}]\n"),
              testing::StartsWith("best.yaml:1:12: time_horizn_s: unknown parameter of orca3d"));
}

TEST_F(CampaignTest, MistakesAreRefusedWithTheirPlace) {
  EXPECT_EQ(refusal_of("algorithm: [apf]\n"),
            "test.yaml:4:1: algorithm: unknown key; did you mean algorithms?");
  EXPECT_EQ(refusal_of("algorithms: []\n"),
            "test.yaml:4:13: algorithms: the list is empty; leave the key out to keep each scenario's own");
  EXPECT_EQ(refusal_of("algorithms: [apf, apf]\n"),
            "test.yaml:4:19: algorithms[1]: a second apf; give it a label of its own");
  EXPECT_THAT(refusal_of("algorithms: [{label: x}]\n"),
              HasSubstr("algorithms[0]: the key algorithm is missing"));
  EXPECT_THAT(refusal_of("seeds: {first: 1}\n"), HasSubstr("seeds: the key count is missing"));
  EXPECT_THAT(refusal_of("seeds: {count: 0}\n"),
              HasSubstr("test.yaml:4:16: seeds.count: expected a whole number in [1, 1000000]"));
  EXPECT_THAT(refusal_of("seeds: {first: 18446744073709551615, count: 2}\n"),
              HasSubstr("seeds: pass the largest seed"));
  EXPECT_THAT(refusal_of("grid: {step_s: 0.1}\n"),
              HasSubstr("grid.step_s: expected a list of values, as [6, 7, 10], got 0.1"));
  EXPECT_THAT(refusal_of("grid: {step_s: [0.1, 0.1]}\n"), HasSubstr("grid.step_s[1]: 0.1 is given twice"));
  EXPECT_THAT(refusal_of("grid: {seed: [1]}\n"), HasSubstr("grid.seed: is set by the key seeds"));
  EXPECT_THAT(refusal_of("grid: {case: [1]}\n"), HasSubstr("grid.case: is no path in a scenario"));
  EXPECT_THAT(refusal_of("algorithms: [apf]\ngrid: {\"vehicles[*].avoider\": [apf]}\n"),
              HasSubstr("is set by the key algorithms"));
  EXPECT_THAT(refusal_of("algorithms: [apf]\nset: {defaults.avoider.w2_ratio: 1}\n"),
              HasSubstr("set.defaults.avoider.w2_ratio: is set by the key algorithms"));
  EXPECT_THAT(refusal_of("zip: [{step_s: 0.1}, {duration_s: 3}]\n"),
              HasSubstr("zip[1]: must set what the first row sets"));
  EXPECT_THAT(refusal_of("zip: [{step_s: 0.1}]\ngrid: {step_s: [0.1]}\n"),
              HasSubstr("zip[0].step_s: is set by grid too"));
  EXPECT_THAT(refusal_of("set: {step_s: 0.1}\ngrid: {step_s: [0.1]}\n"),
              HasSubstr("grid.step_s: is set by set too"));
  EXPECT_THAT(refusal_of("set: {seed: 2}\n"), HasSubstr("set.seed: is set by the keys seeds and algorithms"));
  EXPECT_THAT(refusal_of("name: again\n"), HasSubstr("test.yaml:4:1: name: given twice, before in line 2"));
}

TEST_F(CampaignTest, WhatIsVariedAndChangesNothingIsRefused) {
  const std::string same = "are the same run; what is varied is set again elsewhere, or by every vehicle";
  EXPECT_THAT(refusal_of("set: {\"vehicles[*].radius_m\": 1}\ngrid: {defaults.radius_m: [1, 2]}\n"),
              AllOf(StartsWith("test.yaml: in case=pair method=as_written: defaults.radius_m=1 and "
                               "defaults.radius_m=2 "),
                    HasSubstr(same)));
  EXPECT_THAT(refusal_of("zip: [{step_s: 0.1}, {step_s: 0.10}]\n"), HasSubstr(same));
}

TEST_F(CampaignTest, SettingsAreLaidOverWhatTheAlgorithmsSay) {
  const Campaign campaign = parse("algorithms: [apf]\nset: {\"vehicles[*].avoider.w2_ratio\": 3}\n");
  EXPECT_THAT(canonical_text(campaign.scenario_of(0)), HasSubstr("w2_ratio: 3"));
}

TEST_F(CampaignTest, MistakesInTheScenarioNameTheCellTheyAreOf) {
  EXPECT_THAT(refusal_of("algorithms: [apf]\ngrid: {exam.crit_dist: [6]}\n"),
              StartsWith("test.yaml: in case=pair method=apf exam.crit_dist=6 seed=1: --set exam.crit_dist: "
                         "unknown key; did you mean"));
  EXPECT_THAT(refusal_of("grid: {step_s: [-1]}\n"),
              HasSubstr("in case=pair method=as_written step_s=-1 seed=1: "));
}

TEST_F(CampaignTest, FilesThatAreNoCampaignOrNotThereAreRefused) {
  EXPECT_THAT(refusal("fairway_campaign: 2\nname: x\nscenario: pair.yaml\n"),
              HasSubstr(":1:19: fairway_campaign: is 2; this fairway reads campaigns of version 1"));
  EXPECT_THAT(refusal("name: x\nscenario: pair.yaml\n"), HasSubstr("the key fairway_campaign is missing"));
  EXPECT_THAT(refusal("[1, 2]"), HasSubstr("not a campaign"));
  EXPECT_THAT(refusal(""), HasSubstr("not a campaign"));
  EXPECT_THAT(refusal("fairway_campaign: 1\nname: x\nscenario: none.yaml\n"),
              HasSubstr("test.yaml:3:11: scenario: "));
  EXPECT_THAT(refusal("fairway_campaign: 1\nname: x\nscenario: [pair.yaml, ./pair.yaml]\n"),
              HasSubstr("a second one named pair"));
  EXPECT_THAT(refusal("fairway_campaign: 1\nname: x\nscenario: .\n"), HasSubstr("cannot be read"));
  EXPECT_THROW(load_campaign(folder_.file("none.yaml")), InputError);
}

TEST_F(CampaignTest, TooManyRunsAreRefusedAtOnce) {
  std::string values;
  for (int i = 0; i < 1000; ++i) values += std::to_string(i) + ", ";
  EXPECT_THAT(refusal_of("grid: {a: [" + values + "], b: [" + values + "], c: [" + values + "]}\n"),
              HasSubstr("more than 10000000 runs"));
}

TEST_F(CampaignTest, ARunWithAMethodOfTheProgramsOwnHasItsVersionInTheKey) {
  const std::string two = "algorithms: [orca3d, {algorithm: mine+stop_and_wait}]\n";
  const auto with = [&](const std::string& version, const std::string& program) {
    const auto own = [version](const Scenario& scenario) {
      return scenario.vehicles[0].avoider->name.starts_with("mine") ? version : std::string();
    };
    return parse_campaign(std::string(minimal) + two, folder_.file("test.yaml"), {}, 2, {own, program}).specs;
  };
  const std::vector<RunSpec> plain = parse(two).specs;
  const std::vector<RunSpec> first = with("1", "own_method");
  const std::vector<RunSpec> second = with("2", "");
  ASSERT_EQ(first.size(), 2U);

  EXPECT_EQ(first[0].key, plain[0].key) << "fairway's own methods are known by results_epoch";
  EXPECT_EQ(first[1].key, with("1", "")[1].key);
  EXPECT_NE(first[1].key, plain[1].key);
  EXPECT_NE(first[1].key, second[1].key);

  EXPECT_THAT(first[0].command, StartsWith("fairway run "));
  EXPECT_THAT(first[1].command, StartsWith("own_method run "));
  EXPECT_EQ(second[1].command, "");
}

TEST_F(CampaignTest, ShardsAreTheWholeOnceWithTheSameKeys) {
  const std::string yaml = std::string(minimal) + R"(algorithms: [orca3d, avoa]
grid: {exam.crit_dist_m: [6, 7, 10]}
seeds: {first: 5, count: 7}
)";
  const auto keys_of = [&](const Shard& shard) {
    const Campaign part = parse_campaign(yaml, folder_.file("test.yaml"), {}, 2, {}, shard);
    EXPECT_EQ(part.run_count(), 42U);
    std::set<std::string> keys;
    for (std::size_t i = 0; i < part.specs.size(); ++i) {
      EXPECT_EQ(part.scenario_of(i).seed, part.specs[i].seed);
      EXPECT_TRUE(keys.insert(part.specs[i].key).second);
    }
    return keys;
  };
  const std::set<std::string> whole = keys_of({});
  EXPECT_EQ(whole.size(), 42U);
  for (const std::uint32_t count : {2U, 5U, 64U}) {
    std::set<std::string> all;
    std::size_t runs = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      std::set<std::string> part = keys_of({i, count});
      runs += part.size();
      all.merge(part);
    }
    EXPECT_EQ(runs, 42U);
    EXPECT_EQ(all, whole);
  }
}

TEST_F(CampaignTest, AShardHasWhatThePlanSays) {
  const std::string yaml = std::string(minimal) + "algorithms: [orca3d, avoa]\nseeds: {count: 9}\n";
  const ShardPlan plan = plan_of(parse_campaign(yaml, folder_.file("test.yaml")), 4);
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Campaign part = parse_campaign(yaml, folder_.file("test.yaml"), {}, 1, {}, {i, 4});
    EXPECT_EQ(part.specs.size(), plan.runs[i]);
  }
  const auto [least, most] = std::ranges::minmax(plan.costs);
  EXPECT_LT(most, 1.6 * least);  // two avoa runs, or three
}

TEST_F(CampaignTest, TheDigestIsOfWhatIsRunAndOfNothingElse) {
  const auto digest_of = [&](const std::string& more) { return parse(more).digest; };
  const std::string digest = digest_of("seeds: {count: 2}\n");
  EXPECT_EQ(digest_of("seeds: {count: 2}\n# a comment\nquantities: [makespan_s]\nsummary: words\n"), digest);
  EXPECT_NE(digest_of("seeds: {count: 3}\n"), digest);
  EXPECT_NE(digest_of("seeds: {count: 2, first: 2}\n"), digest);
  EXPECT_NE(digest_of("seeds: {count: 2}\nalgorithms: [apf]\n"), digest);
  EXPECT_NE(digest_of("seeds: {count: 2}\ngrid: {step_s: [0.1]}\n"), digest);
  EXPECT_NE(digest_of("seeds: {count: 2}\nset: {step_s: 0.1}\n"), digest);
  sample::write_bytes(folder_.file("pair.yaml"), std::string(pair_yaml) + "# a comment\n");
  EXPECT_EQ(digest_of("seeds: {count: 2}\n"), digest);
  sample::write_bytes(folder_.file("pair.yaml"), std::string(pair_yaml) + "step_s: 0.1\n");
  EXPECT_NE(digest_of("seeds: {count: 2}\n"), digest);
}

TEST_F(CampaignTest, WhoWatchesTheListingIsToldInOrderAndMayEndIt) {
  const CampaignFile written = parse_campaign_file(
      "fairway_campaign: 1\nname: t\nscenario: pair.yaml\nseeds: {count: 50}\n", folder_.file("t.yaml"));
  std::vector<std::size_t> told;
  const auto list = [&](unsigned jobs, const WatchListing& watch) {
    return expanded(written, folder_.file("t.yaml"), {}, jobs, {}, {}, watch);
  };
  list(3, [&](std::size_t listed, std::size_t of) {
    EXPECT_EQ(of, 50U);
    told.push_back(listed);
  });
  EXPECT_TRUE(std::ranges::is_sorted(told));
  told.clear();
  list(1, [&](std::size_t listed, std::size_t) { told.push_back(listed); });
  EXPECT_EQ(told.size(), 50U);
  EXPECT_THROW(list(1, [](std::size_t, std::size_t) { throw RunAbandoned{}; }), RunAbandoned);
}

TEST_F(CampaignTest, RunsThatAreKeptKeepTheirCells) {
  Campaign c = parse("algorithms: [apf, orca3d]\nseeds: {count: 4}\n");
  keep_runs(c, [](const RunSpec& spec) { return spec.seed == 3; });
  ASSERT_EQ(c.specs.size(), 2U);
  EXPECT_EQ(*find_label(c.specs[1].labels, "method"), "orca3d");
  EXPECT_EQ(c.scenario_of(1).vehicles[0].avoider->name, "orca3d");
}

}  // namespace
}  // namespace fairway
