// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

using testing::HasSubstr;

RunRecord run(const std::string& method, std::uint64_t seed, std::vector<Measure> measures,
              const std::string& place = "bay") {
  return {.spec = {method + std::to_string(seed) + place, {{"case", place}, {"method", method}}, seed},
          .measures = std::move(measures),
          .wall_s = 0.0,
          .failure = {}};
}

Measure makespan(double value) { return {"makespan_s", Measure::fleet, value}; }

const ComparedMean& mean_of(const Comparison& c, const std::string& candidate,
                            const std::string& quantity = "makespan_s") {
  return *std::find_if(c.means.begin(), c.means.end(), [&](const ComparedMean& m) {
    return m.candidate == candidate && m.quantity == quantity;
  });
}

TEST(CompareTest, PairsRunsBySeedSoThatWhatTheyShareCancels) {
  // seeds differ by hundreds, methods by 1, 2 and 3
  const std::vector<RunRecord> records{run("apf", 1, {makespan(100)}),    run("apf", 2, {makespan(500)}),
                                       run("apf", 3, {makespan(900)}),    run("orca3d", 3, {makespan(903)}),
                                       run("orca3d", 1, {makespan(101)}), run("orca3d", 2, {makespan(502)})};
  const Comparison c = compare(records);
  EXPECT_EQ(c.baseline, "apf");
  EXPECT_EQ(mean_of(c, "apf").value.mean, 500.0);
  EXPECT_EQ(mean_of(c, "apf").difference.count, 0U);
  const MeanEstimate& d = mean_of(c, "orca3d").difference;
  EXPECT_EQ(d.count, 3U);
  EXPECT_EQ(d.mean, 2.0);
  EXPECT_EQ(d.deviation, 1.0);
  EXPECT_NEAR(d.high, 2.0 + 4.302653 / std::sqrt(3.0), 1e-6);
  EXPECT_GT(mean_of(c, "orca3d").value.high - mean_of(c, "orca3d").value.low, 100.0 * (d.high - d.low));
}

TEST(CompareTest, OnlySeedsThatBothHaveAndMeasuredMakePairs) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  RunRecord failed = run("orca3d", 3, {});
  failed.failure = "diverged";
  const std::vector<RunRecord> records{run("apf", 1, {makespan(1)}),
                                       run("apf", 2, {makespan(nan)}),
                                       run("apf", 3, {makespan(3)}),
                                       run("apf", 4, {makespan(4)}),
                                       run("orca3d", 1, {makespan(2)}),
                                       run("orca3d", 2, {makespan(2)}),
                                       failed,
                                       run("orca3d", 5, {makespan(9)})};
  const Comparison c = compare(records);
  EXPECT_EQ(mean_of(c, "apf").value.count, 3U);
  EXPECT_EQ(mean_of(c, "orca3d").value.count, 3U);
  EXPECT_EQ(mean_of(c, "orca3d").difference.count, 1U);
  EXPECT_EQ(mean_of(c, "orca3d").difference.mean, 1.0);
  EXPECT_EQ(mean_of(c, "apf").left_out, 1U);
  EXPECT_EQ(mean_of(c, "orca3d").left_out, 1U);
  EXPECT_EQ(c.cells[1].runs, 4U);
  EXPECT_EQ(c.cells[1].failed, 1U);
}

TEST(CompareTest, ARunIsOneValueHoweverManyVehiclesItHas) {
  const std::vector<RunRecord> records{
      run("apf", 1,
          {{"distance_m", 0, 10.0},
           {"distance_m", 1, 20.0},
           {"distance_m", 2, std::numeric_limits<double>::infinity()}}),
      run("apf", 2, {{"distance_m", 0, 30.0}, {"distance_m", 1, 40.0}, {"distance_m", 2, 50.0}})};
  const MeanEstimate e = mean_of(compare(records), "apf", "distance_m").value;
  EXPECT_EQ(e.count, 2U);
  EXPECT_EQ(e.mean, (15.0 + 40.0) / 2.0);
}

