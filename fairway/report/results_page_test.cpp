// SPDX-License-Identifier: Apache-2.0
#include "fairway/report/results_page.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

json block_of(const json& page, std::size_t section) { return page["sections"][section]["blocks"][0]; }

TEST(ResultsPage, BoxesAndRowsLeadToTheRunsOfTheirCell) {
  const json page = results_page(four_runs(), "store", "method", "fairway report store");
  EXPECT_EQ(page["runs"].dump(),
            R"([{"command":"fairway run a.yaml --seed ","label":"case=cube method=apf","seeds":[1,2]},)"
            R"({"command":"","label":"case=cube method=orca3d","seeds":[1,2]}])");

  const json chart = block_of(page, 1)["blocks"][0];
  ASSERT_EQ(chart["title"], "navigation_time_s");
  const json orca = chart["series"][1]["boxes"][0];
  EXPECT_EQ(orca["runs"].dump(), "[[2,3]]");
  EXPECT_EQ(orca["values"].dump(), "[21.0,23.0,22.0,24.0]");  // of both vehicles of each run

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
  records[2].measures[0].value = std::nan("");
  const json chart = block_of(results_page(records, "store", "method", ""), 1)["blocks"][0];
  const json orca = chart["series"][1]["boxes"][0];
  EXPECT_EQ(orca["values"].dump(), "[null,23.0,22.0,24.0]");
  EXPECT_EQ(orca["count"], 3);
}

}  // namespace
}  // namespace fairway
