// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/cubes.hpp"

#include <algorithm>

#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/studies/cubes/as_coded.hpp"
#include "fairway/studies/cubes/as_heard.hpp"
#include "fairway/studies/cubes/chosen_run.hpp"
#include "fairway/studies/cubes/cubes_page.hpp"
#include "fairway/studies/cubes/replicas.hpp"

namespace fairway::cubes {
const Catalogs& cube_catalogs() {
  static const Catalogs all = [] {
    Catalogs catalogs = builtin_catalogs();
    catalogs.avoiders.add<ApfAsCoded>()
        .add<OrcaAsCoded>()
        .add_wrapper<StopAndWaitAsCoded, Direct>()
        .add_wrapper<AsHeard, Direct>();
    return catalogs;
  }();
  return all;
}

bool make_crossings(std::vector<Cell>& cells, const StudyOptions& options) {
  const MeasuredCells all{&cells, measured_with(cube_catalogs(), measure_run)};
  return make_cells({&all, 1}, options);
}

StudyResult run_cubes(const StudyOptions& options) {
  std::vector<Cell> cells = tuning_cells();
  const auto plan = [&](std::vector<Cell> more) { std::ranges::move(more, std::back_inserter(cells)); };
  plan(comparison_cells(Code::as_coded, published_runs));
  if (options.seeds > 0) {
    plan(heading_cells());
    plan(comparison_cells(Code::corrected, options.seeds));
    for (const Code code : repeated_codes) plan(replica_cells(code, options.seeds));
    plan(timing_cells(options.seeds));
    plan(told_cells(options.seeds));
  }
  if (!make_crossings(cells, options)) return {.complete = false};
  if (options.seeds > 0) show_run(chosen_cell(cells).runs.front(), options);

  const std::vector<StudyRow> rows = rows_of(cells);
  return {.rows = rows, .page = page_of(cells, rows, options)};
}

Study study() {
  return {.name = "cubes",
          .title = "AUVs that cross a cube: APF and ORCA, with and without stop-and-wait",
          .source = "raja2024: Raja Mateos, master's thesis, University of the Balearic Islands, 2024",
          .run = run_cubes};
}

}  // namespace fairway::cubes
