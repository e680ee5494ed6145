// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/exam_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/exam/exam_page.hpp"
#include "fairway/exam/exam_text.hpp"
#include "fairway/exam/reference.hpp"
#include "fairway/experiment/version.hpp"

namespace fairway {
namespace {

constexpr std::uint64_t seeds = 40;

ExamOutcome outcome(bool safe, double time, double arrived = 1.0) {
  return {.safe = safe ? 1.0 : 0.0,
          .arrived_ratio = arrived,
          .no_progress = arrived < 1.0 ? 1.0 : 0.0,
          .time_s = time,
          .length_m = 10.0,
          .energy_j = std::numeric_limits<double>::quiet_NaN(),
          .turning_rad = 1.0,
          .clearance_m = safe ? 1.0 : -1.0,
          .worst_vehicle = 0.0,
          .worst_time_s = 5.0};
}

/// Runs of a method in a cell, an outcome for every seed.
template <class Make>
void add(std::vector<ExamRun>& runs, const std::string& method, const std::string& condition,
         const Make& make) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    runs.push_back({.family = "cubes",
                    .condition = condition,
                    .method = method,
                    .ground = "g",
                    .seed = seed,
                    .outcome = make(seed),
                    .command = "fairway run g.yaml --seed "});
}

/// `careful` is never unsafe, `bold` in every second run though it is faster, `slow` never and slower.
std::vector<ExamRun> sample(bool reversed = false) {
  std::vector<ExamRun> runs;
  add(runs, "direct", "known", [](std::uint64_t) { return outcome(false, 50.0); });
  add(runs, reversed ? "bold" : "careful", "known",
      [](std::uint64_t seed) { return outcome(true, 60.0 + 0.1 * static_cast<double>(seed)); });
  add(runs, reversed ? "careful" : "bold", "known",
      [](std::uint64_t seed) { return outcome(seed % 2 == 0, 55.0); });
  add(runs, "slow", "known", [](std::uint64_t) { return outcome(true, 90.0); });
  return runs;
}

const ExamOrder order{.families = {"cubes"},
                      .conditions = {"known", "told"},
                      .methods = {"direct", "careful", "bold", "slow"},
                      .baseline = "direct"};

const Placing& placing_of(const ExamTable& table, const std::string& method, std::size_t contest = 0) {
  return *std::ranges::find_if(table.contests.at(contest).placings,
                               [&](const Placing& p) { return p.cell->method == method; });
}

double value_of(const ExamTable& table, const std::string& method, const std::string& quantity) {
  return std::ranges::find_if(
             table.rows, [&](const ExamRow& row) { return row.method == method && row.quantity == quantity; })
      ->mean;
}

TEST(ExamTable, SafetyGoesBeforeTime) {
  const std::vector<ExamRun> runs = sample();
  const ExamTable table = exam_table(runs, order);
  ASSERT_EQ(table.contests.size(), 1U);
  EXPECT_EQ(placing_of(table, "careful").place, Place::first);
  EXPECT_EQ(placing_of(table, "bold").place, Place::behind);
  EXPECT_EQ(placing_of(table, "bold").behind_in, "safety");
  EXPECT_EQ(placing_of(table, "slow").behind_in, "outcome");
  EXPECT_EQ(table.tests, 4U);  // two of each who does not lead
}

TEST(ExamTable, NumbersAreRelativeToTheBaselineOfTheSameSeed) {
  const std::vector<ExamRun> runs = sample();
  const ExamTable table = exam_table(runs, order);
  EXPECT_NEAR(value_of(table, "careful", "time_ratio"), (60.0 + 0.1 * 20.5) / 50.0, 1e-12);
  EXPECT_EQ(value_of(table, "bold", "collision_free_ratio"), 0.5);
  EXPECT_EQ(value_of(table, "bold", "worst_clearance_m"), -1.0);
  EXPECT_TRUE(std::ranges::none_of(
      table.rows, [](const ExamRow& row) { return row.quantity == "energy_ratio"; }));  // nobody knows it
}

TEST(ExamTable, RunsInWhichNotAllArrivedHaveNoTime) {
  std::vector<ExamRun> runs = sample();
  for (ExamRun& run : runs)
    if (run.method == "slow" && run.seed > 1) run.outcome = outcome(true, 20.0, 0.5);
  const ExamTable table = exam_table(runs, order);
  EXPECT_EQ(placing_of(table, "slow").cell->time_ratio(), 90.0 / 50.0);
  EXPECT_EQ(placing_of(table, "slow").behind_in, "outcome");
}

TEST(ExamTable, WhatTheRunsDoNotShowIsATie) {
  std::vector<ExamRun> runs = sample();
  for (ExamRun& run : runs)  // one run in forty is no evidence, and half a percent of time is none
    if (run.method == "bold")
      run.outcome = outcome(run.seed != 7, 60.2 + 0.1 * static_cast<double>(run.seed));
  const ExamTable table = exam_table(runs, order);
  EXPECT_EQ(placing_of(table, "careful").place, Place::shared);
  EXPECT_EQ(placing_of(table, "bold").place, Place::shared);
  EXPECT_EQ(placing_of(table, "slow").place, Place::behind);
  EXPECT_EQ(
      findings(table),
      std::vector<std::string>{
          "cubes, known: careful and bold are not told apart; the other 1 of 3 are shown to be behind."});
}

TEST(ExamTable, WhoeverLosesUnderEverySeedIsBehindThoughItsWaysOfLosingDiffer) {
  std::vector<ExamRun> runs = sample();
  for (ExamRun& run : runs)  // one in eight unsafe, none arrived
    if (run.method == "bold") run.outcome = outcome(run.seed % 8 != 0, 55.0, 0.0);
  const ExamTable table = exam_table(runs, order);
  EXPECT_EQ(placing_of(table, "bold").behind_in, "outcome");
}

TEST(ExamTable, TheOrderOfTheRunsDoesNotMatter) {
  const std::vector<ExamRun> runs = sample();
  std::vector<ExamRun> shuffled{runs.rbegin(), runs.rend()};
  EXPECT_EQ(to_json(exam_table(runs, order), {}).dump(), to_json(exam_table(shuffled, order), {}).dump());
}

TEST(ExamTable, TheFrontHoldsWhomNobodyBeatsInBoth) {
  const std::vector<ExamRun> runs = sample();
  const ExamTable table = exam_table(runs, order);
  EXPECT_TRUE(placing_of(table, "careful").on_front);
  EXPECT_TRUE(placing_of(table, "bold").on_front);
  EXPECT_FALSE(placing_of(table, "slow").on_front);
}

TEST(ExamTable, MeanRanksAreOfTheSeedsThatAllHave) {
  std::vector<ExamRun> runs = sample();
  std::erase_if(runs, [](const ExamRun& run) { return run.method == "slow" && run.seed > 10; });
  const ExamTable table = exam_table(runs, order);
  EXPECT_EQ(table.contests[0].seeds, 10U);
  EXPECT_DOUBLE_EQ(placing_of(table, "slow").mean_rank, 2.5);  // bold is before it in half of them
  EXPECT_DOUBLE_EQ(placing_of(table, "careful").mean_rank, 1.5);
}

TEST(ExamTable, WhoeverIsAloneIsFirstOfNobody) {
  std::vector<ExamRun> runs = sample();
  std::erase_if(runs, [](const ExamRun& run) { return run.method == "bold" || run.method == "slow"; });
  const ExamTable table = exam_table(runs, order);
  EXPECT_EQ(placing_of(table, "careful").place, Place::alone);
  EXPECT_TRUE(findings(table).empty());
}

TEST(ExamFindings, SayWhatTheNumbersSay) {
  const std::vector<ExamRun> runs = sample();
  const std::vector<std::string> said = findings(exam_table(runs, order));
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0],
            "cubes, known: careful is first of 3: 40 of 40 runs without a collision, 1.24 of the time alone; "
            "next is slow: 40 of 40 runs without a collision, 1.80 of the time alone.");
}

