// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/study_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "fairway/core/names.hpp"
#include "fairway/core/text.hpp"
#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/executor.hpp"
#include "fairway/scenario/value.hpp"
#include "fairway/sim/divergence.hpp"

namespace fairway {
namespace {

std::string key_under(const Overrides& overrides, std::string key) {
  if (overrides.empty()) return key;
  std::string text;
  for (const auto& [path, value] : overrides) text += path + "=" + value + "\n";
  return key + "/" + Digest::of(text);
}

/// `fairway study` for one run alone, up to its seed.
std::string command_under(const StudyOptions& options, const RunSpec& spec) {
  std::string command = "fairway study " + shell_word(spec.key.substr(0, spec.key.find('/')));
  if (options.seeds != StudyOptions{}.seeds) command += fmt::format(" --seeds {}", options.seeds);
  for (const auto& [path, value] : options.overrides) command += " --set " + shell_word(path + "=" + value);
  return command + " --only " + shell_word(cell_name(spec.labels));
}

[[noreturn]] void refuse_several(std::string_view called, const std::vector<std::string>& names) {
  constexpr std::size_t told = 3;
  std::string some;
  for (std::size_t i = 0; i < std::min(told, names.size()); ++i) some += (i > 0 ? ", " : "") + names[i];
  throw InputError(fmt::format("{} runs begin with \"{}\": {}{}", names.size(), called, some,
                               names.size() > told ? ", ..." : ""));
}

/// "; did you mean crossing/apf/1?", or how the names begin.
std::string hint_for(std::string_view called, const std::vector<std::string>& names) {
  const std::string_view nearest = nearest_name(called, {names.begin(), names.end()});
  if (!nearest.empty()) return fmt::format("; did you mean {}?", nearest);
  std::set<std::string> beginnings;
  for (const std::string& name : names) beginnings.insert(name.substr(0, name.find('/') + 1));
  if (beginnings.empty()) return "";
  return fmt::format("; names begin with {}, and --only {} tells some that do", fmt::join(beginnings, ", "),
                     *beginnings.begin());
}

/// Each run of a study counts, so one that failed ends the study, as it would end alone.
[[noreturn]] void refuse_failure(const RunRecord& record) {
  if (record.failure.starts_with(yaml::override_prefix)) throw InputError(record.failure);
  const std::string text = "run " + record.spec.key + " failed: " + record.failure;
  if (record.failure.starts_with("diverged: ")) throw RunDiverged{text};
  throw InputError(text);
}

}  // namespace

std::string cell_name(const Labels& labels) {
  constexpr std::array<std::string_view, 4> bare{"case", "method", "mode", "part"};
  std::string name;
  for (const auto& [label, value] : labels) {
    const bool known = std::ranges::find(bare, label) != bare.end();
    name += (known ? value : label + "=" + value) + "/";
  }
  std::ranges::replace(name, ' ', '_');
  return name;
}

std::string name_of(const RunSpec& spec) { return cell_name(spec.labels) + std::to_string(spec.seed); }

RunSpec spec_under(const StudyOptions& options, RunSpec spec) {
  spec.command = command_under(options, spec);
  spec.key = key_under(options.overrides, std::move(spec.key));
  return spec;
}

Scenario under(const Overrides& overrides, Scenario scenario) {
  if (overrides.empty()) return scenario;
  return parse_scenario(to_yaml(scenario), scenario.name, overrides);
}

const StudyRun& find_run(std::span<const StudyRun> runs, std::string_view called) {
  std::vector<std::string> names;
  std::vector<std::string> begun;
  const StudyRun* found = nullptr;
  for (const StudyRun& run : runs) {
    std::string name = name_of(run.spec);
    if (name == called || run.spec.key == called) return run;
    if (name.starts_with(called) || run.spec.key.starts_with(called)) {
      begun.push_back(name);
      found = &run;
    }
    names.push_back(std::move(name));
  }
  if (begun.size() > 1) refuse_several(called, begun);
  if (found != nullptr) return *found;
  throw InputError(fmt::format("no run is called \"{}\"{}", called, hint_for(called, names)));
}

void show_run(const StudyRun& run, const StudyOptions& options) {
  if (!options.show) return;
  const Scenario scenario = under(options.overrides, run.scenario());
  const auto make = [&](std::span<FrameSink* const> sinks) {
    return run.measure(scenario, options.stop, sinks);
  };
  options.show({name_of(run.spec), spec_under(options, run.spec), scenario, make});
}

std::optional<std::vector<std::vector<Measure>>> make_runs(std::span<const StudyRun> runs,
                                                           const StudyOptions& options) {
  if (!options.only.empty()) {
    show_run(find_run(runs, options.only), options);
    return {};
  }
  Store temporary = Store::in_memory();
  Store& store = options.store != nullptr ? *options.store : temporary;
  // the runs of a cell follow each other, so that every shard has as many of them as any other
  std::vector<RunSpec> specs;
  for (std::size_t i = options.shard.index; i < runs.size(); i += options.shard.count)
    specs.push_back(spec_under(options, runs[i].spec));
  if (!runs.empty()) under(options.overrides, runs.front().scenario());

  const auto make = [&](std::size_t i) {
    const StudyRun& run = runs[options.shard.index + i * options.shard.count];
    return run.measure(under(options.overrides, run.scenario()), options.stop, {});
  };
  const ExecutorReport done = run_missing(
      specs, make, store, {.jobs = options.jobs, .progress = options.progress, .stop = options.stop});
  if (done.stopped || !options.shard.is_all()) return {};

  std::unordered_map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < specs.size(); ++i) places.emplace(specs[i].key, i);
  std::vector<std::vector<Measure>> measures(runs.size());
  for (RunRecord& record : store.all()) {
    const auto place = places.find(record.spec.key);
    if (place == places.end()) continue;
    if (!record.failure.empty()) refuse_failure(record);
    measures[place->second] = std::move(record.measures);
  }
  return measures;
}

}  // namespace fairway
