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
using Results = std::vector<CellResults>;

constexpr auto repeated_words =
    "A published value is a mean or a total of five runs. Here the five runs of each cell are repeated; the "
    "interval is the middle 95 % of the repetitions, and the note says how many lie below the published "
    "value. colliding_run_ratio is compared by Fisher's exact test instead.";

struct Plotted {
  std::string_view quantity, label;
};
constexpr std::array plotted{
    Plotted{"navigation_time_s", "Navigation time [s]"}, Plotted{"avoidance_time_s", "Avoidance time [s]"},
    Plotted{"avoided_count", "Avoided encounters"}, Plotted{"distance_m", "Distance [m]"}};

/// A box per value of one parameter, over all cells of the tuning of a method (Figures 16 and 17).
json tuning_boxes(const Results& results, bool orca, double Tuning::*parameter, std::string_view name,
                  const Plotted& what, const RunIndex& runs) {
  struct Pooled {
    std::vector<double> values;
    json runs = json::array();
  };
  std::map<double, Pooled> by_value;
  for (const CellResults& cell : results) {
    if (cell.cell->part != Part::tuning || cell.cell->method->orca != orca) continue;
    Pooled& pooled = by_value[cell.cell->tuning.*parameter];
    std::ranges::copy(cell.values(what.quantity), std::back_inserter(pooled.values));
    for (json& run : runs.runs_of(cell.cell->labels())) pooled.runs.push_back(std::move(run));
  }
  json categories = json::array(), boxes = json::array();
  for (auto& [value, pooled] : by_value) {
    categories.push_back(number_text(value));
    boxes.push_back(
        page::linked(page::box(pooled.values), std::move(pooled.runs), page::shown_values(pooled.values)));
  }
  json block{
      {"kind", "boxes"},          {"title", fmt::format("{} by {}", what.label, name)},
      {"y_label", what.label},    {"category_label", name},
      {"categories", categories}, {"series", {{{"label", orca ? "orca3d" : "apf"}, {"boxes", boxes}}}}};
  if (what.quantity == "navigation_time_s") block["lines"] = {{{"label", "time limit"}, {"value", 592}}};
  return block;
}

json tuning_grid(const Results& results, bool orca, const RunIndex& runs) {
  std::vector<std::pair<double Tuning::*, std::string_view>> parameters{
      {&Tuning::crit_dist_m, "CRIT_DIST [m]"}, {&Tuning::ori_error_rad, "ORI_ERROR [rad]"}};
  if (orca) {
    parameters.emplace_back(&Tuning::time_step_s, "time_step [s]");
    parameters.emplace_back(&Tuning::time_horizon_s, "time_horizon [s]");
  } else {
    parameters.emplace_back(&Tuning::w2_ratio, "W2");
  }
  std::vector<json> blocks;
  for (const auto& [parameter, name] : parameters) {
    for (const Plotted& what : plotted)
      blocks.push_back(tuning_boxes(results, orca, parameter, name, what, runs));
  }
  return page::grid(4, std::move(blocks));
}

const CellResults* find(const Results& results, const CubeCase& cube, const Method& method, Code code) {
  const auto found = std::ranges::find_if(results, [&](const CellResults& r) {
    return r.cell->part == Part::comparison && r.cell->cube == &cube && r.cell->method == &method &&
           r.cell->code == code;
  });
  return found == results.end() ? nullptr : &*found;
}

/// A box per robot and method (Figures 18 to 23).
json robot_boxes(const Results& results, const CubeCase& cube, const Plotted& what, const RunIndex& runs) {
  json categories = json::array(), series = json::array();
  for (std::size_t robot = 0; robot < cube.team; ++robot) categories.push_back(fmt::format("{}", robot));
  for (const Method& method : methods()) {
    const CellResults* cell = find(results, cube, method, Code::as_coded);
    json boxes = json::array();
    for (std::size_t robot = 0; robot < cube.team; ++robot) {
      if (cell == nullptr) {
        boxes.push_back(nullptr);
        continue;
      }
      const std::vector<double> values = cell->values(what.quantity, static_cast<int>(robot));
      boxes.push_back(
          page::linked(page::box(values), runs.runs_of(cell->cell->labels()), page::shown_values(values)));
    }
    series.push_back({{"label", method.name}, {"boxes", boxes}});
  }
  return {{"kind", "boxes"},           {"title", what.label},      {"y_label", what.label},
          {"category_label", "robot"}, {"categories", categories}, {"series", series}};
}

