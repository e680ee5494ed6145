// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/transport_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fairway/experiment/version.hpp"
#include "fairway/studies/page_blocks.hpp"
#include "fairway/studies/transport/figures.hpp"

namespace fairway::transport {
namespace {

using nlohmann::json;

std::vector<StudyRow> rows_in_mode(std::span<const StudyRow> rows, std::string_view mode) {
  std::vector<StudyRow> chosen;
  std::ranges::copy_if(rows, std::back_inserter(chosen),
                       [&](const StudyRow& row) { return row.mode == mode; });
  return chosen;
}

json published_section(const Results& results, const RunIndex& runs) {
  const std::span rows = std::span{results.rows}.first(results.published_rows);
  return page::section(
      "published", "Published against measured", claims(results.published),
      {page::comparison_table("On the compatible plant", rows_in_mode(rows, name_of(Plant::paper_compat)),
                              runs),
       page::comparison_table("On the physical plant", rows_in_mode(rows, name_of(Plant::physical)), runs)});
}

json plants_section() {
  return page::section(
      "plants", "The two plants",
      {"The publication gives neither mass nor drag of the transport system. `physical` is "
       "composed of four Minerva "
       "vehicles, a payload and links from published parts: linear and quadratic drag of every "
       "part, Coriolis and "
       "centripetal terms, and a yaw inertia in which a swap of two entries in the published data "
       "is put right.",
       "`paper_compat` leaves the quadratic drag and the Coriolis terms out and keeps the inertia "
       "as in the data. It "
       "was chosen after seeing the published times: with quadratic drag the goal of the first "
       "case takes three "
       "times the published 350 s, and with Coriolis terms hard switching never arrives. So "
       "agreement on it is agreement "
       "under an assumption."},
      {});
}

json figures_section(const Overrides& overrides, const RunIndex& runs) {
  std::vector<json> blocks;
  const std::array titles{"Figure 5: hard switching", "Figure 6: wall following",
                          "Figure 7: wall following among four obstacles", "Figure 9: trajectory following"};
  for (std::size_t i = 0; i < titles.size(); ++i) {
    if (i == 3) blocks.push_back(planned_paths());
    for (json& block : redrawn(published_runs()[i], titles[i], overrides, runs))
      blocks.push_back(std::move(block));
  }
  return page::section("figures", "Figures 5 to 9 redrawn", {"Positions north and east, one point a second."},
                       std::move(blocks));
}

json cases_section(const Results& results, const Overrides& overrides, const RunIndex& runs) {
  std::vector<json> blocks;
  for (const Case which : {Case::one_obstacle, Case::four_obstacles, Case::unknown_obstacle})
    blocks.push_back(ways(which, compared_methods(), overrides, runs));
  blocks.push_back(
      page::comparison_table("Every method on the three cases", comparison_rows(results.cases), runs));
  return page::section(
      "cases", "Every method on the published cases, and on one with an unknown obstacle",
      {"On the physical plant. A run is a success if it arrives and the footprint, a disc of 3.2 m that "
       "holds the four tips, touches nothing."},
      std::move(blocks));
}

json fields_section(const Results& results, const RunIndex& runs) {
  const std::vector<StudyRow> rows = comparison_rows(results.fields);
  std::vector<std::string> places;
  for (const FieldKind kind : field_kinds) places.emplace_back(name_of(kind));
  std::vector<std::string> paragraphs{
      fmt::format("{} random fields of each kind: 8 to 14 discs of 1 to 4 m in a square of 50 m, crossed "
                  "from corner to corner. In "
                  "`field_unknown` about half of them are on no chart and are perceived 5 m from the "
                  "footprint; in `field_moving` "
                  "three spheres drift through as well. The fields of one number share their discs over the "
                  "kinds and are the same "
                  "for every method. Bars are 95 % intervals.",
                  results.seeds)};
  std::ranges::copy(field_findings(results.fields, results.seeds), std::back_inserter(paragraphs));
  return page::section("fields", "Random fields: known, unknown and moving obstacles", std::move(paragraphs),
                       {page::grid(2, {page::method_intervals(rows, compared_methods(), "success_ratio",
                                                              "arrived, nothing touched", places, runs),
                                       page::method_intervals(rows, compared_methods(), "untouched_ratio",
                                                              "nothing touched", places, runs),
                                       page::method_intervals(rows, compared_methods(), "navigation_time_s",
                                                              "time of arrival [s]", places, runs),
                                       page::method_intervals(rows, compared_methods(), "body_energy_j",
                                                              "energy into the body [J]", places, runs)}),
                        page::comparison_table("All kinds, all methods", rows, runs)});
}

json facts(const Results& results) {
  const std::array groups{&results.published, &results.cases, &results.fields};
  const auto count = [&](Verdict verdict) {
    return std::ranges::count(results.rows, verdict, &StudyRow::verdict);
  };
  return {{{"label", "Runs"}, {"value", std::to_string(run_count(groups))}},
          {{"label", "Reproduced"}, {"value", std::to_string(count(Verdict::reproduced))}},
          {{"label", "Reproduced, assuming"}, {"value", std::to_string(count(Verdict::reproduced_assuming))}},
          {{"label", "Not reproduced"},
           {"value", std::to_string(count(Verdict::not_reproduced) + count(Verdict::partly))}}};
}

}  // namespace

json page_of(const Results& results, const StudyOptions& options) {
  RunIndex runs{options};
  for (const auto* cells : {&results.published, &results.cases, &results.fields}) runs.add(*cells);
  json sections = json::array({published_section(results, runs), plants_section(),
                               figures_section(options.overrides, runs),
                               cases_section(results, options.overrides, runs)});
  if (results.seeds > 0) sections.push_back(fields_section(results, runs));
  return {{"title", "A transport system among obstacles"},
          {"subtitle",
           "rehman2021: hard switching, wall following and a planned path; then corrected, filtered and "
           "blended"},
          {"version", fmt::format("fairway {}", fairway_version)},
          {"command", options.command},
          {"facts", facts(results)},
          {"runs", runs.document()},
          {"sections", std::move(sections)}};
}

}  // namespace fairway::transport
