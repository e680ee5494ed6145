// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "fairway/core/error.hpp"

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

std::string refusal(const std::vector<RunRecord>& records, const CompareOptions& options) {
  try {
    compare(records, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
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

TEST(CompareTest, TableIsAligned) {
  RunRecord failed = run("orca3d", 3, {});
  failed.failure = "diverged";
  const std::vector<RunRecord> records{run("apf", 1, {makespan(100)}), run("apf", 2, {makespan(102)}),
                                       run("orca3d", 1, {makespan(90)}), run("orca3d", 2, {makespan(92)}),
                                       failed};
  EXPECT_EQ(table_text(compare(records)),
            "case  method  quantity    runs  mean            95 %  less apf        95 %  pairs\n"
            "bay   apf     makespan_s     2   101  [88.29, 113.7]         -           -      -\n"
            "bay   orca3d  makespan_s     2    91  [78.29, 103.7]       -10  [-10, -10]      2\n"
            "\n"
            "case  method  failed  runs\n"
            "bay   orca3d       1     3\n");
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