TEST(ExamFindings, TurnRoundWithTheNumbers) {
  const std::vector<ExamRun> runs = sample(/*reversed=*/true);
  const std::vector<std::string> said = findings(exam_table(runs, order));
  ASSERT_EQ(said.size(), 1U);
  EXPECT_TRUE(said[0].starts_with("cubes, known: bold is first of 3")) << said[0];
}

TEST(ExamFindings, AreWithheldWhereRunsAreMissing) {
  std::vector<ExamRun> runs = sample();
  std::erase_if(runs, [](const ExamRun& run) { return run.seed > 4; });
  EXPECT_TRUE(findings(exam_table(runs, order)).empty());
  EXPECT_TRUE(findings(exam_table(std::vector<ExamRun>{}, order)).empty());
}

TEST(ExamFindings, TheOnlySafeOneIsSaidToBeSoWhereAllOthersAreShownToBeLess) {
  std::vector<ExamRun> runs = sample();
  for (ExamRun& run : runs)
    if (run.method == "slow") run.outcome.safe = 0.0;
  const std::vector<std::string> said = findings(exam_table(runs, order));
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[1], "cubes, known: careful is the only one of 3 that touched nobody in any of 40 runs.");
}

TEST(ExamFindings, AConditionCostsWhatTheSameSeedsShow) {
  std::vector<ExamRun> runs = sample();
  add(runs, "direct", "told", [](std::uint64_t) { return outcome(false, 50.0); });
  add(runs, "careful", "told", [](std::uint64_t seed) { return outcome(seed > 30, 80.0); });
  add(runs, "slow", "told", [](std::uint64_t seed) { return outcome(seed > 1, 90.0); });
  const ExamTable table = exam_table(runs, order);
  ASSERT_EQ(table.awareness.size(), 2U);
  EXPECT_DOUBLE_EQ(table.awareness[0].safety.difference, -0.75);
  const std::vector<std::string> said = findings(table);
  const auto costs = [](const std::string& text) { return text.find("under told") != std::string::npos; };
  ASSERT_EQ(std::ranges::count_if(said, costs), 1);  // one run in forty is nothing
  EXPECT_TRUE(
      std::ranges::find_if(said, costs)
          ->starts_with("careful under told: 75 in 100 runs fewer without a collision than under known"));
}

