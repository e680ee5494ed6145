// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "fairway/experiment/compare.hpp"

namespace fairway {
namespace {

using testing::HasSubstr;

RunRecord timed(const std::string& method, std::uint64_t seed, double time) {
  return {.spec = {method + std::to_string(seed), {{"case", "bay"}, {"method", method}}, seed, {}},
          .measures = {{"makespan_s", Measure::fleet, time}},
          .wall_s = 0.0,
          .failure = {}};
}

std::vector<RunRecord> five_runs() {
  RunRecord failed = timed("orca3d", 3, 0.0);
  failed.measures.clear();
  failed.failure = "diverged";
  return {timed("apf", 1, 100), timed("apf", 2, 102), timed("orca3d", 1, 90), timed("orca3d", 2, 92), failed};
}

TEST(ComparePrintTest, TableIsAligned) {
  const std::string text = table_text(compare(five_runs()));
  EXPECT_EQ(text.substr(0, text.find("Note:")),
            "case=bay\n"
            "method  quantity    runs  left out  mean            95 %  median\n"
            "apf     makespan_s     2         0   101  [88.29, 113.7]     101\n"
            "orca3d  makespan_s     2         1    91  [78.29, 103.7]      91\n"
            "\n"
            "case=bay: orca3d less apf\n"
            "difference  pairs  mean        95 %  median  95 %      p   Holm  effect\n"
            "makespan_s      2   -10  [-10, -10]     -10     -  0.346  0.346   -1.00\n"
            "\n"
            "method  failed  runs        of\n"
            "orca3d       1     3  case=bay\n"
            "\n");
  EXPECT_THAT(text, HasSubstr("Note: 1 run of case=bay method=orca3d failed"));
  EXPECT_THAT(text, HasSubstr("p is adjusted by Holm over 1"));
}

TEST(ComparePrintTest, NoLineIsLongerThanATerminalHasColumns) {
  std::vector<RunRecord> records;
  for (std::uint64_t seed = 1; seed < 9; ++seed) {
    for (const std::string method : {"orca3d+stop_and_wait", "direct+safety_filter"}) {
      RunRecord record = timed(method, seed, 600.0);
      const auto s = static_cast<double>(seed * method.size());
      record.measures = {{"footprint_clearance_m", 0, -1234567.0 * s * s},
                         {"pair_collision_count", Measure::fleet, s},
                         {"rms_thruster_power_w", 0, 123456.7 * s * (method.size() % 2 == 0 ? -1.0 : 1.5)},
                         {"makespan_s", Measure::fleet, 123.456 * s},
                         {"arrived_ratio", Measure::fleet, seed > 6 ? 0.5 : 1.0}};
      record.spec.labels.emplace_back("vehicles[*].avoider.crit_dist_m", "12.5");
      record.spec.labels.emplace_back("exam.crit_dist_m", "12.5");
      records.push_back(record);
    }
  }
  const std::string text = table_text(compare(records));
  std::istringstream lines{text};
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120U) << line;
  EXPECT_THAT(text, HasSubstr("arrived\n"));
  EXPECT_THAT(text, HasSubstr("6/8"));
}

TEST(ComparePrintTest, JsonSaysWhatWasTested) {
  const nlohmann::json json = to_json(compare(five_runs()));
  const nlohmann::json& difference = json["means"][1]["difference"];
  EXPECT_EQ(difference["test"], "wilcoxon_signed_rank");
  EXPECT_EQ(difference["exact"], false);  // a tie
  EXPECT_EQ(difference["median"], -10.0);
  EXPECT_TRUE(difference["median_low"].is_null());
  EXPECT_EQ(difference["effect"], -1.0);
  EXPECT_EQ(difference["p"], difference["p_adjusted"]);
  EXPECT_EQ(json["means"][1]["left_out"], 1);
  EXPECT_EQ(json["family"], "Holm over 1 comparison: 1 method x 1 quantity");
  EXPECT_FALSE(json["cells"][0].contains("identical"));
  EXPECT_FALSE(json["means"][0].contains("censored"));
}

}  // namespace
}  // namespace fairway