TEST(CompareTest, CellsThatDifferInOtherLabelsAreNotMixed) {
  const std::vector<RunRecord> records{run("apf", 1, {makespan(1)}, "bay"),
                                       run("orca3d", 1, {makespan(2)}, "bay"),
                                       run("orca3d", 1, {makespan(7)}, "lake")};
  const Comparison c = compare(records);
  ASSERT_EQ(c.means.size(), 3U);
  EXPECT_EQ(c.means[1].difference.mean, 1.0);
  EXPECT_EQ(c.means[2].group, (Labels{{"case", "lake"}}));
  EXPECT_EQ(c.means[2].difference.count, 0U);  // no baseline there
}

TEST(CompareTest, RatesCountRunsWithWilsonsInterval) {
  std::vector<RunRecord> records;
  for (std::uint64_t seed = 0; seed < 29; ++seed) {
    records.push_back(run("apf", seed,
                          {{"collision_count", 0, 0.0},
                           {"collision_count", 1, seed == 0 ? 0.0 : 1.0},
                           {"min_separation_m", Measure::fleet, seed < 2 ? HUGE_VAL : 1.0}}));
  }
  CompareOptions options;
  options.rates.push_back({.name = "apart_ratio", .quantity = "min_separation_m", .min = 3.0});
  const Comparison c = compare(records, options);
  ASSERT_EQ(c.rates.size(), 2U);  // nobody measured arrivals
  EXPECT_EQ(c.rates[0].name, "collision_free_ratio");
  EXPECT_EQ(c.rates[0].value.successes, 1U);
  EXPECT_NEAR(c.rates[0].value.low, 0.0061, 5.1e-5);
  EXPECT_NEAR(c.rates[0].value.high, 0.1718, 5.1e-5);
  EXPECT_EQ(c.rates[1].value.successes, 2U);
}

TEST(CompareTest, WhoCollidedAndWasThenGivenUpAsStuckIsNotFreeOfCollisions) {
  const auto counted = [](std::uint64_t seed, double each, double pairs) {
    return run("pledge", seed,
               {{"collision_count", 0, each}, {"pair_collision_count", Measure::fleet, pairs}});
  };
  const Comparison c = compare(std::vector{counted(1, 0, 0), counted(2, 0, 5), counted(3, 1, 0)});
  EXPECT_EQ(c.rates[0].name, "collision_free_ratio");
  EXPECT_EQ(c.rates[0].value.successes, 1U);
}

TEST(CompareTest, FailedRunsCountAgainstRates) {
  std::vector<RunRecord> records;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    records.push_back(
        run("apf", seed,
            {{"collision_count", 0, 0.0}, {"distance_m", 0, 1.5 + 0.1 * static_cast<double>(seed)}}));
    records.push_back(run("orca3d", seed, {{"collision_count", 0, 0.0}, {"distance_m", 0, 2.5}}));
  }
  records[1].measures.clear();
  records[1].failure = records[3].failure = "diverged";
  const Comparison c = compare(records);
  ASSERT_EQ(c.rates.size(), 2U);
  EXPECT_EQ(c.rates[1].value.successes, 2U);
  EXPECT_EQ(c.rates[1].value.trials, 4U);
  EXPECT_EQ(c.rates[1].difference.pairs, 4U);
  EXPECT_EQ(c.rates[1].difference.difference, -0.5);
  EXPECT_EQ(mean_of(c, "orca3d", "distance_m").value.count, 2U);  // what a failed run measured is not used
  EXPECT_EQ(mean_of(c, "orca3d", "distance_m").left_out, 2U);
}

