// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/study_runs.hpp"

#include <unordered_map>

#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/executor.hpp"

namespace fairway {
namespace {

RunSpec keyed(RunSpec spec, const Overrides& overrides) {
  if (overrides.empty()) return spec;
  std::string text;
  for (const auto& [path, value] : overrides) text += path + "=" + value + "\n";
  spec.key += "/" + Digest::of(text);
  return spec;
}

}  // namespace

Scenario under(const Overrides& overrides, Scenario scenario) {
  if (overrides.empty()) return scenario;
  return parse_scenario(to_yaml(scenario), scenario.name, overrides);
}

std::optional<std::vector<std::vector<Measure>>> make_runs(std::span<const StudyRun> runs,
                                                           const MeasureRun& measure,
                                                           const StudyOptions& options) {
  Store temporary = Store::in_memory();
  Store& store = options.store != nullptr ? *options.store : temporary;
  std::vector<RunSpec> specs;
  for (const StudyRun& run : runs) specs.push_back(keyed(run.spec, options.overrides));
  if (!runs.empty()) under(options.overrides, runs.front().scenario());

  const auto make = [&](std::size_t i) {
    return measure(under(options.overrides, runs[i].scenario()), options.stop);
  };
  const ExecutorReport done = run_missing(
      specs, make, store, {.jobs = options.jobs, .progress = options.progress, .stop = options.stop});
  if (done.stopped) return {};

  std::unordered_map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < specs.size(); ++i) places.emplace(specs[i].key, i);
  std::vector<std::vector<Measure>> measures(runs.size());
  for (RunRecord& record : store.all()) {
    const auto place = places.find(record.spec.key);
    if (place == places.end()) continue;
    if (!record.failure.empty()) throw InputError("run " + record.spec.key + " failed: " + record.failure);
    measures[place->second] = std::move(record.measures);
  }
  return measures;
}

}  // namespace fairway