json intervals(const Results& results, Code code, const Plotted& what, const RunIndex& runs) {
  json categories = json::array(), series = json::array();
  for (const CubeCase& cube : comparison_cases()) categories.push_back(cube.name);
  for (const Method& method : methods()) {
    json points = json::array();
    for (const CubeCase& cube : comparison_cases()) {
      const CellResults* cell = find(results, cube, method, code);
      if (cell == nullptr) {
        points.push_back(nullptr);
        continue;
      }
      points.push_back(runs.mark(page::interval(estimate_mean(cell->run_means(what.quantity)),
                                                published(cube.name, method.name, what.quantity)),
                                 cell->cell->labels(), what.quantity));
    }
    series.push_back({{"label", method.name}, {"points", points}});
  }
  return page::intervals(what.label, what.label, std::move(categories), std::move(series));
}

std::vector<StudyRow> chosen_rows(std::span<const StudyRow> rows, std::string_view mode) {
  return rows_where(rows, [&](const StudyRow& row) { return row.mode == mode && row.cell != "tuning"; });
}

RunIndex index_of(const Results& results, const StudyOptions& options) {
  RunIndex index{options};
  for (const CellResults& cell : results) index.add(specs_of(*cell.cell), cell.runs);
  return index;
}

json facts(const Results& results, std::span<const StudyRow> rows) {
  std::size_t runs = 0;
  for (const CellResults& cell : results) runs += cell.runs.size();
  std::string covered = "not repeated";
  for (const StudyRow& row : rows) {
    if (row.mode == "as_coded_replicas" && row.quantity == "navigation_time_s_covered_count")
      covered = fmt::format("{:.0f} of 24", row.measured);
  }
  return {page::fact("Runs", std::to_string(runs)),
          page::fact("Published navigation times within repetitions", covered),
          page::fact("Published cases", "6 cubes × 4 methods"),
          page::fact("Parameter cells", "36 APF, 108 ORCA")};
}

json corrected_section(const Results& results, std::span<const StudyRow> rows, int seeds,
                       const RunIndex& runs) {
  std::vector<json> blocks;
  for (const Plotted& what : plotted) blocks.push_back(intervals(results, Code::corrected, what, runs));
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

json page_of(const Results& results, std::span<const StudyRow> rows, const StudyOptions& options) {
  const RunIndex runs = index_of(results, options);
  json sections = json::array();
  sections.push_back(
      page::section("published", "Published against measured", findings(rows),
                    {page::grid(2, {intervals(results, Code::as_coded, plotted[0], runs),
                                    intervals(results, Code::as_coded, plotted[3], runs)}),
                     page::comparison_table("As coded, all cells", chosen_rows(rows, "as_coded"), runs)}));
  if (options.seeds > 0) {
    sections.push_back(page::section(
        "repeated", "The five runs again and again", {repeated_words},
        {page::comparison_table("As coded, other seeds", chosen_rows(rows, "as_coded_replicas"), runs),
         page::comparison_table("From the recorded starts", chosen_rows(rows, "as_coded_starts"), runs)}));
    sections.push_back(page::section("causes", "What was tried", causes(rows),
                                     {page::comparison_table("Everyone heading north at the origin",
                                                             chosen_rows(rows, "as_coded_north"), runs)}));
  }
  sections.push_back(page::section("tuning-apf", "Parameter setting, APF (Figure 16)", {},
                                   {tuning_grid(results, false, runs)}));
  sections.push_back(page::section("tuning-orca", "Parameter setting, ORCA (Figure 17)", {},
                                   {tuning_grid(results, true, runs)}));

  std::vector<json> figures;
  for (const CubeCase& cube : comparison_cases()) {
    std::vector<json> blocks;
    for (const Plotted& what : plotted) blocks.push_back(robot_boxes(results, cube, what, runs));
    json block = page::grid(2, std::move(blocks));
    block["title"] = fmt::format("{} m cube, {} vehicles{}", 2 * cube.half_edge_m, cube.team,
                                 cube.retuned ? ", retuned" : "");
    figures.push_back(std::move(block));
  }
  sections.push_back(page::section("robots", "Comparison by robot (Figures 18 to 23)",
                                   {"As coded, five runs a box."}, std::move(figures)));
  if (options.seeds > 0) sections.push_back(corrected_section(results, rows, options.seeds, runs));

  sections.push_back(page::section(
      "run", "A run in detail",
      {"Eight vehicles in the small cube under ORCA as printed, from the first tick under way."},
      chosen_run_blocks(options.overrides, runs)));

  return page::document(
      "Crossing a cube",
      "raja2024: APF and ORCA, each with and without stop-and-wait; 4 and 8 Sparus II vehicles", options,
      facts(results, rows), runs, std::move(sections));
}

}  // namespace fairway::cubes