TEST(CompareTest, WhereEveryRunFailedEveryRateIsNone) {
  std::vector<RunRecord> records{run("apf", 1, {}), run("orca3d", 1, {})};
  for (RunRecord& record : records) record.failure = "diverged";
  const Comparison c = compare(records);
  ASSERT_EQ(c.rates.size(), 4U);
  EXPECT_EQ(c.rates[0].value.rate, 0.0);
  EXPECT_EQ(c.rates[0].value.trials, 1U);
}

TEST(CompareTest, DifferencesAreTestedAndAdjustedByHolm) {
  // 8 pairs all larger: p = 2 / 2^8; against vo 4 of 8: p = 1 up to the continuity
  std::vector<RunRecord> records;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const auto s = static_cast<double>(seed);
    records.push_back(run("apf", seed, {makespan(100.0 * s)}));
    records.push_back(run("orca3d", seed, {makespan(100.0 * s + 1.0 + s)}));
    records.push_back(run("vo", seed, {makespan(100.0 * s + (seed % 2 == 0 ? 1.0 : -1.0) * (1.0 + s))}));
  }
  const Comparison c = compare(records);
  const ComparedMean& orca = mean_of(c, "orca3d");
  ASSERT_TRUE(orca.test && mean_of(c, "vo").test);
  EXPECT_STREQ(orca.test->name, "wilcoxon_signed_rank");
  EXPECT_NEAR(orca.test->result.p, 2.0 / 256.0, 1e-15);
  EXPECT_NEAR(orca.test->p_adjusted, 4.0 / 256.0, 1e-15);
  EXPECT_EQ(orca.test->result.effect, 1.0);
  EXPECT_EQ(orca.difference_median.median, 4.5);
  EXPECT_FALSE(mean_of(c, "apf").test);
  EXPECT_EQ(c.tests, 2U);
  EXPECT_EQ(c.family, "Holm over 2 comparisons: 2 methods x 1 quantity");
}

TEST(CompareTest, DifferencesOfRoundingAreNone) {
  std::vector<RunRecord> records;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const double time = 0.1 + 0.2 * static_cast<double>(seed);
    records.push_back(run("apf", seed, {makespan(time)}));
    records.push_back(run("orca3d", seed, {makespan(std::nextafter(time, 100.0))}));
  }
  EXPECT_EQ(mean_of(compare(records), "orca3d").test->result.p, 1.0);
}

TEST(CompareTest, TheFirstOfTheCampaignIsTheBaseline) {
  const std::vector<RunRecord> records{run("apf", 1, {makespan(1)}), run("orca3d", 1, {makespan(2)}),
                                       run("vo", 1, {makespan(2)})};
  const Comparison c = compare(records, {.order = {"hrvo", "orca3d"}});
  EXPECT_EQ(c.baseline, "orca3d");
  EXPECT_EQ(c.cells[0].candidate, "orca3d");
  EXPECT_EQ(c.cells[1].candidate, "apf");
  EXPECT_EQ(compare(records, {.baseline = "vo", .order = {"orca3d"}}).baseline, "vo");
}

std::vector<RunRecord> same_runs(const std::string& method, double distance, std::size_t count) {
  std::vector<RunRecord> records;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    records.push_back(run(method, seed,
                          {{"collision_count", 0, 0.0},
                           {"distance_m", 0, distance},
                           {"nearest_m", 0, std::numeric_limits<double>::quiet_NaN()}}));
  }
  return records;
}

TEST(CompareTest, IdenticalRunsCountAsOne) {
  std::vector<RunRecord> records = same_runs("apf", 10.5, 30);
  std::ranges::copy(same_runs("orca3d", 11.25, 30), std::back_inserter(records));
  const Comparison c = compare(records);
  EXPECT_EQ(c.cells[0].runs, 1U);
  EXPECT_EQ(c.cells[0].identical, 30U);
  EXPECT_EQ(c.rates[0].value.trials, 1U);
  EXPECT_EQ(mean_of(c, "apf", "distance_m").value.count, 1U);
  EXPECT_EQ(mean_of(c, "orca3d", "distance_m").difference.count, 1U);
  EXPECT_EQ(mean_of(c, "orca3d", "distance_m").difference.mean, 0.75);
  EXPECT_EQ(mean_of(c, "orca3d", "distance_m").test->result.p, 1.0);
  EXPECT_THAT(remarks(c)[0].text,
              HasSubstr("Nothing is drawn in case=bay method=apf, case=bay method=orca3d"));
  EXPECT_EQ(to_json(c)["cells"][0]["identical"], 30);
}

