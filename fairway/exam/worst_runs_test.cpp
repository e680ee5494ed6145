// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/worst_runs.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace fairway {
namespace {

ExamRun run_of(std::uint64_t seed, bool safe, double arrived, double clearance) {
  ExamOutcome outcome = failed_exam();
  outcome.safe = safe ? 1.0 : 0.0;
  outcome.arrived_ratio = arrived;
  outcome.clearance_m = clearance;
  return {.family = "cubes",
          .condition = "known",
          .method = "vo",
          .ground = "g",
          .seed = seed,
          .outcome = outcome,
          .command = "fairway run g.yaml --seed "};
}

/// The seed of the worst of these runs; 0 of none.
std::uint64_t worst_seed(const std::vector<ExamRun>& runs) {
  const ExamTable table = exam_table(
      runs, {.families = {"cubes"}, .conditions = {"known"}, .methods = {"vo"}, .baseline = "direct"});
  const std::vector<WorstRun> worst = worst_runs(table);
  return worst.empty() ? 0 : worst.front().run->seed;
}

TEST(WorstRuns, CollisionsComeBeforeWhoDoesNotArriveAndTheseBeforeTheLeastClearance) {
  std::vector<ExamRun> runs{run_of(1, true, 1.0, 0.1), run_of(2, true, 1.0, 0.5)};
  EXPECT_EQ(worst_seed(runs), 1U);
  runs.push_back(run_of(3, true, 0.5, 4.0));
  EXPECT_EQ(worst_seed(runs), 3U);
  runs.push_back(run_of(4, false, 1.0, -0.1));
  runs.push_back(run_of(5, false, 1.0, -0.4));
  EXPECT_EQ(worst_seed(runs), 5U);
}

TEST(WorstRuns, ARunThatBrokeOrThatNobodyCanMakeIsNone) {
  std::vector<ExamRun> runs{run_of(1, false, 0.0, std::numeric_limits<double>::quiet_NaN()),
                            run_of(2, false, 0.0, -1.0)};
  runs.back().command.clear();
  EXPECT_EQ(worst_seed(runs), 0U);
}

}  // namespace
}  // namespace fairway
