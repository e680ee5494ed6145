// SPDX-License-Identifier: Apache-2.0
#include "fairway/report/results_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fairway {
namespace {

using nlohmann::json;

/// Two methods, two seeds, two vehicles.
std::vector<RunRecord> four_runs() {
  std::vector<RunRecord> records;
  for (const std::string method : {"apf", "orca3d"}) {
    for (const std::uint64_t seed : {1U, 2U}) {
      const double time = (method == "apf" ? 10.0 : 20.0) + static_cast<double>(seed);
      const std::string command = method == "apf" ? "fairway run a.yaml --seed " : "";
      records.push_back(
          {.spec = {method + std::to_string(seed), {{"case", "cube"}, {"method", method}}, seed, command},
           .measures = {{"navigation_time_s", 0, time},
                        {"navigation_time_s", 1, time + 2.0},
                        {"arrived_ratio", Measure::fleet, 1.0}}});
    }
  }
  return records;
}

json page_of(std::vector<RunRecord> records, const CompareOptions& options = {}) {
  return results_page({.origin = {.campaign = "duel", .summary = "which is quicker", .version = "1.2"},
                       .records = std::move(records)},
                      options, "fairway report store");
}

json block_of(const json& page, std::size_t section) { return page["sections"][section]["blocks"][0]; }

const json& section_of(const json& page, const std::string& id) {
  for (const json& section : page["sections"]) {
    if (section["id"] == id) return section;
  }
  throw std::out_of_range(id);
}

TEST(ResultsPage, BoxesAndRowsLeadToTheRunsOfTheirCell) {
  const json page = page_of(four_runs());
  EXPECT_EQ(page["runs"].dump(),
            R"([{"command":"fairway run a.yaml --seed ","label":"case=cube method=apf","seeds":[1,2]},)"
            R"({"command":"","label":"case=cube method=orca3d","seeds":[1,2]}])");

  const json chart = block_of(page, 1)["blocks"][0];
  ASSERT_EQ(chart["title"], "navigation_time_s");
  const json orca = chart["series"][1]["boxes"][0];
  EXPECT_EQ(orca["runs"].dump(), "[[2,3]]");
  EXPECT_EQ(orca["values"].dump(), "[22.0,23.0]");  // one value a run, however many vehicles
  EXPECT_EQ(orca["count"], 2);

  int rows = 0;
  const json means = block_of(page, 2);  // a name of its own: part of a temporary would not outlive it
  for (const json& row : means["rows"]) {
    if (row["quantity"] != "navigation_time_s") continue;
    ++rows;
    EXPECT_EQ(row["$runs"].dump(), row["candidate"] == "apf" ? "[[0,1]]" : "[[2,3]]");
    EXPECT_EQ(row["$values"].dump(), row["candidate"] == "apf" ? "[12.0,13.0]" : "[22.0,23.0]");
  }
  EXPECT_EQ(rows, 2);
  const json rate = block_of(page, 0)["rows"][0];
  EXPECT_TRUE(rate.contains("$runs"));
  EXPECT_FALSE(rate.contains("$values"));
}

TEST(ResultsPage, ARunWithoutAValueKeepsItsPlace) {
  std::vector<RunRecord> records = four_runs();
  records[2].measures[0].value = records[2].measures[1].value = std::nan("");
  const json orca = block_of(page_of(records), 1)["blocks"][0]["series"][1]["boxes"][0];
  EXPECT_EQ(orca["values"].dump(), "[null,23.0]");
  EXPECT_EQ(orca["count"], 1);
}

TEST(ResultsPage, NamesAreThoseOfTheCampaign) {
  std::vector<RunRecord> records = four_runs();
  for (RunRecord& record : records) record.spec.labels.emplace_back("step_s", "0.05");
  const json page = page_of(records);
  EXPECT_EQ(page["title"], "duel");
  EXPECT_EQ(page["subtitle"], "which is quicker");
  const json chart = block_of(page, 1)["blocks"][0];
  EXPECT_EQ(chart["categories"].dump(), R"(["cube"])");
  EXPECT_EQ(chart["category_label"], "case");

  // labels that are the same everywhere tell nothing apart
  std::vector<RunRecord> more = records;
  for (RunRecord& record : more) {
    record.spec.labels.back().second = "0.1";
    record.spec.key += "b";
  }
  records.insert(records.end(), more.begin(), more.end());
  EXPECT_EQ(block_of(page_of(records), 1)["blocks"][0]["categories"].dump(), R"(["0.05","0.1"])");
}

TEST(ResultsPage, AnAxisOverAGridNamesAllThatItVaries) {
  std::vector<RunRecord> records;
  for (const std::string range : {"20", "40"}) {
    for (const std::string speed : {"1", "2"}) {
      for (RunRecord record : four_runs()) {
        record.spec.labels.emplace_back("perception.sonar.range_m", range);
        record.spec.labels.emplace_back("speed_mps", speed);
        record.spec.key += range + speed;
        records.push_back(record);
      }
    }
  }
  const json chart = block_of(page_of(records), 1)["blocks"][0];
  EXPECT_EQ(chart["category_label"], "range_m, speed_mps");
  EXPECT_EQ(chart["categories"][0], "perception.sonar.range_m 20, speed_mps 1");
}

TEST(ResultsPage, TheBaselineIsTheOneAskedForOrTheFirstOfTheCampaign) {
  EXPECT_EQ(page_of(four_runs())["facts"][2]["value"], "apf");
  EXPECT_EQ(page_of(four_runs(), {.baseline = "orca3d"})["facts"][2]["value"], "orca3d");
  const json page = results_page(
      {.origin = {.campaign = "duel", .order = {{"method", {"orca3d", "apf"}}}}, .records = four_runs()}, {},
      "");
  EXPECT_EQ(page["facts"][2]["value"], "orca3d");
  EXPECT_EQ(block_of(page, 1)["blocks"][0]["series"][0]["label"], "orca3d");
}

TEST(ResultsPage, TimesThatWereCutOffHaveCurvesAndNoBox) {
  std::vector<RunRecord> records = four_runs();
  for (RunRecord& record : records)
    record.measures = {{"makespan_s", Measure::fleet, record.measures[0].value + 1.0},
                       {"arrived_ratio", Measure::fleet, 1.0}};
  records[3].measures.back().value = 0.5;
  const json page = page_of(records);
  const json chart = block_of(page, 1)["blocks"][0];
  EXPECT_FALSE(chart["series"][0]["boxes"][0].is_null());
  EXPECT_TRUE(chart["series"][1]["boxes"][0].is_null());
  const json& cut = section_of(page, "cut-off");
  const json curve = cut["blocks"][0]["blocks"][0]["series"][1];
  EXPECT_EQ(curve["label"], "orca3d");
  const auto x = curve["x"].get<std::vector<double>>();
  const auto down = static_cast<std::size_t>(std::ranges::find(x, 22.0) - x.begin());
  EXPECT_EQ(x.at(down + 1), 22.0);
  EXPECT_EQ(curve["y"][down], 1.0);
  EXPECT_EQ(curve["y"][down + 1], 0.5);
  EXPECT_EQ(x.back(), 23.0) << "where the run was cut off";
  EXPECT_EQ(curve["y"].back(), 0.5);
  EXPECT_EQ(cut["blocks"][1]["rows"][1]["arrived"], "1 of 2");
  const json table = block_of(page, 2);
  for (const json& row : table["rows"]) {
    if (row["quantity"] != "makespan_s") continue;
    EXPECT_EQ(row["mean"].is_null(), row["candidate"] == "orca3d");
  }
}

TEST(ResultsPage, SaysItsMethodsInSentencesForAPaper) {
  std::vector<RunRecord> records = four_runs();
  records[3].measures.clear();
  records[3].failure = "diverged";
  const json page = page_of(records);
  std::string text;
  for (const json& paragraph : section_of(page, "methods")["paragraphs"])
    text += paragraph.get<std::string>() + "\n";
  for (const char* said : {"2 values of method (apf, orca3d)", "case (cube)", "the 2 seeds 1 to 2",
                           "4 runs, of which 1 failed", "Wilson", "Wilcoxon signed rank test", "McNemar",
                           "Newcombe", "Holm over 3 comparisons: 1 method x (2 quantities and 1 rate)",
                           "Simulated with fairway 1.2", "Failed runs count as failures"}) {
    EXPECT_NE(text.find(said), std::string::npos) << said << " is not in: " << text;
  }
  EXPECT_EQ(page["sections"][0]["blocks"][1]["tone"], "warning");
}

TEST(ResultsPage, IdenticalRunsAreOneInEveryBox) {
  std::vector<RunRecord> records = four_runs();
  records[1].measures = records[0].measures;
  records[0].measures[0].value = records[1].measures[0].value = 11.5;
  const json apf = block_of(page_of(records), 1)["blocks"][0]["series"][0]["boxes"][0];
  EXPECT_EQ(apf["count"], 1);
  EXPECT_EQ(apf["runs"].dump(), "[0]");
}

}  // namespace
}  // namespace fairway