TEST(CompareTest, RunsOfWhichOneDiffersOrFailedOrThatOnlyCountAllCount) {
  std::vector<RunRecord> differs = same_runs("apf", 10.5, 5);
  differs[4].measures[1].value = std::nextafter(10.5, 11.0);
  EXPECT_EQ(compare(differs).cells[0].runs, 5U);
  std::vector<RunRecord> failed = same_runs("apf", 10.5, 5);
  failed[4].failure = "diverged";
  EXPECT_EQ(compare(failed).cells[0].runs, 5U);
  EXPECT_EQ(compare(same_runs("apf", 10.0, 5)).cells[0].runs, 5U);  // whole numbers agree by chance
}

TEST(CompareTest, WhereNothingIsDrawnRunsThatFailAlikeOrOnlyCountAlikeAreOneRun) {
  std::vector<RunRecord> records = same_runs("apf", 10.5, 10);
  std::ranges::copy(same_runs("vo", 10.0, 10), std::back_inserter(records));  // whole numbers
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    records.push_back(run("orca3d", seed, {}));
    records.back().failure = "diverged: a at 12.3 s: its state is not finite";
  }
  const Comparison c = compare(records);
  for (const ComparedCell& cell : c.cells) {
    EXPECT_EQ(cell.runs, 1U) << cell.candidate;
    EXPECT_EQ(cell.identical, 10U) << cell.candidate;
  }
  for (const ComparedRate& rate : c.rates) EXPECT_LE(rate.difference.pairs, 1U) << rate.candidate;

  // in another way once: something was drawn
  records.back().failure = "diverged: a at 12.4 s: its state is not finite";
  EXPECT_EQ(compare(records).cells[1].runs, 10U);
  // nothing tells that no run of the scenario would be another
  const std::vector<RunRecord> alone{records.begin() + 20, records.begin() + 29};
  EXPECT_EQ(compare(alone).cells[0].runs, 9U);
}

TEST(CompareTest, AgainstACellInWhichNothingIsDrawnEverySeedMakesAPair) {
  std::vector<RunRecord> records = same_runs("apf", 10.5, 3);
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    records.push_back(run("rrt_star", seed, {{"distance_m", 0, 11.0 + static_cast<double>(seed)}}));
  const Comparison c = compare(records);
  EXPECT_EQ(mean_of(c, "apf", "distance_m").value.count, 1U);
  EXPECT_EQ(mean_of(c, "rrt_star", "distance_m").difference.count, 3U);
  EXPECT_EQ(mean_of(c, "rrt_star", "distance_m").difference.mean, 2.5);
}

RunRecord timed(const std::string& method, std::uint64_t seed, double time, double arrived) {
  return run(method, seed, {makespan(time), {"arrived_ratio", Measure::fleet, arrived}});
}

