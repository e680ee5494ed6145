// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/cubes.hpp"

#include <algorithm>

#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/studies/cubes/as_coded.hpp"
#include "fairway/studies/cubes/as_heard.hpp"
#include "fairway/studies/cubes/chosen_run.hpp"
#include "fairway/studies/cubes/cubes_page.hpp"
#include "fairway/studies/cubes/rows.hpp"
#include "fairway/studies/study_runs.hpp"

namespace fairway::cubes {
namespace {

/// The run that the report shows in detail.
bool is_chosen(const RunSpec& spec) {
  return spec.seed == chosen_seed && spec.labels == chosen_cell().labels();
}

}  // namespace

Catalogs cube_catalogs() {
  Catalogs catalogs = builtin_catalogs();
  catalogs.avoiders.add<ApfAsCoded>()
      .add<OrcaAsCoded>()
      .add_wrapper<StopAndWaitAsCoded, Direct>()
      .add_wrapper<AsHeard, Direct>();
  return catalogs;
}

std::vector<CellResults> run_cells(const std::vector<Cell>& cells, const StudyOptions& options) {
  const Catalogs catalogs = cube_catalogs();
  const MeasureRun measure = measured_with(catalogs, measure_run);
  std::vector<StudyRun> runs;
  for (const Cell& cell : cells) {
    for (const RunSpec& spec : specs_of(cell))
      runs.push_back({spec, [&cell, seed = spec.seed] { return cell.scenario(seed); }, measure});
  }
  auto measures = make_runs(runs, options);
  if (!measures) return {};
  for (const StudyRun& run : runs) {
    if (is_chosen(run.spec)) show_run(run, options);
  }

  std::vector<CellResults> results;
  auto next = measures->begin();
  for (const Cell& cell : cells) {
    CellResults& mine = results.emplace_back(CellResults{&cell, {}});
    for (int run = 0; run < cell.runs; ++run) mine.runs.push_back(std::move(*next++));
  }
  return results;
}

StudyResult run_cubes(const StudyOptions& options) {
  std::vector<Cell> cells = tuning_cells();
  std::ranges::copy(comparison_cells(Code::as_coded, 0), std::back_inserter(cells));
  if (options.seeds > 0) {
    std::ranges::copy(heading_cells(), std::back_inserter(cells));
    std::ranges::copy(comparison_cells(Code::corrected, options.seeds), std::back_inserter(cells));
    std::ranges::copy(replica_cells(Code::as_coded_replicas, options.seeds), std::back_inserter(cells));
    std::ranges::copy(replica_cells(Code::as_coded_starts, options.seeds), std::back_inserter(cells));
    std::ranges::copy(timing_cells(options.seeds), std::back_inserter(cells));
    std::ranges::copy(told_cells(options.seeds), std::back_inserter(cells));
  }
  const std::vector<CellResults> results = run_cells(cells, options);
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
