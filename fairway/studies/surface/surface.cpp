// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/surface/surface.hpp"

#include "fairway/experiment/measure_run.hpp"
#include "fairway/studies/surface/surface_page.hpp"

namespace fairway::surface {
namespace {

StudyResult run_surface(const StudyOptions& options) {
  Results results{.published = published_cells(),
                  .variations = options.seeds > 0 ? varied_cells(options.seeds) : std::vector<Cell>{},
                  .scales = options.seeds > 0 ? scale_cells() : std::vector<Cell>{},
                  .seeds = options.seeds};
  const Catalogs catalogs = builtin_catalogs();
  const MeasureRun measure = measured_with(catalogs, measure_run);
  const MeasureRun of_scale = measured_with(catalogs, measure_scale);
  const std::array groups{MeasuredCells{&results.published, measure},
                          MeasuredCells{&results.variations, measure},
                          MeasuredCells{&results.scales, of_scale}};
  if (!make_cells(groups, options)) return {.complete = false};
  for (const char* method : {"avoa", "avoa_improved"}) {
    const Cell& cell =
        find_cell(results.published, name_of(Course::cluttered), method, name_of(Vessel::zarco));
    show_run(cell.runs.front(), options);
  }

  results.rows = published_rows(results.published);
  results.published_rows = results.rows.size();
  std::ranges::move(varied_rows(results.variations), std::back_inserter(results.rows));
  results.varied_rows = results.rows.size() - results.published_rows;
  std::ranges::move(scale_rows(results.scales), std::back_inserter(results.rows));
  return {.rows = results.rows, .page = page_of(results, options)};
}

}  // namespace

Study study() {
  return {.name = "surface",
          .title = "A surface vessel among buoys and vessels: AVOA, its improvement, and TEB",
          .source =
              "campos2019: Campos, Matos, Pinto, An Adaptive Velocity Obstacle Avoidance Algorithm for "
              "Autonomous Surface Vehicles, 2019",
          .run = run_surface};
}

}  // namespace fairway::surface