TEST(CompareTest, TimesThatWereCutOffAreCensored) {
  // three of five cut off at 600, against five that arrived, one later than any of them
  const std::vector<RunRecord> records{timed("apf", 1, 100, 1.0),    timed("apf", 2, 200, 1.0),
                                       timed("apf", 3, 300, 1.0),    timed("apf", 4, 400, 1.0),
                                       timed("apf", 5, 500, 1.0),    timed("orca3d", 1, 150, 1.0),
                                       timed("orca3d", 2, 250, 1.0), timed("orca3d", 3, 600, 0.5),
                                       timed("orca3d", 4, 600, 0.5), timed("orca3d", 5, 600, 0.0)};
  const Comparison c = compare(records, {.quantities = {"makespan_s"}});
  const ComparedMean& orca = mean_of(c, "orca3d");
  EXPECT_EQ(orca.value.count, 5U);
  EXPECT_TRUE(std::isnan(orca.value.mean) && std::isnan(orca.value.low));
  ASSERT_TRUE(orca.censored);
  EXPECT_EQ(orca.censored->cut, 3U);
  EXPECT_EQ(orca.censored->complete.successes, 2U);
  EXPECT_EQ(orca.censored->limit, 600.0);
  EXPECT_TRUE(std::isinf(orca.censored->median.median));
  EXPECT_NEAR(orca.censored->restricted.mean, (150.0 + 250.0 + 3.0 * 600.0) / 5.0, 1e-9);
  EXPECT_EQ(mean_of(c, "apf").value.mean, 300.0);
  EXPECT_NEAR(mean_of(c, "apf").censored->restricted.mean, 300.0, 1e-9);

  // 50, 50, 300, 200, 100 longer; by how much is not known, that it is longer is
  EXPECT_NEAR(orca.difference.mean, 140.0, 1e-9);
  EXPECT_TRUE(std::isnan(orca.difference_median.median));
  EXPECT_STREQ(orca.test->name, "sign");
  EXPECT_EQ(orca.test->result.pairs, 5U);
  EXPECT_NEAR(orca.test->result.p, 2.0 / 32.0, 1e-15);
  EXPECT_EQ(orca.test->result.effect, 1.0);

  const nlohmann::json json = to_json(c)["means"][1];
  EXPECT_TRUE(json["value"]["mean"].is_null());
  EXPECT_TRUE(json["censored"]["median"].is_null());
  EXPECT_EQ(json["censored"]["cut"], 3);
}

TEST(CompareTest, PairsOfWhichNobodyKnowsWhichTookLongerDoNotDecide) {
  const std::vector<RunRecord> records{timed("apf", 1, 600, 0.5),    timed("apf", 2, 600, 0.5),
                                       timed("apf", 3, 500, 1.0),    timed("orca3d", 1, 600, 0.5),
                                       timed("orca3d", 2, 400, 1.0), timed("orca3d", 3, 450, 0.5)};
  const Comparison c = compare(records);
  const ComparedMean& orca = mean_of(c, "orca3d");
  EXPECT_EQ(orca.test->result.pairs,
            1U);  // seed 2 alone: both were cut off, or the one before the other arrived
  EXPECT_EQ(orca.test->result.effect, -1.0);
}

TEST(CompareTest, OfTimesOfVehiclesEachCountsUntilTheEndOfTheRunAtMost) {
  // of ten, nine need 100 s and the last does not arrive by 600; or all need 300 s
  const auto run_of = [](const std::string& method, std::uint64_t seed, double most, double last,
                         double arrived) {
    std::vector<Measure> measures{{"arrived_ratio", Measure::fleet, arrived}};
    for (int vehicle = 0; vehicle < 9; ++vehicle)
      measures.push_back({"navigation_time_s", vehicle, most + static_cast<double>(seed)});
    measures.push_back({"navigation_time_s", 9, last});
    return run(method, seed, measures);
  };
  std::vector<RunRecord> records;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    records.push_back(run_of("apf", seed, 100.0, 600.0, 0.9));
    records.push_back(run_of("orca3d", seed, 300.0, 300.0, 1.0));
  }
  const Comparison c = compare(records);
  const ComparedMean& apf = mean_of(c, "apf", "navigation_time_s");
  const ComparedMean& orca = mean_of(c, "orca3d", "navigation_time_s");
  EXPECT_FALSE(apf.censored);
  EXPECT_NEAR(apf.value.mean, 150.0 + 0.9 * 10.5, 1e-9);
  EXPECT_NEAR(orca.difference.mean, 150.0, 1e-9) << "apf is quicker in the mean, though one does not arrive";
  EXPECT_EQ(apf.truncated, 20U);
  EXPECT_EQ(orca.truncated, 0U);
}

