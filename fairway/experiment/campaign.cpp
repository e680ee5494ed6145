// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/campaign.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <functional>
#include <iterator>
#include <mutex>
#include <optional>
#include <thread>
#include <unordered_set>
#include <utility>

#include "fairway/core/text.hpp"
#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/scenario/value.hpp"

namespace fairway {
namespace {

std::vector<CampaignScenario> load_scenarios(const CampaignFile& written, const std::string& file) {
  std::vector<CampaignScenario> scenarios;
  std::unordered_set<std::string> cases;
  for (const CampaignScenarioFile& scenario : written.scenarios) {
    const auto path = (std::filesystem::path(file).parent_path() / scenario.path).lexically_normal();
    std::optional<std::string> text = yaml::document_in(path.string());
    if (!text) throw InputError(scenario.where, "scenario", path.string() + " cannot be read");
    if (!cases.insert(path.stem().string()).second) {
      throw InputError(scenario.where, "scenario", "a second one named " + path.stem().string());
    }
    scenarios.emplace_back(path.string(), std::move(*text));
  }
  return scenarios;
}

std::vector<std::string> cases_of(const Campaign& campaign) {
  std::vector<std::string> names;
  for (const CampaignScenario& scenario : campaign.scenarios)
    names.push_back(std::filesystem::path(scenario.file).stem().string());
  return names;
}

void refuse_too_many(const CampaignFile& written, const std::string& file) {
  double runs =
      static_cast<double>(written.scenarios.size() * std::max<std::size_t>(1, written.algorithms.size()) *
                          std::max<std::size_t>(1, written.zip.size()));
  runs *= static_cast<double>(written.seed_count);
  for (const CampaignAxis& axis : written.grid) runs *= static_cast<double>(axis.values.size());
  if (runs > static_cast<double>(max_campaign_runs)) {
    throw InputError(file + ": more than " + std::to_string(max_campaign_runs) +
                     " runs; divide it into several campaigns");
  }
}

/// A scenario without what is there for people or for tests, as text. One that stands only under the
/// overrides of its cells counts as it is written.
std::string canonical_text(const CampaignScenario& scenario, std::uint64_t seed) {
  try {
    return canonical_text(scenario.document.scenario({}, seed));
  } catch (const InputError&) {
    return scenario.text;
  }
}

/// Of every cell a digest of all that it is made of but the seed, and the program's own methods: what the
/// scenario says, drawn under one seed, and what is laid over it.
std::vector<std::string> versions_of(const Campaign& campaign) {
  constexpr std::uint64_t one_seed = 1;
  std::vector<std::string> texts;
  for (const CampaignScenario& scenario : campaign.scenarios)
    texts.push_back(canonical_text(scenario, one_seed));
  std::vector<std::string> versions;
  for (const CampaignCell& cell : campaign.cells) {
    Digest digest;
    digest.add(std::to_string(results_epoch)).add(cell.algorithm).add(texts[cell.scenario]);
    for (const auto* part : {&cell.labels, &cell.overrides}) {
      for (const auto& [name, value] : *part) digest.add(name).add(value);
    }
    versions.push_back(digest.hex());
  }
  return versions;
}

/// A digest of all that decides the outcome.
std::string key_of(const CampaignCell& cell, Scenario scenario, const std::string& own_version) {
  Digest digest;
  digest.add(std::to_string(results_epoch)).add(cell.algorithm).add(canonical_text(std::move(scenario)));
  for (const auto& [name, value] : cell.labels) digest.add(name).add(value);
  if (!own_version.empty()) digest.add(own_version);
  return digest.hex();
}

/// `fairway run` with all that the cell sets, up to the seed. What is set anew later is not set before.
std::string command_for(const Campaign& campaign, const CampaignCell& cell, const std::string& program) {
  if (program.empty()) return "";
  std::string command = program + " run " + shell_word(campaign.scenarios[cell.scenario].file);
  for (auto at = cell.overrides.begin(); at != cell.overrides.end(); ++at) {
    const auto& [path, value] = *at;
    if (std::any_of(std::next(at), cell.overrides.end(),
                    [&](const auto& later) { return later.first == path; }))
      continue;
    command += " --set " + shell_word(path + "=" + value);
  }
  return command + " --seed ";
}

/// An error in the algorithm of a cell is told where that is written: of "--set vehicles[*].avoider:
/// vehicles[0].avoider.radius: unknown" the path from the avoider on.
void refuse_algorithm(const CampaignCell& cell, std::string_view error) {
  constexpr std::string_view setting = ".avoider: ", avoider = ".avoider";
  const std::size_t end = error.find(setting);
  if (cell.place.where.file.empty() || !error.starts_with(yaml::override_prefix) || end == error.npos) return;
  const std::size_t begin = error.find(avoider, end + setting.size());
  if (begin == error.npos) return;
  std::string said = cell.place.path + std::string(error.substr(begin + avoider.size()));
  said.erase(0, said.find_first_not_of(".: "));
  throw InputError(cell.place.where.prefix() + said);
}

/// What `make` makes of a run; an error says which run it is of.
template <class Make>
auto of_run(const Campaign& campaign, const CampaignCell& cell, std::uint64_t seed, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    refuse_algorithm(cell, error.what());
    throw InputError(campaign.file + ": in " + labels_text(cell.labels) + " seed=" + std::to_string(seed) +
                     ": " + error.what());
  }
}

/// work(0) ... work(count - 1), on several threads. Of several exceptions, that of the least index is thrown.
void for_each_index(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work) {
  const std::size_t wanted = jobs > 0 ? jobs : std::max(1U, std::thread::hardware_concurrency());
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> end{count};
  std::exception_ptr first;
  std::mutex mutex;
  const auto take = [&] {
    // after an error only what comes before it still matters
    for (std::size_t i = next.fetch_add(1); i < end; i = next.fetch_add(1)) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard guard{mutex};
        if (i >= end) continue;
        end = i;
        first = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> pool;
    for (std::size_t t = 1; t < std::min(wanted, count); ++t) pool.emplace_back(take);
    take();
  }
  if (first) std::rethrow_exception(first);
}

/// Which of `count` shards each run of the whole campaign is of, by what the first run of each cell may cost.
std::vector<std::uint32_t> dealt_runs(const Campaign& campaign, std::uint32_t count, unsigned jobs,
                                      std::vector<double>& costs) {
  costs.assign(campaign.cells.size(), 0.0);
  for_each_index(campaign.cells.size(), jobs, [&](std::size_t i) {
    const CampaignCell& cell = campaign.cells[i];
    costs[i] = of_run(campaign, cell, campaign.first_seed,
                      [&] { return expected_cost(scenario_of(campaign, i, campaign.first_seed)); });
  });
  return dealt(costs, campaign.seed_count, count);
}

/// The runs of the campaign's shard.
void list_runs(Campaign& campaign, unsigned jobs) {
  std::vector<double> costs;
  const std::vector<std::uint32_t> shards = campaign.shard.is_all()
                                                ? std::vector<std::uint32_t>{}
                                                : dealt_runs(campaign, campaign.shard.count, jobs, costs);
  for (std::size_t run = 0; run < campaign.run_count(); ++run) {
    if (!shards.empty() && shards[run] != campaign.shard.index) continue;
    const std::size_t cell = run / campaign.seed_count;
    campaign.specs.push_back({.key = {},
                              .labels = campaign.cells[cell].labels,
                              .seed = campaign.first_seed + run % campaign.seed_count,
                              .command = {}});
    campaign.cells_of.push_back(cell);
  }
}

/// Resolves the scenario of a run and writes down its key and command; checks that of the first run of a
/// cell.
void resolve(Campaign& campaign, std::size_t run, const CheckScenario& check, const OwnMethods& own,
             const std::vector<std::string>& versions) {
  RunSpec& spec = campaign.specs[run];
  const CampaignCell& cell = campaign.cell_of(run);
  of_run(campaign, cell, spec.seed, [&] {
    Scenario scenario = campaign.scenario_of(run);
    if (check && (run == 0 || campaign.cells_of[run - 1] != campaign.cells_of[run])) check(scenario);
    const std::string own_version = own.version ? own.version(scenario) : "";
    spec.command = command_for(campaign, cell, own_version.empty() ? "fairway" : own.program);
    spec.key = key_of(cell, std::move(scenario), own_version);
    spec.version = Digest{}.add(versions[campaign.cells_of[run]]).add(own_version).hex();
  });
}

std::string digest_of(const Campaign& campaign, const CampaignFile& written) {
  Digest digest;
  digest.add(campaign.name);
  for (const CampaignScenario& scenario : campaign.scenarios)
    digest.add(canonical_text(scenario, campaign.first_seed));
  for (const CampaignCell& cell : campaign.cells) {
    digest.add(std::to_string(cell.scenario)).add(cell.algorithm);
    for (const auto& [name, value] : cell.labels) digest.add(name).add(value);
  }
  for (const auto& [path, value] : written.set) digest.add(path).add(value);
  digest.add(std::to_string(campaign.first_seed)).add(std::to_string(campaign.seed_count));
  return digest.hex();
}

}  // namespace

