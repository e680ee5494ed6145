// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/cubes.hpp"

#include <algorithm>
#include <unordered_map>

#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/experiment/executor.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/studies/cubes/as_coded.hpp"
#include "fairway/studies/cubes/cubes_page.hpp"
#include "fairway/studies/cubes/findings.hpp"

namespace fairway::cubes {
namespace {

Scenario scenario_of(const PlannedRun& run) {
  const Cell& cell = *run.cell;
  return cube_scenario(*cell.cube, *cell.method, cell.code, cell.tuning, run.spec.seed);
}

std::vector<CellResults> collect(const std::vector<Cell>& cells, std::span<const PlannedRun> plan,
                                 const Store& store) {
  std::unordered_map<std::string, std::vector<Measure>> by_key;
  for (RunRecord& record : store.all()) {
    if (!record.failure.empty()) throw InputError("run " + record.spec.key + " failed: " + record.failure);
    by_key.emplace(std::move(record.spec.key), std::move(record.measures));
  }
  std::vector<CellResults> results;
  for (const Cell& cell : cells) results.push_back({&cell, {}});
  for (const PlannedRun& run : plan) {
    const auto found = by_key.find(run.spec.key);
    if (found == by_key.end()) continue;
    results[static_cast<std::size_t>(run.cell - cells.data())].runs.push_back(found->second);
  }
  return results;
}

}  // namespace

Catalogs cube_catalogs() {
  Catalogs catalogs = builtin_catalogs();
  catalogs.avoiders.add<ApfAsCoded>().add<OrcaAsCoded>().add_wrapper<StopAndWaitAsCoded, Direct>();
  return catalogs;
}

std::vector<CellResults> run_cells(const std::vector<Cell>& cells, Store& store,
                                   const StudyOptions& options) {
  const std::vector<PlannedRun> plan = plan_of(cells);
  std::vector<RunSpec> specs;
  for (const PlannedRun& run : plan) specs.push_back(run.spec);

  const Catalogs catalogs = cube_catalogs();
  const ExecutorReport done = run_missing(
      specs, [&](std::size_t i) { return measure_run(scenario_of(plan[i]), catalogs, options.stop); }, store,
      {.jobs = options.jobs, .progress = options.progress, .stop = options.stop});
  if (done.stopped) return {};
  return collect(cells, plan, store);
}

StudyResult run_cubes(const StudyOptions& options) {
  std::vector<Cell> cells = tuning_cells();
  std::ranges::copy(comparison_cells(Code::as_coded, 0), std::back_inserter(cells));
  if (options.seeds > 0) {
    std::ranges::copy(heading_cells(), std::back_inserter(cells));
    std::ranges::copy(comparison_cells(Code::corrected, options.seeds), std::back_inserter(cells));
  }
  Store temporary = Store::in_memory();
  const std::vector<CellResults> results =
      run_cells(cells, options.store != nullptr ? *options.store : temporary, options);
  if (results.empty()) return {.complete = false};

  StudyResult study{.rows = rows_of(results)};
  study.page = page_of(results, study.rows, options);
  return study;
}

Study study() {
  return {.name = "cubes",
          .title = "AUVs that cross a cube: APF and ORCA, with and without stop-and-wait",
          .source = "raja2024: Raja Mateos, master's thesis, University of the Balearic Islands, 2024",
          .run = run_cubes};
}

}  // namespace fairway::cubes