TEST(CompareTest, QuantitiesThatAreNoTimesToAnArrivalAreNotCensored) {
  std::vector<RunRecord> records{timed("apf", 1, 600, 0.5), timed("apf", 2, 600, 0.5)};
  for (RunRecord& record : records) record.measures.push_back({"hold_time_s", 0, 7.0});
  EXPECT_FALSE(mean_of(compare(records), "apf", "hold_time_s").censored);
  EXPECT_TRUE(cut_off(records[0].measures, "navigation_time_s"));
}

std::string refusal(const std::vector<RunRecord>& records, const CompareOptions& options) {
  return refusal_by([&] { compare(records, options); });
}

TEST(CompareTest, RefusesWhatNoRunHas) {
  const std::vector<RunRecord> records{run("apf", 1, {makespan(1)}), run("orca3d", 1, {makespan(2)})};
  EXPECT_THAT(refusal({}, {}), HasSubstr("no runs to compare"));
  EXPECT_THAT(refusal(records, {.by = "methods"}),
              HasSubstr("no run has the label methods; did you mean method?"));
  EXPECT_THAT(refusal(records, {.baseline = "orca3"}),
              HasSubstr("no run has method=orca3; did you mean orca3d?"));
  EXPECT_THAT(refusal(records, {.quantities = {"makespan"}}),
              HasSubstr("no run measured makespan; did you mean makespan_s?"));
}

TEST(CompareTest, RefusesTwoVersionsOfOneScenario) {
  std::vector<RunRecord> records{run("apf", 1, {makespan(1)}), run("apf", 1, {makespan(2)})};
  records[1].spec.key = "other";
  EXPECT_THAT(refusal(records, {}), HasSubstr("two runs of case=bay method=apf have the seed 1"));
}

TEST(CompareTest, RefusesTwoVersionsOfOneCellWhateverTheSeeds) {
  std::vector<RunRecord> records{run("apf", 1, {makespan(1)}), run("apf", 2, {makespan(2)}),
                                 run("apf", 3, {makespan(3)})};
  records[1].spec.version = "old";
  EXPECT_EQ(refusal(records, {}), "accepted");  // of the others it is not known
  records[2].spec.version = "new";
  EXPECT_THAT(refusal(records, {}),
              HasSubstr("the runs of case=bay method=apf with the seeds 2 and 3 are of two versions"));
  EXPECT_EQ(refusal(records, {.mixed = true}), "accepted");
  records[2].spec.labels[1].second = "vo";
  EXPECT_EQ(refusal(records, {}), "accepted");
}

TEST(CompareTest, RefusesAQuantityThatIsAskedAboutTwice) {
  const std::vector<RunRecord> records{run("apf", 1, {makespan(1)}), run("orca3d", 1, {makespan(2)})};
  EXPECT_EQ(refusal(records, {.quantities = {"makespan_s", "makespan_s"}}),
            "makespan_s: is asked about twice");
}

TEST(CompareTest, JsonHasFullPrecisionAndNullForTheUnknown) {
  const std::vector<RunRecord> records{run("apf", 1, {makespan(0.1)}), run("orca3d", 1, {makespan(0.3)})};
  const nlohmann::json json = to_json(compare(records));
  EXPECT_EQ(json["means"][0]["value"]["mean"], 0.1);
  EXPECT_TRUE(json["means"][0]["value"]["low"].is_null());
  EXPECT_TRUE(json["means"][0]["difference"].is_null());
  EXPECT_EQ(json["means"][1]["difference"]["mean"], 0.3 - 0.1);
  EXPECT_EQ(json["means"][1]["method"], "orca3d");
  EXPECT_EQ(json["means"][1]["group"]["case"], "bay");
}

}  // namespace
}  // namespace fairway