std::string canonical_text(Scenario scenario) {
  scenario.name.clear();
  scenario.summary.clear();
  scenario.expect.clear();
  return to_yaml(scenario);
}

Scenario scenario_of(const Campaign& campaign, std::size_t cell, std::uint64_t seed) {
  const CampaignScenario& scenario = campaign.scenarios[campaign.cells[cell].scenario];
  return scenario.document.scenario(campaign.cells[cell].overrides, seed);
}

Scenario Campaign::scenario_of(std::size_t run) const {
  return fairway::scenario_of(*this, cells_of[run], specs[run].seed);
}

Campaign parse_campaign(std::string_view yaml, const std::string& file, const CheckScenario& check,
                        unsigned jobs, const OwnMethods& own, const Shard& shard, const WatchListing& watch) {
  return expanded(parse_campaign_file(yaml, file), file, check, jobs, own, shard, watch);
}

Campaign expanded(const CampaignFile& written, const std::string& file, const CheckScenario& check,
                  unsigned jobs, const OwnMethods& own, const Shard& shard, const WatchListing& watch) {
  refuse_too_many(written, file);
  Campaign campaign{.name = written.name,
                    .summary = written.summary,
                    .file = file,
                    .scenarios = load_scenarios(written, file),
                    .cells = {},
                    .first_seed = written.first_seed,
                    .seed_count = written.seed_count,
                    .shard = shard,
                    .specs = {},
                    .cells_of = {},
                    .quantities = written.quantities,
                    .digest = {}};
  campaign.cells = expanded_cells(written, cases_of(campaign));
  campaign.digest = digest_of(campaign, written);
  list_runs(campaign, jobs);
  resolve_runs(campaign, check, jobs, own, watch);
  const auto run_of = [&](std::size_t cell) {
    return canonical_text(fairway::scenario_of(campaign, cell, campaign.first_seed));
  };
  if (!written.grid.empty() || !written.zip.empty()) refuse_cells_alike(file, campaign.cells, run_of);
  return campaign;
}

