// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/transport.hpp"

#include <algorithm>

#include "fairway/studies/transport/transport_page.hpp"
#include "fairway/studies/transport/voyage_log.hpp"

namespace fairway::transport {
StudyResult run_transport(const StudyOptions& options) {
  Results results{.published = published_cells(),
                  .cases = case_cells(),
                  .fields = options.seeds > 0 ? field_cells(options.seeds) : std::vector<Cell>{},
                  .seeds = options.seeds};
  const Catalogs catalogs = builtin_catalogs();
  const MeasureRun measure = measured_with(catalogs, measure_voyage);
  const std::array groups{MeasuredCells{&results.published, measure}, MeasuredCells{&results.cases, measure},
                          MeasuredCells{&results.fields, measure}};
  if (!make_cells(groups, options)) return {.complete = false};
  for (const char* method : {"wall_following", "blend"}) {
    const Cell& cell =
        find_cell(results.cases, name_of(Case::four_obstacles), method, name_of(Plant::physical));
    show_run(cell.runs.front(), options);
  }

  results.rows = published_rows(results.published);
  results.published_rows = results.rows.size();
  std::ranges::copy(comparison_rows(results.cases), std::back_inserter(results.rows));
  std::ranges::copy(comparison_rows(results.fields), std::back_inserter(results.rows));
  return {.rows = results.rows, .page = page_of(results, options)};
}

Study study() {
  return {
      .name = "transport",
      .title =
          "A transport system of four vehicles: hard switching, wall following, planning, and their blend",
      .source = "rehman2021: Rehman, Anderlini, Thomas, Journal of Robotics and Control, 2021",
      .run = run_transport};
}

}  // namespace fairway::transport
