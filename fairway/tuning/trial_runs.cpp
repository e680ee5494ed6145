// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/trial_runs.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace fairway {

CampaignFile campaign_on(const TuningSet& set, const std::vector<CampaignAlgorithm>& methods,
                         std::size_t first, std::size_t count) {
  return {.version = 1,
          .name = "tuning",
          .summary = {},
          .scenarios = set.scenarios,
          .set = set.set,
          .algorithms = methods,
          .grid = {},
          .zip = {},
          .first_seed = set.first_seed + first,
          .seed_count = static_cast<std::uint32_t>(count),
          .quantities = {}};
}

TrialRuns::TrialRuns(std::string file, RunMaker maker, Store& store, ExecutorOptions options)
    : file_{std::move(file)}, maker_{std::move(maker)}, store_{store}, options_{std::move(options)} {
  learn(store_.all());
}

TrialRuns::TrialRuns(std::string file, RunMaker maker, Companions& companions, ExecutorOptions options,
                     std::function<void(const std::string& file)> wait_for)
    : TrialRuns{std::move(file), std::move(maker), companions.store(), std::move(options)} {
  companions_ = &companions;
  wait_for_ = std::move(wait_for);
  learn(companions_->news());
}

void TrialRuns::learn(std::span<const RunRecord> records) {
  for (const RunRecord& record : records)
    known_.try_emplace(record.spec.key,
                       record.failure.empty() ? outcome_of(record.measures) : failed_outcome());
}

/// Those that nobody has made, of which each companion takes its part.
void TrialRuns::make(const Campaign& campaign) {
  std::vector<RunSpec> specs;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < campaign.specs.size(); ++i) {
    if (known_.contains(campaign.specs[i].key) || (companions_ != nullptr && !companions_->is_mine(i)))
      continue;
    specs.push_back(campaign.specs[i]);
    numbers.push_back(i);
  }
  std::vector<Outcome> made(specs.size(), failed_outcome());
  const auto make_one = [&](std::size_t i) {
    std::vector<Measure> measures = maker_.simulate(campaign.scenario_of(numbers[i]));
    made[i] = outcome_of(measures);
    return measures;
  };
  const bool stopped = run_missing(specs, make_one, store_, options_).stopped;
  if (companions_ != nullptr && !specs.empty()) companions_->publish();
  if (stopped) throw RunAbandoned{};
  // whether a run failed is for the store to say: a search that is repeated goes by that
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const bool failed = store_.status(specs[i].key) == Store::Status::failed;
    known_.try_emplace(specs[i].key, failed ? failed_outcome() : made[i]);
  }
}

void TrialRuns::wait_for_others(const Campaign& campaign) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds often{100};
  constexpr std::chrono::seconds now_and_then{60};
  Clock::time_point told = Clock::now();
  const auto is_known = [&](const RunSpec& spec) { return known_.contains(spec.key); };
  for (;;) {
    learn(companions_->news());
    const auto unknown = std::ranges::find_if_not(campaign.specs, is_known);
    if (unknown == campaign.specs.end()) return;
    if (options_.stop != nullptr && *options_.stop) throw RunAbandoned{};
    if (wait_for_ && Clock::now() - told > now_and_then) {
      wait_for_(companions_->file_of(
          companions_->part_of(static_cast<std::size_t>(unknown - campaign.specs.begin()))));
      told = Clock::now();
    }
    std::this_thread::sleep_for(often);
  }
}

std::vector<Outcomes> TrialRuns::outcomes(const std::vector<CampaignAlgorithm>& methods, const TuningSet& set,
                                          std::size_t first, std::size_t count) {
  const Campaign campaign =
      expanded(campaign_on(set, methods, first, count), file_, maker_.check, options_.jobs, maker_.own);
  make(campaign);
  if (companions_ != nullptr) wait_for_others(campaign);

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
