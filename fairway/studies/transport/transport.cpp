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
  const auto measure = [&](const Scenario& scenario, const std::atomic<bool>* stop) {
    return measure_voyage(scenario, catalogs, stop);
  };
  const std::array groups{&results.published, &results.cases, &results.fields};
  if (!make_cells(groups, measure, options)) return {.complete = false};

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