TEST(ExamFindings, AConditionsTimeIsOfTheSeedsThatBothHave) {
  std::vector<ExamRun> runs = sample();
  add(runs, "direct", "told", [](std::uint64_t) { return outcome(false, 50.0); });
  add(runs, "careful", "told",
      [](std::uint64_t seed) { return outcome(true, 1.1 * (60.0 + 0.1 * static_cast<double>(seed))); });
  std::erase_if(runs, [](const ExamRun& run) {
    return run.method == "careful" && run.seed == (run.condition == "told" ? 1U : seeds);
  });
  const ExamTable table = exam_table(runs, order);
  ASSERT_EQ(table.awareness.size(), 1U);
  EXPECT_EQ(table.awareness[0].time_ratio.count, seeds - 2);
  EXPECT_NEAR(table.awareness[0].time_ratio.high, 0.1, 1e-12);
}

TEST(ExamTexts, TheTableIsCsvAndLatexWithoutWhatIsNotKnown) {
  const std::vector<ExamRun> runs = sample();
  const ExamTable table = exam_table(runs, order);
  const std::string csv = rows_csv(table);
  EXPECT_TRUE(csv.starts_with(exam_rows_file.holds));
  EXPECT_NE(csv.find("cubes,known,bold,false,worst_clearance_m,-1,,,40\n"), std::string::npos);
  EXPECT_NE(latex_of(table).find("cubes & known & careful & 40 & 40 & 1.24 & first"), std::string::npos);
}

TEST(ExamTexts, WhateverIsInANameIsTextOfLatexAndAFieldOfCsv) {
  const std::string odd = "a,\"b\"_50% & #1 {x} $ ~ ^ \\";
  std::vector<ExamRun> runs;
  add(runs, "direct", "known", [](std::uint64_t) { return outcome(false, 50.0); });
  add(runs, odd, "known", [](std::uint64_t) { return outcome(true, 60.0); });
  const ExamTable table = exam_table(runs, order);
  EXPECT_NE(latex_of(table).find("cubes & known & a,\"b\"\\_50\\% \\& \\#1 \\{x\\} \\$ \\textasciitilde{} "
                                 "\\textasciicircum{} \\textbackslash{} & 40"),
            std::string::npos)
      << latex_of(table);
  EXPECT_NE(rows_csv(table).find("cubes,known,\"a,\"\"b\"\"_50% & #1 {x} $ ~ ^ \\\",false,"),
            std::string::npos)
      << rows_csv(table);
}

TEST(ExamPage, HasACellForEveryoneWhoEnteredAndLeadsToItsRuns) {
  const std::vector<ExamRun> runs = sample();
  const std::vector<ExamCondition> conditions{{.name = "known", .meaning = "m"}};
  const nlohmann::json page =
      exam_page(exam_table(runs, order),
                {.families = {}, .conditions = conditions, .absences = {}, .decision_times = {}});
  const nlohmann::json heat = page["sections"][1]["blocks"][0];
  EXPECT_EQ(heat["kind"], "heat");
  EXPECT_EQ(heat["series"].size(), 3U);  // the baseline is none of them
  EXPECT_EQ(heat["series"][1]["cells"][0]["value"], 0.5);
  EXPECT_EQ(heat["series"][1]["cells"][0]["values"].size(), seeds);
  EXPECT_EQ(heat["series"][1]["cells"][0]["values_label"], "clearance left [m]");
  EXPECT_NE(page.dump().find("fairway explain worst.mcap --vehicle 0 --time 5"), std::string::npos);

  const nlohmann::json shown = heat["see"][0];
  const auto& distributions = page["sections"][4]["blocks"];
  EXPECT_EQ(std::ranges::count(distributions, shown, [](const auto& block) { return block["title"]; }), 1);
}

