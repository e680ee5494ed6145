// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/transport_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fairway/studies/page_blocks.hpp"
#include "fairway/studies/transport/figures.hpp"

namespace fairway::transport {
namespace {

using nlohmann::json;

json published_section(const Results& results, const RunIndex& runs) {
  const std::span rows = std::span{results.rows}.first(results.published_rows);
  return page::section(
      "published", "Published against measured", claims(results.published),
      {page::comparison_table("On the compatible plant", rows_in_mode(rows, name_of(Plant::paper_compat)),
                              runs),
       page::comparison_table("On the physical plant", rows_in_mode(rows, name_of(Plant::physical)), runs)});
}

json plants_section(const std::vector<Cell>& published) {
  const std::string_view physical = name_of(Plant::physical);
  std::vector<std::string> paragraphs{
      "The publication gives neither mass nor drag of the transport system. The physical plant is composed "
      "of four "
      "Minerva vehicles, a payload and links from published parts: linear and quadratic drag of every part, "
      "Coriolis and centripetal terms, and a yaw inertia in which a swap of two entries in the published "
      "data is put right. The compatible plant, paper_compat, leaves the quadratic drag and the Coriolis "
      "terms out and keeps the "
      "inertia as in the data. It was chosen after seeing the published times, so agreement on it is "
      "agreement under an assumption."};
  for (const PublishedRun& run : published_runs()) {
    const Cell& cell = find_cell(published, name_of(run.which), run.method.name, physical);
    const double time = cell.value(0, "goal_time_s");
    const std::string arrival =
        std::isfinite(time) ? fmt::format("within 1 m of the goal after {:.0f} s", time)
                            : fmt::format("not within 1 m of the goal, {:.1f} m from the start at the end",
                                          cell.value(0, "displacement_m"));
    paragraphs.push_back(
        fmt::format("On the physical plant, {} on {}: {}.", cell.method, cell.place, arrival));
  }
  return page::section("plants", "The two plants", std::move(paragraphs), {});
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
  return page::section("cases", "Every method on the published cases, and on one with an unknown obstacle",
                       {"On the physical plant. A run is a success if it arrives and the footprint, a disc "
                        "of 3.2 m that holds the four tips, touches nothing."},
                       std::move(blocks));
}

json fields_section(const Results& results, const RunIndex& runs) {
  const std::vector<StudyRow> rows = comparison_rows(results.fields);
  std::vector<std::string> places;
  for (const FieldKind kind : field_kinds) places.emplace_back(name_of(kind));
  std::vector<std::string> paragraphs{fmt::format(
      "{} random fields of each kind: 8 to 14 discs of 1 to 4 m in a square of 50 m, crossed from corner to "
      "corner. In field_unknown about half of them are on no chart and are perceived 5 m from the "
      "footprint; in field_moving three spheres drift through as well. The fields of one number share "
      "their discs over the kinds and are the same for every method. Bars are 95 % intervals.",
      results.seeds)};
  std::ranges::copy(field_findings(results.fields, results.seeds), std::back_inserter(paragraphs));
  const auto bars = [&](std::string_view quantity, std::string_view label) {
    return page::method_intervals(rows, compared_methods(), quantity, label, places, runs);
  };
  return page::section("fields", "Random fields: known, unknown and moving obstacles", std::move(paragraphs),
                       {page::grid(2, {bars("success_ratio", "arrived, nothing touched"),
                                       bars("untouched_ratio", "nothing touched"),
                                       bars("navigation_time_s", "time of arrival [s]"),
                                       bars("body_energy_j", "energy into the body [J]")}),
                        page::comparison_table("All kinds, all methods", rows, runs)});
}

json facts(const Results& results) {
  const std::vector<StudyRow> rows =
      rows_where(results.rows, [](const StudyRow& row) { return row.published.has_value(); });
  return {page::fact("Reproduced", rows, Verdict::reproduced),
          page::fact("Reproduced, assuming", rows, Verdict::reproduced_assuming),
          page::fact("Partly", rows, Verdict::partly),
          page::fact("Not reproduced", rows, Verdict::not_reproduced),
          page::fact("On another course", rows, Verdict::another_course),
          page::fact("Follow from inputs", rows, Verdict::follows_from_inputs)};
}

}  // namespace

json page_of(const Results& results, const StudyOptions& options) {
  const RunIndex runs{options, {&results.published, &results.cases, &results.fields}};
  json sections = json::array({published_section(results, runs), plants_section(results.published),
                               figures_section(options.overrides, runs),
                               cases_section(results, options.overrides, runs)});
  if (results.seeds > 0) sections.push_back(fields_section(results, runs));
  return page::document(
      "A transport system among obstacles",
      "rehman2021: hard switching, wall following and a planned path; then corrected, filtered and blended",
      options.command, facts(results), runs.list(), std::move(sections));
}

}  // namespace fairway::transport
