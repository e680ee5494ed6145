// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/outcome.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "fairway/cli/testing/program_of.hpp"
#include "fairway/core/testing/temporary_folder.hpp"
#include "fairway/record/recording.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Thrusters of a ship on a boat of 1 kg in water that does not brake it, and a tracker with far too much
/// gain.
const std::string breaking = R"(fairway: 1
name: breaking
step_s: 0.02
duration_s: 10
vehicles:
  - name: feather
    model: {name: zarco, mass_kg: 1, thrust_ahead_n: 1e5, linear_damping_surge_kgps: 0, quadratic_damping_surge_kgpm: 0}
    avoider: {algorithm: rrt_star, kp_x_npm: 1e6, kd_x_npmps: 1e6}
    tracking: raw
    start: {position_m: [0, 0, 0]}
    mission: [{transit: {position_m: [5000, 0, 0], speed_mps: 100}}]
expect: {collision_count: 0, makespan_s: {max: 100}}
)";

const Catalogs catalogs = builtin_catalogs();
const Program program = program_of(catalogs);

TEST(Outcome, ARunThatBrokeKeepsNoExpectationAndHasNoMeasures) {
  const TemporaryFolder folder;
  const Scenario scenario = parse_scenario(breaking, "f.yaml");
  const std::string file = folder.file("broken.mcap");
  const RunOutcome outcome = run_scenario(scenario, {.file = file}, program);
  ASSERT_TRUE(outcome.complete);
  ASSERT_TRUE(outcome.divergence);
  EXPECT_TRUE(outcome.measures.empty());
  const std::vector<Judgement> judgements = judge(scenario, outcome.measures);
  EXPECT_EQ(judgements.size(), 2U);
  EXPECT_TRUE(std::ranges::none_of(judgements, &Judgement::kept));

  const nlohmann::json document = document_of(scenario, outcome, judgements);
  EXPECT_EQ(document["outcome"], "diverged");
  EXPECT_EQ(document["diverged"]["vehicle"], "feather");
  EXPECT_EQ(document["diverged"]["time_s"], outcome.divergence->time);
  EXPECT_EQ(document["diverged"]["why"], "its speed is beyond 200 m/s");
  EXPECT_FALSE(document.contains("fleet"));

  std::ostringstream text;
  print(scenario, outcome, judgements, text);
  const std::string line = divergence_text(scenario, outcome);
  EXPECT_THAT(line, HasSubstr("diverged: feather at "));
  EXPECT_THAT(text.str(), HasSubstr("  " + line + "\n"));
  EXPECT_THAT(text.str(), Not(HasSubstr("kept    ")));

  // recorded up to there, and the file says how it ended
  const Recording recording = Recording::read(file);
  EXPECT_EQ(recording.divergence(), line);
  ASSERT_EQ(static_cast<std::int64_t>(recording.size()), count(outcome.divergence->tick));
  const Frame last = recording.frame(recording.size() - 1);
  EXPECT_TRUE(is_finite(last.vehicles[0].state));
}

TEST(Outcome, AWholeRunSaysThatItFinished) {
  const Scenario scenario = parse_scenario(
      "{fairway: 1, name: short, duration_s: 1, vehicles: [{model: kinematic, avoider: direct, start: "
      "{position_m: [0, 0, 5]}}]}",
      "f.yaml");
  const RunOutcome outcome = run_scenario(scenario, {}, program);
  EXPECT_FALSE(outcome.divergence);
  const nlohmann::json document = document_of(scenario, outcome, {});
  EXPECT_EQ(document["outcome"], "finished");
  EXPECT_FALSE(document.contains("diverged"));
  EXPECT_TRUE(document.contains("fleet"));
}

}  // namespace
}  // namespace fairway::cli
