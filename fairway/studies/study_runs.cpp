// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/study_runs.hpp"

#include <unordered_map>

#include "fairway/experiment/executor.hpp"

namespace fairway {

std::optional<std::vector<std::vector<Measure>>> make_runs(std::span<const StudyRun> runs,
                                                           const MeasureRun& measure,
                                                           const StudyOptions& options) {
  Store temporary = Store::in_memory();
  Store& store = options.store != nullptr ? *options.store : temporary;
  std::vector<RunSpec> specs;
  for (const StudyRun& run : runs) specs.push_back(run.spec);
  const ExecutorReport done =
      run_missing(specs, [&](std::size_t i) { return measure(runs[i].scenario(), options.stop); }, store,
                  {.jobs = options.jobs, .progress = options.progress, .stop = options.stop});
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
