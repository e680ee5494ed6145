// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/pledge/pledge.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "fairway/core/math.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/statistics.hpp"
#include "fairway/studies/page_blocks.hpp"
#include "fairway/studies/pledge/crossing.hpp"

namespace fairway::pledges {
namespace {

bool collided(const Cell& cell, std::size_t i) { return cell.value(i, "pair_collision_count") > 0.0; }

/// The least distance of any vehicle's centre to what stands, of all runs [m]; infinity where nothing does.
double least_clearance(const Cell& cell) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<Measure>& run : cell.results) {
    for (const Measure& measure : run)
      if (measure.quantity == "obstacle_clearance_m") least = math::fmin(least, measure.value);
  }
  return least;
}

/// The mean over the vehicles of a run that arrived; NaN if none did.
double mean_time(const Cell& cell, std::size_t i) {
  double sum = 0.0, count = 0.0;
  std::vector<bool> is_stuck;
  for (const Measure& measure : cell.results[i]) {
    if (measure.quantity != "stuck_count" || measure.vehicle == Measure::fleet) continue;
    is_stuck.push_back(measure.value > 0.0);
  }
  for (std::size_t vehicle = 0; const Measure& measure : cell.results[i]) {
    if (measure.quantity != "navigation_time_s" || measure.vehicle == Measure::fleet) continue;
    const bool counts = vehicle < is_stuck.size() && !is_stuck[vehicle] && std::isfinite(measure.value);
    ++vehicle;
    if (!counts) continue;
    sum += measure.value;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : std::nan("");
}

std::vector<double> mean_times(const Cell& cell) {
  std::vector<double> all;
  for (std::size_t i = 0; i < cell.results.size(); ++i) {
    const double time = mean_time(cell, i);
    if (std::isfinite(time)) all.push_back(time);
  }
  return all;
}

std::vector<StudyRow> rows_of(const std::vector<Cell>& cells) {
  std::vector<StudyRow> rows;
  for (const Cell& cell : cells) {
    rows.push_back(share_row(cell, "collision_ratio", count_runs(cell, collided),
                             "runs with a collision; Wilson's interval"));
    std::vector<double> shares;
    for (std::size_t i = 0; i < cell.results.size(); ++i) shares.push_back(cell.value(i, "arrived_ratio"));
    const MeanEstimate arrived = estimate_mean(shares);
    rows.push_back(
        cell_row(cell, "arrived_ratio", arrived.mean, arrived.low, arrived.high, "of the vehicles"));
    const std::vector<double> times = mean_times(cell);
    rows.push_back(mean_row(cell, "navigation_time_s", times, "of the vehicles that arrived"));
    const double straight = estimate_mean(mean_times(straight_cell(cells, cell))).mean;
    const MeanEstimate mean = estimate_mean(times);
    rows.push_back(cell_row(cell, "time_to_direct_ratio", mean.mean / straight, mean.low / straight,
                            mean.high / straight, "to the mean of direct in the same current"));
    const double nearest = least(cell, "min_separation_m");
    rows.push_back(cell_row(cell, "least_separation_m", nearest, nearest, nearest, "of all runs"));
    const double clear = least_clearance(cell);
    if (std::isfinite(clear))
      rows.push_back(cell_row(cell, "least_obstacle_clearance_m", clear, clear, clear,
                              "of a vehicle's centre, of all runs"));
  }
  return rows;
}

std::size_t collision_total(const std::vector<Cell>& cells, std::string_view method) {
  std::size_t total = 0;
  for (const Cell& cell : cells)
    if (cell.method == method) total += count_runs(cell, collided);
  return total;
}

nlohmann::json page_of(const std::vector<Cell>& cells, std::span<const StudyRow> rows,
                       const StudyOptions& options) {
  const RunIndex runs{options, {&cells}};
  nlohmann::json facts = nlohmann::json::array();
  std::vector<nlohmann::json> tables;
  for (const Method& method : methods()) {
    const auto of_method = rows_where(rows, [&](const StudyRow& row) { return row.method == method.name; });
    tables.push_back(page::comparison_table(std::string(method.name), of_method, runs));
    facts.push_back(page::fact(fmt::format("Runs of {} with a collision", method.name),
                               fmt::format("{}", collision_total(cells, method.name))));
  }
  return page::document(
      "Pledge: what can go wrong", "eight AUVs cross a cube of 20 m by what their modems let through",
      options.command, std::move(facts), runs.list(),
      nlohmann::json::array({page::section(
          "conditions", "Under every condition",
          {"A case is how often each vehicle may speak, and which share of words is lost; a mode is the "
           "current to the north [m/s], what breaks on board of one vehicle, and how each one's idea of its "
           "place drifts. Centres that come within 3 m are a collision. Nothing is published."},
          std::move(tables))}));
}

StudyResult run_pledge(const StudyOptions& options) {
  StudyResult result;
  std::vector<Cell> cells = options.seeds > 0 ? crossing_cells(options.seeds) : std::vector<Cell>{};
  const Catalogs catalogs = builtin_catalogs();
  const std::array groups{MeasuredCells{&cells, measured_with(catalogs, measure_run)}};
  if (!make_cells(groups, options)) return {.complete = false};
  if (!cells.empty()) show_run(cells.front().runs.front(), options);
  result.rows = rows_of(cells);
  result.page = page_of(cells, result.rows, options);
  return result;
}

}  // namespace

Study study() {
  return {.name = "pledge",
          .title = "Agreements by modem: what is lost, what flows, what drifts and what breaks",
          .source = "ours: nothing is published, and all of it is variations (--seeds)",
          .run = run_pledge};
}

}  // namespace fairway::pledges
