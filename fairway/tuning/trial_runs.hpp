// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "fairway/experiment/campaign.hpp"
#include "fairway/tuning/score.hpp"
#include "fairway/tuning/tuning_file.hpp"

namespace fairway {

/// What a program offers to make runs with.
struct RunMaker {
  CheckScenario check;
  OwnMethods own;
  Simulate simulate;
};

/// Makes the runs that are asked for, and no run twice: what the store has from another time is not made
/// again, so that a search that is repeated goes the same way without them.
class TrialRuns {
 public:
  /// `file` is that of the specification, from whose folder scenarios are looked for.
  TrialRuns(std::string file, RunMaker maker, Store& store, ExecutorOptions options);

  /// Of each method, its outcomes under `count` seeds of `set` from the one with index `first` on, in blocks.
  /// Throws RunAbandoned if stopped; what was made is stored.
  std::vector<Outcomes> outcomes(const std::vector<CampaignAlgorithm>& methods, const TuningSet& set,
                                 std::size_t first, std::size_t count);

 private:
  std::string file_;
  RunMaker maker_;
  Store& store_;
  ExecutorOptions options_;
  std::unordered_map<std::string, Outcome> known_;  ///< by the runs' keys
};

}  // namespace fairway
