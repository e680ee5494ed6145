// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/cubes_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fairway/core/text.hpp"
#include "fairway/studies/cubes/chosen_run.hpp"
#include "fairway/studies/cubes/findings.hpp"
#include "fairway/studies/cubes/rows.hpp"
#include "fairway/studies/page_blocks.hpp"

namespace fairway::cubes {
namespace {

using nlohmann::json;
using Cells = std::vector<Cell>;

constexpr auto repeated_words =
    "A published value is a mean or a total of five runs. Here the five runs of each cell are repeated; the "
    "interval is the middle 95 % of the repetitions, and the note says how many lie below the published "
    "value. colliding_run_ratio is compared by Fisher's exact test instead.";

constexpr auto repeated_verdicts =
    "There are two verdicts: within spread, where the published value lies in the middle 95 % of the fives, "
    "for "
    "colliding_run_ratio where Fisher's p is at least 0.05; and not reproduced.";

struct Plotted {
  std::string_view quantity, label;
};
constexpr std::array plotted{
    Plotted{"navigation_time_s", "Navigation time [s]"}, Plotted{"avoidance_time_s", "Avoidance time [s]"},
    Plotted{"avoided_count", "Avoided encounters"}, Plotted{"distance_m", "Distance [m]"}};

/// A box per value of one parameter, over all cells of the tuning of a method (Figures 16 and 17).
json tuning_boxes(const Cells& cells, std::string_view method, std::string_view parameter,
                  std::string_view name, const Plotted& what, const RunIndex& runs) {
  struct Pooled {
    std::vector<double> values;
    json runs = json::array();
  };
  std::map<double, Pooled> by_value;
  for (const Cell& cell : cells) {
    if (cell.place != tuning_place || cell.method != method) continue;
    const auto param = std::ranges::find(cell.params, parameter, &ParamValues::value_type::first);
    Pooled& pooled = by_value[std::get<double>(param->second)];
    std::ranges::copy(values_of(cell, what.quantity), std::back_inserter(pooled.values));
    for (json& run : runs.runs_of(cell.labels())) pooled.runs.push_back(std::move(run));
  }
  json categories = json::array(), boxes = json::array();
  for (auto& [value, pooled] : by_value) {
    categories.push_back(number_text(value));
    boxes.push_back(
        page::linked(page::box(pooled.values), std::move(pooled.runs), page::shown_values(pooled.values)));
  }
  json block{{"kind", "boxes"},          {"title", fmt::format("{} by {}", what.label, name)},
             {"y_label", what.label},    {"category_label", name},
             {"categories", categories}, {"series", {{{"label", method}, {"boxes", boxes}}}}};
  if (what.quantity == "navigation_time_s") block["lines"] = {{{"label", "time limit"}, {"value", 592}}};
  return block;
}

json tuning_grid(const Cells& cells, std::string_view method, const RunIndex& runs) {
  std::vector<std::pair<std::string_view, std::string_view>> parameters{{"crit_dist_m", "CRIT_DIST [m]"},
                                                                        {"ori_error_rad", "ORI_ERROR [rad]"}};
  if (is_orca(method)) {
    parameters.emplace_back("time_step_s", "time_step [s]");
    parameters.emplace_back("time_horizon_s", "time_horizon [s]");
  } else {
    parameters.emplace_back("w2_ratio", "W2");
  }
  std::vector<json> blocks;
  for (const auto& [parameter, name] : parameters) {
    for (const Plotted& what : plotted)
      blocks.push_back(tuning_boxes(cells, method, parameter, name, what, runs));
  }
  return page::grid(4, std::move(blocks));
}

/// A box per robot and method (Figures 18 to 23).
json robot_boxes(const Cells& cells, const CubeCase& cube, const Plotted& what, const RunIndex& runs) {
  json categories = json::array(), series = json::array();
  for (std::size_t robot = 0; robot < cube.team; ++robot) categories.push_back(fmt::format("{}", robot));
  for (const Method& method : methods()) {
    const Cell& cell = find_cell(cells, cube.name, method.name, name_of(Code::as_coded));
    json boxes = json::array();
    for (std::size_t robot = 0; robot < cube.team; ++robot) {
      const std::vector<double> values = values_of(cell, what.quantity, static_cast<int>(robot));
      boxes.push_back(
          page::linked(page::box(values), runs.runs_of(cell.labels()), page::shown_values(values)));
    }
    series.push_back({{"label", method.name}, {"boxes", boxes}});
  }
  return {{"kind", "boxes"},           {"title", what.label},      {"y_label", what.label},
          {"category_label", "robot"}, {"categories", categories}, {"series", series}};
}

std::vector<StudyRow> chosen_rows(std::span<const StudyRow> rows, std::string_view mode) {
  return rows_where(rows, [&](const StudyRow& row) { return row.mode == mode && row.cell != "tuning"; });
}

json intervals(std::span<const StudyRow> rows, std::string_view mode, const Plotted& what,
               const RunIndex& runs) {
  std::vector<std::string> places;
  for (const CubeCase& cube : comparison_cases()) places.emplace_back(cube.name);
  return page::method_intervals(chosen_rows(rows, mode), methods(), what.quantity, what.label, places, runs);
}

json facts(std::span<const StudyRow> rows) {
  std::string covered = "not repeated";
  for (const StudyRow& row : rows) {
    if (row.mode == "as_coded_replicas" && row.quantity == "navigation_time_s_covered_count")
      covered = fmt::format("{:.0f} of 24", row.measured);
  }
  return {page::fact("Published navigation times in the middle 95 % of repeated fives", covered),
          page::fact("Published cases", "6 cases × 4 methods"),
          page::fact("Parameter cells", "36 APF, 108 ORCA")};
}

json corrected_section(std::span<const StudyRow> rows, int seeds, const RunIndex& runs) {
  std::vector<json> blocks;
  for (const Plotted& what : plotted) blocks.push_back(intervals(rows, "corrected", what, runs));
  std::vector<std::string> paragraphs{
      fmt::format("The comparison again with the general methods of this library: repulsion summed afresh at "
                  "each step, velocities in NED, one consistent step of 0.05 s. {} seeds a cell, the same "
                  "for every method, so that differences pair. Bars are 95 % intervals of the mean; the mark "
                  "beside each is the published value, which came from other code.",
                  seeds),
      "Totals of collisions and stuck robots are scaled to five runs. ORCA has no time_step of its own here, "
      "so its retuned case differs from the other in nothing. What a method is told to keep is not what it "
      "is judged by: 3 m between centres is a collision; ORCA is told 6 m, APF pushes from CRIT_DIST on."};
  std::ranges::copy(clearances(rows), std::back_inserter(paragraphs));
  return page::section(
      "corrected", "The methods as printed, in the right frames", std::move(paragraphs),
      {page::grid(2, std::move(blocks)),
       page::comparison_table("Corrected, all cells", chosen_rows(rows, "corrected"), runs),
       page::comparison_table("All told the same", chosen_rows(rows, "corrected_told"), runs)});
}

}  // namespace

json page_of(const Cells& cells, std::span<const StudyRow> rows, const StudyOptions& options) {
  const RunIndex runs{options, {&cells}};
  json sections = json::array();
  sections.push_back(page::section(
      "published", "Published against measured", findings(rows),
      {page::grid(
           2, {intervals(rows, "as_coded", plotted[0], runs), intervals(rows, "as_coded", plotted[3], runs)}),
       page::comparison_table("As coded, all cells", chosen_rows(rows, "as_coded"), runs)}));
  if (options.seeds > 0) {
    sections.push_back(page::section(
        "repeated", "The five runs again and again", {repeated_words},
        {page::comparison_table("As coded, other seeds", chosen_rows(rows, "as_coded_replicas"), runs,
                                repeated_verdicts),
         page::comparison_table("From the recorded starts", chosen_rows(rows, "as_coded_starts"), runs,
                                repeated_verdicts)}));
    sections.push_back(page::section("causes", "What was tried", causes(rows),
                                     {page::comparison_table("Everyone heading north at the origin",
                                                             chosen_rows(rows, "as_coded_north"), runs)}));
  }
  sections.push_back(page::section("tuning-apf", "Parameter setting, APF (Figure 16)", {},
                                   {tuning_grid(cells, "apf", runs)}));
  sections.push_back(page::section("tuning-orca", "Parameter setting, ORCA (Figure 17)", {},
                                   {tuning_grid(cells, "orca3d", runs)}));

  std::vector<json> figures;
  for (const CubeCase& cube : comparison_cases()) {
    std::vector<json> blocks;
    for (const Plotted& what : plotted) blocks.push_back(robot_boxes(cells, cube, what, runs));
    json block = page::grid(2, std::move(blocks));
    block["title"] = fmt::format("{} m cube, {} vehicles{}", 2 * cube.half_edge_m, cube.team,
                                 cube.retuned ? ", retuned" : "");
    figures.push_back(std::move(block));
  }
  sections.push_back(page::section("robots", "Comparison by robot (Figures 18 to 23)",
                                   {"As coded, five runs a box."}, std::move(figures)));
  if (options.seeds > 0) sections.push_back(corrected_section(rows, options.seeds, runs));

  sections.push_back(page::section(
      "run", "A run in detail",
      {"Eight vehicles in the small cube under ORCA as printed, from the first tick under way."},
      chosen_run_blocks(options.overrides, runs)));

  return page::document(
      "Crossing a cube",
      "raja2024: APF and ORCA, each with and without stop-and-wait; 4 and 8 Sparus II vehicles",
      options.command, facts(rows), runs.list(), std::move(sections));
}

}  // namespace fairway::cubes
