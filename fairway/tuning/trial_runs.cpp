// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/trial_runs.hpp"

#include <utility>

namespace fairway {

TrialRuns::TrialRuns(std::string file, RunMaker maker, Store& store, ExecutorOptions options)
    : file_{std::move(file)}, maker_{std::move(maker)}, store_{store}, options_{std::move(options)} {
  for (const RunRecord& record : store_.all())
    known_.emplace(record.spec.key, record.failure.empty() ? outcome_of(record.measures) : failed_outcome());
}

std::vector<Outcomes> TrialRuns::outcomes(const std::vector<CampaignAlgorithm>& methods, const TuningSet& set,
                                          std::size_t first, std::size_t count) {
  const CampaignFile asked{.version = 1,
                           .name = "tuning",
                           .summary = {},
                           .scenarios = set.scenarios,
                           .algorithms = methods,
                           .grid = {},
                           .zip = {},
                           .first_seed = set.first_seed + first,
                           .seed_count = static_cast<std::uint32_t>(count),
                           .quantities = {}};
  const Campaign campaign = expanded(asked, file_, maker_.check, options_.jobs, maker_.own);
  std::vector<Outcome> made(campaign.specs.size(), failed_outcome());
  const auto make = [&](std::size_t i) {
    std::vector<Measure> measures = maker_.simulate(campaign.scenario_of(i));
    made[i] = outcome_of(measures);
    return measures;
  };
  if (run_missing(campaign.specs, make, store_, options_).stopped) throw RunAbandoned{};
  for (std::size_t i = 0; i < campaign.specs.size(); ++i) known_.try_emplace(campaign.specs[i].key, made[i]);

  // cells are a scenario after the other and in it a method after the other, under all seeds each
  const std::size_t scenarios = set.scenarios.size();
  std::vector<Outcomes> outcomes(methods.size(), Outcomes(count * scenarios));
  for (std::size_t i = 0; i < campaign.specs.size(); ++i) {
    const std::size_t cell = i / count, seed = i % count;
    outcomes[cell % methods.size()][seed * scenarios + cell / methods.size()] =
        known_.at(campaign.specs[i].key);
  }
  return outcomes;
}

}  // namespace fairway