TEST(ExamPage, WhatAMethodKeepsClearByItselfStandsBesideItsPlace) {
  const Catalog methods = builtin_avoiders();
  EXPECT_EQ(margins_of({.label = "orca3d", .avoider = "orca3d"}, methods), "");
  EXPECT_EQ(
      margins_of({.label = "f", .avoider = "{algorithm: direct+safety_filter, margin_m: 0.8}"}, methods),
      "safety_filter margin_m 0.8");
  EXPECT_EQ(margins_of({.label = "a", .avoider = "avoa+trackable"}, methods),
            "avoa margin_m 0.25; trackable margin_m 0.3, shown_margin_m 0.4");

  const std::vector<ExamRun> runs = sample();
  const nlohmann::json page =
      exam_page(exam_table(runs, order), {.families = {},
                                          .conditions = {},
                                          .absences = {},
                                          .decision_times = {},
                                          .margins = {{{"cubes", "careful"}, "margin_m 0.8"}}});
  const auto& sections = page["sections"];
  const auto placings = std::ranges::find(sections, "placings", [](const auto& s) { return s["id"]; });
  const nlohmann::json row = (*placings)["blocks"][0]["rows"][0];
  EXPECT_EQ(row["method"], "careful");
  EXPECT_EQ(row["adds"], "adds margin_m 0.8");
}

TEST(ExamPage, WhoIsOnTheFrontIsCalledAsEverywhere) {
  const std::vector<ExamRun> runs = sample();
  const std::vector<ExamCondition> conditions{{.name = "known", .meaning = "m"}};
  const nlohmann::json page =
      exam_page(exam_table(runs, order),
                {.families = {}, .conditions = conditions, .absences = {}, .decision_times = {}});
  const nlohmann::json front = page["sections"][2]["blocks"][0]["blocks"][0];
  EXPECT_EQ(front["front"].dump(), R"(["careful","bold"])");
  EXPECT_EQ(front["series"][0]["label"], "careful");
}

ExamReference stored() {
  return {.epoch = results_epoch, .maker = "fairway 1", .grounds = {{"cubes", "abc"}}, .runs = sample()};
}

TEST(ExamReference, ComesBackToTheBit) {
  const std::string text = reference_text(stored());
  const ExamReference back = parse_reference(text, "r.csv");
  EXPECT_EQ(back.maker, "fairway 1");
  EXPECT_EQ(back.grounds.at("cubes"), "abc");
  ASSERT_EQ(back.runs.size(), stored().runs.size());
  EXPECT_TRUE(std::isnan(back.runs[0].outcome.energy_j));
  EXPECT_EQ(reference_text(back), text);
}

TEST(ExamReference, OfAnotherEpochOrOtherBytesIsRefused) {
  ExamReference other = stored();
  other.epoch = results_epoch - 1;
  EXPECT_NE(refusal_by([&] {
              parse_reference(reference_text(other), "r.csv");
            }).find("r.csv:2:1: is of the results epoch " + std::to_string(results_epoch - 1)),
            std::string::npos);
  std::string text = reference_text(stored());
  text[text.size() - 2] = text[text.size() - 2] == '5' ? '6' : '5';
  EXPECT_NE(refusal_by([&] { parse_reference(text, "r.csv"); }).find("not the one that its digest is of"),
            std::string::npos);
  EXPECT_EQ(refusal_by([&] { parse_reference("a,b\n", "r.csv"); }),
            "r.csv:1:1: not stored results of an exam");
}

TEST(ExamRunOutcome, NumbersHaveSixDigitsAndTheWorstInstantIsKept) {
  Scenario scenario;
  scenario.exam.safety_distance_m = 3.0;
  scenario.vehicles.resize(3);
  scenario.vehicles[2].radius_m = 2.0;
  const std::vector<Measure> measures{
      {.quantity = "pair_collision_count", .value = 0.0},
      {.quantity = "min_separation_m", .value = 3.5, .occasion = {.vehicle = 1, .other = 0, .time = 7.0}},
      {.quantity = "arrived_ratio", .value = 1.0},
      {.quantity = "footprint_clearance_m", .vehicle = 2, .value = -0.75, .occasion = {.time = 9.0}},
      {.quantity = "navigation_time_s", .vehicle = 0, .value = 100.0 / 3.0},
      {.quantity = "navigation_time_s", .vehicle = 1, .value = 100.0 / 3.0}};
  const ExamOutcome found = exam_outcome(measures, scenario);
  EXPECT_FALSE(found.is_safe());
  EXPECT_EQ(found.time_s, 33.3333);
  EXPECT_EQ(found.clearance_m, -0.25);
  EXPECT_EQ(found.worst_vehicle, 2.0);
  EXPECT_EQ(found.worst_time_s, 9.0);
  const ExamOutcome again = outcome_in(measures_of(found));
  EXPECT_EQ(again.time_s, found.time_s);
  EXPECT_EQ(again.arrived_ratio, 1.0);
}

}  // namespace
}  // namespace fairway
