// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "fairway/experiment/campaign_cells.hpp"
#include "fairway/experiment/campaign_file.hpp"
#include "fairway/experiment/executor.hpp"
#include "fairway/experiment/run.hpp"
#include "fairway/experiment/shard.hpp"
#include "fairway/experiment/store.hpp"
#include "fairway/metrics/measure.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway {

struct CampaignScenario {
  /// Throws InputError for a text that is not a scenario's.
  CampaignScenario(std::string written_in, std::string as_written)
      : file{std::move(written_in)}, text{std::move(as_written)}, document{text, file} {}

  std::string file;
  std::string text;  ///< as it was when the campaign was loaded: all runs are of this one version
  ScenarioDocument document;
};

/// Everything that is to be run, or a shard of it.
struct Campaign {
  std::string name;
  std::string summary;
  std::string file;
  std::vector<CampaignScenario> scenarios;
  std::vector<CampaignCell> cells;
  std::uint64_t first_seed{1};
  std::size_t seed_count{};
  Shard shard;                          ///< which the specs are of
  std::vector<RunSpec> specs;           ///< cell by cell, by seed
  std::vector<std::size_t> cells_of;    ///< of each of the specs, its cell
  std::vector<std::string> quantities;  ///< to print; empty = all
  std::string digest;                   ///< of what is to be run, shards apart: equal for equal campaigns

  std::size_t run_count() const { return cells.size() * seed_count; }  ///< of all shards
  const CampaignCell& cell_of(std::size_t run) const { return cells[cells_of[run]]; }

  /// The concrete case of specs[run]. Safe to call from several threads.
  Scenario scenario_of(std::size_t run) const;
};

/// Checks what the scenario's own loader cannot: names of models and algorithms. Throws InputError.
using CheckScenario = std::function<void(const Scenario&)>;

/// What a program has besides fairway's own methods and vehicles.
struct OwnMethods {
  /// The version of those in a scenario, a text that changes whenever they may decide otherwise than before.
  /// It is part of the run's key, so that no stored run of another version is taken for this one. Empty:
  /// there are none of them. Safe to call from several threads. Throws InputError where there is no telling.
  std::function<std::string(const Scenario&)> version;
  std::string program;  ///< that makes such a run alone, as `fairway` makes the others; empty: none does
};

/// Makes one run.
using Simulate = std::function<std::vector<Measure>(const Scenario&)>;

/// Told, now and then and in the thread that asked, how many of so many runs are listed. What it throws ends
/// the listing.
using WatchListing = std::function<void(std::size_t listed, std::size_t of)>;

inline constexpr std::size_t max_campaign_runs = 10'000'000;

/// Reads and expands a campaign. Every scenario is resolved for every seed, on `jobs` threads (0 = all),
/// and `check` is asked once per cell, so that a mistake is reported before anything is run. A run's
/// key is a digest of its resolved scenario, labels, algorithm and results_epoch: a comment or a default
/// written out changes nothing, a changed number makes another run, and so does another version of a method
/// that is the program's own. Of a shard only its own runs are resolved, and the first of every cell, whose
/// expected_cost() they are dealt by: file and shard alone decide which runs it has. Throws InputError with
/// file, line, column and path.
Campaign load_campaign(const std::string& file, const CheckScenario& check = {}, unsigned jobs = 1,
                       const OwnMethods& own = {}, const Shard& shard = {}, const WatchListing& watch = {});

/// Of the whole campaign the first run of every cell alone.
Campaign load_cells(const std::string& file, const CheckScenario& check = {}, unsigned jobs = 1,
                    const OwnMethods& own = {});

/// The scenario of a run that need not be among the campaign's specs. Safe to call from several threads.
Scenario scenario_of(const Campaign& campaign, std::size_t cell, std::uint64_t seed);

/// The same from text; scenarios are looked for relative to `file`.
Campaign parse_campaign(std::string_view yaml, const std::string& file, const CheckScenario& check = {},
                        unsigned jobs = 1, const OwnMethods& own = {}, const Shard& shard = {},
                        const WatchListing& watch = {});

/// Writes down key and command of the runs that are listed in `specs` and `cells_of`, on `jobs` threads, and
/// asks `check` of the first of every cell; those of a cell stand together. For whoever lists cells and runs
/// that no file says. Throws InputError.
void resolve_runs(Campaign& campaign, const CheckScenario& check, unsigned jobs, const OwnMethods& own,
                  const WatchListing& watch = {});

/// A scenario as text, without what is only there for people or for tests: equal texts are the same run.
std::string canonical_text(Scenario scenario);

/// Leaves only the runs of which `is_wanted` holds.
void keep_runs(Campaign& campaign, const std::function<bool(const RunSpec&)>& is_wanted);

/// How many runs each of `count` shards of a whole campaign has, and what they cost together
/// (expected_cost()).
struct ShardPlan {
  std::vector<std::size_t> runs;
  std::vector<double> costs;
};
ShardPlan plan_of(const Campaign& campaign, std::uint32_t count, unsigned jobs = 1);

/// The same from what such a text says.
Campaign expanded(const CampaignFile& written, const std::string& file, const CheckScenario& check = {},
                  unsigned jobs = 1, const OwnMethods& own = {}, const Shard& shard = {},
                  const WatchListing& watch = {});

/// Its name, summary and the order of its labels' values. values_of(origin.order, "method") is what compare()
/// takes as CompareOptions::order.
Origin origin_of(const Campaign& campaign);

/// Makes the runs that `store` does not have, and notes there whose they are. Throws InputError for a store
/// that was begun under another results epoch.
ExecutorReport run_campaign(const Campaign& campaign, const Simulate& simulate, Store& store,
                            const ExecutorOptions& options = {});

/// The stored runs of this campaign, as it is now; those of older versions of its scenarios are left out.
std::vector<RunRecord> records_of(const Campaign& campaign, const Store& store);

}  // namespace fairway
