// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/campaign.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>
#include <unordered_set>
#include <utility>

#include "fairway/core/text.hpp"
#include "fairway/experiment/campaign_file.hpp"
#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/experiment/version.hpp"

namespace fairway {
namespace {

constexpr std::size_t max_file_bytes = 4 << 20;

/// The whole file, or nothing if it cannot be read or is far too long to be YAML of ours.
std::optional<std::string> read_file(const std::string& file) {
  std::ifstream stream{file, std::ios::binary};
  std::string text(max_file_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  // a folder opens and does not read
  if (!stream.eof()) return {};
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

std::vector<CampaignScenario> load_scenarios(const CampaignFile& written, const std::string& file) {
  std::vector<CampaignScenario> scenarios;
  std::unordered_set<std::string> cases;
  for (const CampaignScenarioFile& scenario : written.scenarios) {
    const auto path = (std::filesystem::path(file).parent_path() / scenario.path).lexically_normal();
    std::optional<std::string> text = read_file(path.string());
    if (!text) throw InputError(scenario.where, "scenario", path.string() + " cannot be read");
    if (!cases.insert(path.stem().string()).second) {
      throw InputError(scenario.where, "scenario", "a second one named " + path.stem().string());
    }
    scenarios.push_back({path.string(), std::move(*text)});
  }
  return scenarios;
}

/// Every combination, the last axis fastest.
std::vector<Overrides> combinations(const std::vector<CampaignAxis>& grid) {
  std::vector<Overrides> all{{}};
  for (const CampaignAxis& axis : grid) {
    std::vector<Overrides> longer;
    longer.reserve(all.size() * axis.values.size());
    for (const Overrides& settings : all) {
      for (const std::string& value : axis.values) {
        longer.push_back(settings);
        longer.back().emplace_back(axis.path, value);
      }
    }
    all = std::move(longer);
  }
  return all;
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

std::vector<CampaignCell> expanded_cells(const CampaignFile& written, const Campaign& campaign) {
  std::vector<std::optional<CampaignAlgorithm>> algorithms(written.algorithms.begin(),
                                                           written.algorithms.end());
  if (algorithms.empty()) algorithms.emplace_back();
  const std::vector<Overrides> rows = written.zip.empty() ? std::vector<Overrides>{{}} : written.zip;
  const std::vector<Overrides> grid = combinations(written.grid);

  std::vector<CampaignCell> cells;
  for (std::size_t s = 0; s < campaign.scenarios.size(); ++s) {
    const std::string name = std::filesystem::path(campaign.scenarios[s].file).stem().string();
    for (const auto& algorithm : algorithms) {
      for (const Overrides& row : rows) {
        for (const Overrides& settings : grid) {
          CampaignCell cell{.labels = {{"case", name}}, .scenario = s};
          cell.labels.emplace_back("method", algorithm ? algorithm->label : "as_written");
          if (algorithm) {
            cell.algorithm = algorithm->avoider;
            cell.overrides.emplace_back("vehicles[*].avoider", algorithm->avoider);
          }
          for (const Overrides* part : {&row, &settings}) {
            cell.labels.insert(cell.labels.end(), part->begin(), part->end());
            cell.overrides.insert(cell.overrides.end(), part->begin(), part->end());
          }
          cells.push_back(std::move(cell));
        }
      }
    }
  }
  return cells;
}

/// A digest of all that decides the outcome; what is only there for people or for tests is left out.
std::string key_of(const CampaignCell& cell, Scenario scenario, const std::string& own_version) {
  scenario.name.clear();
  scenario.summary.clear();
  scenario.expect.clear();
  Digest digest;
  digest.add(std::to_string(results_epoch)).add(cell.algorithm).add(to_yaml(scenario));
  for (const auto& [name, value] : cell.labels) digest.add(name).add(value);
  if (!own_version.empty()) digest.add(own_version);
  return digest.hex();
}

/// `fairway run` with all that the cell sets, up to the seed.
std::string command_for(const Campaign& campaign, const CampaignCell& cell, const std::string& program) {
  if (program.empty()) return "";
  std::string command = program + " run " + shell_word(campaign.scenarios[cell.scenario].file);
  for (const auto& [path, value] : cell.overrides) command += " --set " + shell_word(path + "=" + value);
  return command + " --seed ";
}

/// Resolves the scenarios of one cell and writes down their keys and commands.
void resolve_cell(Campaign& campaign, std::size_t cell, const CheckScenario& check, const OwnMethods& own) {
  for (std::size_t i = cell * campaign.seed_count; i < (cell + 1) * campaign.seed_count; ++i) {
    RunSpec& spec = campaign.specs[i];
    try {
      Scenario scenario = campaign.scenario_of(i);
      if (check && i == cell * campaign.seed_count) check(scenario);
      const std::string own_version = own.version ? own.version(scenario) : "";
      spec.command =
          command_for(campaign, campaign.cells[cell], own_version.empty() ? "fairway" : own.program);
      spec.key = key_of(campaign.cells[cell], std::move(scenario), own_version);
    } catch (const InputError& error) {
      throw InputError(campaign.file + ": in " + labels_text(spec.labels) +
                       " seed=" + std::to_string(spec.seed) + ": " + error.what());
    }
  }
}

/// All cells, on several threads. Of several errors, that of the first cell is thrown.
void resolve(Campaign& campaign, const CheckScenario& check, unsigned jobs, const OwnMethods& own) {
  const std::size_t wanted = jobs > 0 ? jobs : std::max(1U, std::thread::hardware_concurrency());
  const std::size_t threads = std::min(wanted, campaign.cells.size());
  std::vector<std::exception_ptr> errors(campaign.cells.size());
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> end{campaign.cells.size()};
  const auto work = [&] {
    // after an error only the cells before it still matter
    for (std::size_t cell = next.fetch_add(1); cell < end; cell = next.fetch_add(1)) {
      try {
        resolve_cell(campaign, cell, check, own);
      } catch (...) {
        errors[cell] = std::current_exception();
        std::size_t known = end;
        while (cell < known && !end.compare_exchange_weak(known, cell)) {
        }
      }
    }
  };
  {
    std::vector<std::jthread> pool;
    for (std::size_t t = 1; t < threads; ++t) pool.emplace_back(work);
    work();
  }
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace

Scenario Campaign::scenario_of(std::size_t run) const {
  const CampaignCell& cell = cell_of(run);
  const CampaignScenario& scenario = scenarios[cell.scenario];
  return parse_scenario(scenario.text, scenario.file, cell.overrides, specs[run].seed);
}

Campaign parse_campaign(std::string_view yaml, const std::string& file, const CheckScenario& check,
                        unsigned jobs, const OwnMethods& own) {
  const CampaignFile written = parse_campaign_file(yaml, file);
  refuse_too_many(written, file);
  Campaign campaign{.name = written.name,
                    .summary = written.summary,
                    .file = file,
                    .scenarios = load_scenarios(written, file),
                    .cells = {},
                    .seed_count = written.seed_count,
                    .specs = {},
                    .quantities = written.quantities};
  campaign.cells = expanded_cells(written, campaign);
  for (const CampaignCell& cell : campaign.cells) {
    for (std::size_t s = 0; s < campaign.seed_count; ++s) {
      campaign.specs.push_back(
          {.key = {}, .labels = cell.labels, .seed = written.first_seed + s, .command = {}});
    }
  }
  resolve(campaign, check, jobs, own);
  return campaign;
}

Campaign load_campaign(const std::string& file, const CheckScenario& check, unsigned jobs,
                       const OwnMethods& own) {
  const std::optional<std::string> text = read_file(file);
  if (!text) throw InputError({file, 0, 0}, "", "cannot be read");
  return parse_campaign(*text, file, check, jobs, own);
}

Origin origin_of(const Campaign& campaign) {
  Origin origin{.campaign = campaign.name, .summary = campaign.summary, .quantities = campaign.quantities};
  for (const CampaignCell& cell : campaign.cells) add_values(origin.order, cell.labels);
  return origin;
}

ExecutorReport run_campaign(const Campaign& campaign, const Simulate& simulate, Store& store,
                            const ExecutorOptions& options) {
  store.note(origin_of(campaign));
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
