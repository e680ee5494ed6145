// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "fairway/experiment/statistics.hpp"
#include "fairway/studies/cubes/replicas.hpp"

namespace fairway::cubes {
namespace {

constexpr std::array quantities{Quantity{"navigation_time_s", false}, Quantity{"avoidance_time_s", false},
                                Quantity{"avoided_count", false},     Quantity{"distance_m", false},
                                Quantity{"collision_count", true},    Quantity{"stuck_count", true}};

std::optional<double> published_in(const Cell& cell, std::string_view quantity) {
  if (cell.part == Part::comparison) return published(cell.name(), cell.method->name, quantity);
  if (quantity == "navigation_time_s") return published_tuning_time(cell.method->orca, cell.tuning);
  if (quantity == "stuck_count" && !cell.method->orca) return published_tuning_stuck(cell.tuning);
  return std::nullopt;
}

/// Robots that were stuck under APF in the whole parameter phase, as published.
double published_stuck() {
  double stuck = 0.0;
  for (const Cell& cell : tuning_cells()) {
    if (!cell.method->orca) stuck += published_tuning_stuck(cell.tuning).value_or(0.0);
  }
  return stuck;
}

void estimate(StudyRow& row, const CellResults& results, bool is_total) {
  if (is_total) {
    const double scale = published_runs / static_cast<double>(results.runs.size());
    const CountEstimate total = poisson_interval(results.total(row.quantity));
    row.measured = scale * total.count;
    row.low = scale * total.low;
    row.high = scale * total.high;
  } else {
    const MeanEstimate mean = estimate_mean(results.run_means(row.quantity));
    row.measured = mean.mean;
    row.low = mean.low;
    row.high = mean.high;
  }
  judge(row, is_total);
}

/// Tests the runs that had a collision against those published.
void test_collisions(StudyRow& row, const CellResults& results) {
  const PublishedCell* cell = published_cell(row.cell, row.method);
  if (cell == nullptr || row.quantity != "collision_count" || !is_as_coded(results.cell->code)) return;
  const std::size_t here = results.colliding_runs(), runs = results.runs.size();
  const auto there = static_cast<std::size_t>(cell->colliding_run_count);
  row.p_value = fisher_exact(there, published_runs, here, runs);
  row.note = fmt::format("in {} of 5 published runs and {} of {} here: Fisher's p = {:.2g}", there, here,
                         runs, *row.p_value);
}

StudyRow row_of(const CellResults& results, const Quantity& quantity) {
  StudyRow row = blank_row(results, quantity.name);
  row.published = published_in(*results.cell, quantity.name);
  estimate(row, results, quantity.is_total);
  test_collisions(row, results);
  return row;
}

/// A share of runs, with Wilson's interval.
StudyRow share_row(const CellResults& results, std::string_view quantity, double distance) {
  StudyRow row = blank_row(results, quantity);
  const RateEstimate rate = kept_apart(results, distance);
  row.measured = rate.rate;
  row.low = rate.low;
  row.high = rate.high;
  row.note =
      fmt::format("share of runs in which no two vehicles came within {:g} m; Wilson's interval", distance);
  return row;
}

StudyRow separation_row(const CellResults& results) {
  StudyRow row = blank_row(results, "min_separation_m");
  const std::vector<double> least = results.run_means("min_separation_m");
  row.measured = least.empty() ? std::numeric_limits<double>::quiet_NaN() : std::ranges::min(least);
  row.note = "least distance between two centres in all runs";
  return row;
}

/// A total of the whole parameter phase, of the methods of which it is asked.
void add_tuning_total(std::vector<StudyRow>& rows, const std::vector<CellResults>& results,
                      std::string_view quantity, std::string_view method, double published) {
  StudyRow row{
      .cell = "tuning", .method = std::string(method), .mode = "as_coded", .quantity = std::string(quantity)};
  double total = 0.0;
  int cells = 0;
  for (const CellResults& cell : results) {
    if (cell.cell->part != Part::tuning || (method != "all" && cell.cell->method->name != method)) continue;
    total += cell.total(quantity);
    row.runs += static_cast<int>(cell.runs.size());
    ++cells;
  }
  if (row.runs == 0) return;
  const CountEstimate estimate = poisson_interval(total);
  row.published = published;
  row.measured = estimate.count;
  row.low = estimate.low;
  row.high = estimate.high;
  row.note = fmt::format("one total over {} cells", cells);
  judge(row, true);
  rows.push_back(std::move(row));
}

void add_cell(std::vector<StudyRow>& rows, const CellResults& results) {
  const bool is_tuning = results.cell->part == Part::tuning;
  for (const Quantity& quantity : quantities) {
    const bool in_total =
        quantity.name == "collision_count" || (quantity.name == "stuck_count" && results.cell->method->orca);
    if (!(is_tuning && in_total)) rows.push_back(row_of(results, quantity));
  }
  rows.push_back(share_row(results, "collision_free_ratio", 3.0));
  if (is_tuning) return;
  rows.push_back(share_row(results, "clear_of_6m_ratio", 6.0));
  rows.push_back(separation_row(results));
}

}  // namespace

std::span<const Quantity> published_quantities() { return quantities; }

StudyRow blank_row(const CellResults& results, std::string_view quantity) {
  const Cell& cell = *results.cell;
  return {.cell = cell.name(),
          .method = std::string(cell.method->name),
          .mode = std::string(name_of(cell.code)),
          .quantity = std::string(quantity),
          .params = cell.varied(),
          .runs = static_cast<int>(results.runs.size())};
}

RateEstimate kept_apart(const CellResults& results, double distance) {
  const std::vector<double> least = results.run_means("min_separation_m");
  // exactly so far apart is a collision, as the metric counts them
  const auto kept = std::ranges::count_if(least, [&](double separation) { return separation > distance; });
  return wilson_interval(static_cast<std::size_t>(kept), least.size());
}

std::vector<StudyRow> rows_of(const std::vector<CellResults>& results) {
  std::vector<StudyRow> rows;
  for (const CellResults& cell : results) {
    if (!is_repeated(cell.cell->code)) add_cell(rows, cell);
  }
  add_tuning_total(rows, results, "collision_count", "all", 0);
  add_tuning_total(rows, results, "stuck_count", "apf", published_stuck());
  add_tuning_total(rows, results, "stuck_count", "orca3d", 0);
  for (const Code code : {Code::as_coded_replicas, Code::as_coded_starts})
    add_replica_rows(rows, results, code);
  return rows;
}

}  // namespace fairway::cubes
