// SPDX-License-Identifier: Apache-2.0
// Runs of campaigns/vehicles.yaml, of vehicles that find no way and stand in a current.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>

#include "fairway/experiment/measure_run.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway {
namespace {

/// A run of the campaign `vehicles`.
struct CampaignRun {
  std::string ground, method;
  std::uint64_t seed{};
};

void PrintTo(const CampaignRun& run, std::ostream* out) {
  *out << run.ground << ' ' << run.method << ' ' << run.seed;
}

double measured(const CampaignRun& run, std::string_view quantity) {
  const std::string file = FAIRWAY_SOURCE_DIR "/campaigns/vehicles/" + run.ground + ".yaml";
  const Scenario scenario = load_scenario(file, {{"vehicles[0].avoider", run.method}}, run.seed);
  const auto measures = measure_run(scenario, builtin_catalogs());
  const auto found = std::ranges::find(measures, quantity, &Measure::quantity);
  return found == measures.end() ? std::numeric_limits<double>::quiet_NaN() : found->value;
}

class WhoStandsInACurrent : public testing::TestWithParam<CampaignRun> {};

TEST_P(WhoStandsInACurrent, IsNotSetOnWhatIsNear) {
  EXPECT_GT(measured(GetParam(), "footprint_clearance_m"), 0.0);
}

// Each touched while what came from ahead was not counted as drift before the bow had turned, what was clear
// needed no backup, the side was chosen anew at each decision, by who was lost and had a backup by turns too,
// and nobody went astern.
INSTANTIATE_TEST_SUITE_P(Runs, WhoStandsInACurrent,
                         testing::Values(CampaignRun{"otter_u", "orca2d+trackable", 1216},
                                         CampaignRun{"otter_u", "orca2d+trackable", 90118},
                                         CampaignRun{"otter_u", "hrvo+trackable", 83001},
                                         CampaignRun{"otter_u", "direct+safety_filter", 90767},
                                         CampaignRun{"otter_buoys25", "hrvo+trackable", 1984},
                                         CampaignRun{"otter_buoys25", "direct+safety_filter", 1116},
                                         CampaignRun{"zarco_buoys25", "hard_switching+trackable", 1133},
                                         CampaignRun{"sparus2_u", "hard_switching+trackable", 1001},
                                         CampaignRun{"kinematic_buoys25", "direct+safety_filter", 1294}));

TEST(WhoKeepsToASide, LetsGoOfItWhereAnotherWayRoundIsShorter) {
  EXPECT_EQ(measured({"zarco_buoys25", "hrvo+trackable+way_round", 1024}, "arrived_ratio"), 1.0);
  EXPECT_EQ(measured({"otter_buoys14", "apf+trackable+way_round", 1100}, "arrived_ratio"), 1.0);
}

}  // namespace
}  // namespace fairway
