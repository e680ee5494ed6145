// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/campaign_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/experiment/campaign.hpp"

namespace fairway {
namespace {

TEST(PublishedCampaignsTest, LoadWithTheirScenarios) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FAIRWAY_SOURCE_DIR "/campaigns")) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string file = entry.path().string();
    std::ifstream stream{file};
    const std::string text{std::istreambuf_iterator<char>{stream}, {}};
    const std::string few_seeds = std::regex_replace(text, std::regex{"count: [0-9]+\\}"}, "count: 2}");
    EXPECT_EQ(parse_campaign(few_seeds, file).name, entry.path().stem().string());
    ++files;
  }
  EXPECT_GE(files, 2U);
}

std::string campaign_refusal(const std::string& more, const std::string& name = "c") {
  return refusal_by([&] {
    parse_campaign_file("fairway_campaign: 1\nname: " + name + "\nscenario: s.yaml\n" + more, "c.yaml");
  });
}

TEST(CampaignFileTest, AQuantityThatNoRunMeasuresIsToldWhereItIsWritten) {
  EXPECT_EQ(campaign_refusal("quantities: [makespan_s, navigation_tim_s]\n"),
            "c.yaml:4:26: quantities[1]: no run measures navigation_tim_s; did you mean navigation_time_s?");
  EXPECT_EQ(campaign_refusal("quantities: [makespan_s, energy_j, makespan_s]\n"),
            "c.yaml:4:36: quantities[2]: makespan_s is given twice");
  for (const char* names : {"[makespan_s]", "[all]", "[]"})
    EXPECT_EQ(campaign_refusal("quantities: " + std::string(names) + "\n"), "accepted");
}

TEST(CampaignFileTest, ANameIsOfOneLine) {
  EXPECT_EQ(campaign_refusal("", "\"a\\nb\""),
            "c.yaml:2:7: name: \"a?b\" has a line break or another control character; expected a name");
}

TEST(CampaignSchemaTest, NamesEveryKey) {
  const auto schema = nlohmann::json::parse(campaign_schema());
  for (const char* key :
       {"fairway_campaign", "name", "scenario", "set", "algorithms", "grid", "zip", "seeds", "quantities"}) {
    EXPECT_TRUE(schema["properties"].contains(key)) << key;
  }
  EXPECT_EQ(schema["additionalProperties"], false);
}

}  // namespace
}  // namespace fairway