void resolve_runs(Campaign& campaign, const CheckScenario& check, unsigned jobs, const OwnMethods& own,
                  const WatchListing& watch) {
  const std::thread::id asking = std::this_thread::get_id();
  const std::vector<std::string> versions = versions_of(campaign);
  std::atomic<std::size_t> listed{0};
  for_each_index(campaign.specs.size(), jobs, [&](std::size_t run) {
    resolve(campaign, run, check, own, versions);
    ++listed;
    if (watch && std::this_thread::get_id() == asking) watch(listed, campaign.specs.size());
  });
}

Campaign load_campaign(const std::string& file, const CheckScenario& check, unsigned jobs,
                       const OwnMethods& own, const Shard& shard, const WatchListing& watch) {
  const std::optional<std::string> text = yaml::document_in(file);
  if (!text) throw InputError({file, 0, 0}, "", "cannot be read");
  return parse_campaign(*text, file, check, jobs, own, shard, watch);
}

void keep_runs(Campaign& campaign, const std::function<bool(const RunSpec&)>& is_wanted) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < campaign.specs.size(); ++i) {
    if (!is_wanted(campaign.specs[i])) continue;
    if (kept != i) campaign.specs[kept] = std::move(campaign.specs[i]);
    campaign.cells_of[kept++] = campaign.cells_of[i];
  }
  campaign.specs.resize(kept);
  campaign.cells_of.resize(kept);
}

Campaign load_cells(const std::string& file, const CheckScenario& check, unsigned jobs,
                    const OwnMethods& own) {
  const std::optional<std::string> text = yaml::document_in(file);
  if (!text) throw InputError({file, 0, 0}, "", "cannot be read");
  // each of as many shards as there are seeds has one run of every cell, and this one the first
  return parse_campaign(*text, file, check, jobs, own, {0, parse_campaign_file(*text, file).seed_count});
}

ShardPlan plan_of(const Campaign& campaign, std::uint32_t count, unsigned jobs) {
  ShardPlan plan{std::vector<std::size_t>(count), std::vector<double>(count)};
  std::vector<double> costs;
  const std::vector<std::uint32_t> shards = dealt_runs(campaign, count, jobs, costs);
  for (std::size_t run = 0; run < shards.size(); ++run) {
    ++plan.runs[shards[run]];
    plan.costs[shards[run]] += costs[run / campaign.seed_count];
  }
  return plan;
}

Origin origin_of(const Campaign& campaign) {
  Origin origin{.campaign = campaign.name,
                .digest = campaign.digest,
                .run_count = campaign.run_count(),
                .summary = campaign.summary,
                .quantities = campaign.quantities};
  for (const CampaignCell& cell : campaign.cells) add_values(origin.order, cell.labels);
  return origin;
}

ExecutorReport run_campaign(const Campaign& campaign, const Simulate& simulate, Store& store,
                            const ExecutorOptions& options) {
  store.refuse_other_epoch();
  store.note(origin_of(campaign));
  store.claim(campaign.specs);
  return run_missing(
      campaign.specs, [&](std::size_t i) { return simulate(campaign.scenario_of(i)); }, store, options);
}

std::vector<RunRecord> records_of(const Campaign& campaign, const Store& store) {
  std::unordered_set<std::string_view> keys;
  for (const RunSpec& spec : campaign.specs) keys.insert(spec.key);
  std::vector<RunRecord> records = store.all();
  std::erase_if(records, [&](const RunRecord& record) { return !keys.contains(record.spec.key); });
  return records;
}

}  // namespace fairway
