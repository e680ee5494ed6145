// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/uuv.hpp"

#include "fairway/studies/uuv/measures.hpp"
#include "fairway/studies/uuv/uuv_page.hpp"

namespace fairway::uuv {
namespace {

StudyResult run_uuv(const StudyOptions& options) {
  Results results{.published = published_cells(), .seeds = options.seeds};
  if (options.seeds > 0) {
    results.variations = varied_cells(options.seeds);
    results.gatherings = gathering_cells(options.seeds);
    results.silence = silence_cells(options.seeds);
  }
  const Catalogs catalogs = builtin_catalogs();
  const MeasureRun meet = measured_with(catalogs, measure_encounter);
  const MeasureRun gather = measured_with(catalogs, measure_fleet);
  const std::array groups{MeasuredCells{&results.published, meet}, MeasuredCells{&results.variations, meet},
                          MeasuredCells{&results.gatherings, gather},
                          MeasuredCells{&results.silence, gather}};
  if (!make_cells(groups, options)) return {.complete = false};
  // the first of each encounter is RVO in the setting that fits, which the figures show
  for (const Encounter encounter : {Encounter::head_on, Encounter::multi_obstacle})
    show_run(std::ranges::find(results.published, name_of(encounter), &Cell::place)->runs.front(), options);

  results.published_rows = published_rows(results.published);
  StudyResult study{.rows = results.published_rows};
  if (options.seeds > 0) {
    results.varied_rows = varied_rows(results.variations);
    results.gathering_rows = gathering_rows(results.gatherings);
    results.silence_rows = silence_rows(results.silence);
    for (const auto* rows : {&results.varied_rows, &results.gathering_rows, &results.silence_rows})
      std::ranges::copy(*rows, std::back_inserter(study.rows));
  }
  study.page = page_of(results, options);
  return study;
}

}  // namespace

Study study() {
  return {.name = "uuv",
          .title = "UUVs that meet: velocity obstacles, fifty at once, sonar and acoustic messages",
          .source =
              "cao2022: Cao et al., Dynamic Obstacle Avoidance for Unmanned Underwater Vehicles based on "
              "Velocity Obstacle, sections 4.1 and 4.2",
          .run = run_uuv};
}

}  // namespace fairway::uuv
