// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "fairway/experiment/campaign.hpp"
#include "fairway/tuning/companions.hpp"
#include "fairway/tuning/score.hpp"
#include "fairway/tuning/tuning_file.hpp"

namespace fairway {

/// What a program offers to make runs with.
struct RunMaker {
  CheckScenario check;
  OwnMethods own;
  Simulate simulate;
};

/// As a campaign: methods on `count` seeds of a set from the one with index `first` on.
CampaignFile campaign_on(const TuningSet& set, const std::vector<CampaignAlgorithm>& methods,
                         std::size_t first, std::size_t count);

/// Makes the runs that are asked for, and no run twice: what the store has from another time is not made
/// again, so that a search that is repeated goes the same way without them.
class TrialRuns {
 public:
  /// `file` is that of the specification, from whose folder scenarios are looked for.
  TrialRuns(std::string file, RunMaker maker, Store& store, ExecutorOptions options);

  /// The same, with others who make the rest of the runs. `wait_for` is told, now and then, of a file in
  /// which runs are still missing that this search cannot go on without.
  TrialRuns(std::string file, RunMaker maker, Companions& companions, ExecutorOptions options,
            std::function<void(const std::string& file)> wait_for);

  /// Of each method, its outcomes under `count` seeds of `set` from the one with index `first` on, in blocks.
  /// Throws RunAbandoned if stopped; what was made is stored.
  std::vector<Outcomes> outcomes(const std::vector<CampaignAlgorithm>& methods, const TuningSet& set,
                                 std::size_t first, std::size_t count);

 private:
  void learn(std::span<const RunRecord> records);
  void make(const Campaign& campaign);
  void wait_for_others(const Campaign& campaign);

  std::string file_;
  RunMaker maker_;
  Store& store_;
  ExecutorOptions options_;
  Companions* companions_{nullptr};  ///< null for a search that makes all of its runs
  std::function<void(const std::string&)> wait_for_;
  std::unordered_map<std::string, Outcome> known_;  ///< by the runs' keys
};

}  // namespace fairway
