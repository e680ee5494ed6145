// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/page_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace fairway::page {
namespace {

using nlohmann::json;

std::vector<std::string> keys_of(const json& table) {
  std::vector<std::string> keys;
  for (const json& column : table["columns"]) keys.push_back(column["key"]);
  return keys;
}

TEST(ComparisonTable, HasColumnsForWhatTellsRowsApart) {
  const StudyOptions options;
  const RunIndex none{options, {}};
  std::vector<StudyRow> rows(2, {.cell = "head_on", .method = "rvo", .mode = "fit", .quantity = "time_s"});
  EXPECT_EQ(comparison_table("", rows, none)["filter"].dump(), R"(["case","method","quantity"])");

  rows[1].mode = "other";
  EXPECT_EQ(comparison_table("", rows, none)["filter"].dump(), R"(["case","method","mode","quantity"])");

  rows[0].params = {{"told_m", 3.0}};
  rows[1].params = {{"told_m", 6.0}, {"way", true}};
  const json table = comparison_table("", rows, none);
  EXPECT_EQ(table["filter"].dump(), R"(["case","method","mode","params","quantity"])");
  EXPECT_EQ(table["rows"][0]["params"], "told_m 3");
  EXPECT_EQ(table["rows"][1]["params"], "told_m 6, way");
}

TEST(ComparisonTable, OneRunHasNoInterval) {
  const StudyOptions options;
  const RunIndex none{options, {}};
  std::vector<StudyRow> rows(2, {.measured = 5.0, .low = 5.0, .high = 5.0, .runs = 1});
  const std::vector<std::string> keys = keys_of(comparison_table("", rows, none));
  EXPECT_EQ(std::ranges::count(keys, "low"), 0);

  rows[1].low = 4.0;
  rows[1].runs = 2;
  const json table = comparison_table("", rows, none);
  EXPECT_TRUE(table["rows"][0]["low"].is_null() && table["rows"][0]["high"].is_null());
  EXPECT_EQ(table["rows"][1]["low"], 4.0);
}

}  // namespace
}  // namespace fairway::page
