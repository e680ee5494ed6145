// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "fairway/experiment/statistics.hpp"
#include "fairway/studies/cubes/replicas.hpp"

namespace fairway::cubes {
namespace {

constexpr std::array quantities{Quantity{"navigation_time_s", false}, Quantity{"avoidance_time_s", false},
                                Quantity{"avoided_count", false},     Quantity{"distance_m", false},
                                Quantity{"collision_count", true},    Quantity{"stuck_count", true}};

std::optional<double> published_in(const Cell& cell, std::string_view quantity) {
  if (cell.place != tuning_place) return published(cell.place, cell.method, quantity);
  if (quantity == "navigation_time_s") return published_tuning_time(cell.params);
  if (quantity == "stuck_count") return published_tuning_stuck(cell.params);
  return std::nullopt;
}

/// Robots that were stuck under APF in the whole parameter phase, as published.
double published_stuck() {
  double stuck = 0.0;
  for (const Cell& cell : tuning_cells()) stuck += published_tuning_stuck(cell.params).value_or(0.0);
  return stuck;
}

double total_of(const Cell& cell, std::string_view quantity) {
  const std::vector<double> totals = run_totals(cell, quantity);
  return std::accumulate(totals.begin(), totals.end(), 0.0);
}

void estimate(StudyRow& row, const Cell& cell, bool is_total) {
  if (is_total) {
    const double scale = published_runs / static_cast<double>(cell.results.size());
    const CountEstimate total = poisson_interval(total_of(cell, row.quantity));
    row.measured = scale * total.count;
    row.low = scale * total.low;
    row.high = scale * total.high;
  } else {
    const MeanEstimate mean = estimate_mean(run_means(cell, row.quantity));
    row.measured = mean.mean;
    row.low = mean.low;
    row.high = mean.high;
  }
  judge(row, is_total);
}

/// Tests the runs that had a collision against those published.
void test_collisions(StudyRow& row, const Cell& cell) {
  const PublishedCell* there = published_cell(row.cell, row.method);
  if (there == nullptr || row.quantity != "collision_count" || !row.mode.starts_with("as_coded")) return;
  const std::size_t here = colliding_runs(cell), runs = cell.results.size();
  const auto published = static_cast<std::size_t>(there->colliding_run_count);
  row.p_value = fisher_exact(published, published_runs, here, runs);
  row.note = fmt::format("in {} of 5 published runs and {} of {} here: Fisher's p = {:.2g}", published, here,
                         runs, *row.p_value);
}

StudyRow row_of(const Cell& cell, const Quantity& quantity) {
  StudyRow row = cell_row(cell, quantity.name);
  row.published = published_in(cell, quantity.name);
  estimate(row, cell, quantity.is_total);
  test_collisions(row, cell);
  return row;
}

StudyRow kept_apart_row(const Cell& cell, std::string_view quantity, double distance) {
  // exactly so far apart is a collision, as the metric counts them
  const auto kept = std::ranges::count_if(run_means(cell, "min_separation_m"),
                                          [&](double separation) { return separation > distance; });
  return share_row(
      cell, quantity, static_cast<std::size_t>(kept),
      fmt::format("share of runs in which no two vehicles came within {:g} m; Wilson's interval", distance));
}

StudyRow separation_row(const Cell& cell) {
  StudyRow row = cell_row(cell, "min_separation_m", least(cell, "min_separation_m"));
  row.note = "least distance between two centres in all runs";
  return row;
}

/// A total of the whole parameter phase, of the methods of which it is asked.
void add_tuning_total(std::vector<StudyRow>& rows, const std::vector<Cell>& all, std::string_view quantity,
                      std::string_view method, double published) {
  StudyRow row{.cell = std::string(tuning_place),
               .method = std::string(method),
               .mode = "as_coded",
               .quantity = std::string(quantity)};
  double total = 0.0;
  int cells = 0;
  for (const Cell& cell : all) {
    if (cell.place != tuning_place || (method != "all" && cell.method != method)) continue;
    total += total_of(cell, quantity);
    row.runs += static_cast<int>(cell.results.size());
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

void add_cell(std::vector<StudyRow>& rows, const Cell& cell) {
  const bool is_tuning = cell.place == tuning_place;
  for (const Quantity& quantity : quantities) {
    const bool in_total =
        quantity.name == "collision_count" || (quantity.name == "stuck_count" && is_orca(cell.method));
    if (!(is_tuning && in_total)) rows.push_back(row_of(cell, quantity));
  }
  rows.push_back(kept_apart_row(cell, "collision_free_ratio", 3.0));
  if (is_tuning) return;
  rows.push_back(kept_apart_row(cell, "clear_of_6m_ratio", 6.0));
  rows.push_back(separation_row(cell));
}

}  // namespace

std::span<const Quantity> published_quantities() { return quantities; }

std::vector<StudyRow> rows_of(const std::vector<Cell>& cells) {
  std::vector<StudyRow> rows;
  for (const Cell& cell : cells) {
    if (!is_repeated(cell)) add_cell(rows, cell);
  }
  add_tuning_total(rows, cells, "collision_count", "all", 0);
  add_tuning_total(rows, cells, "stuck_count", "apf", published_stuck());
  add_tuning_total(rows, cells, "stuck_count", "orca3d", 0);
  for (const Code code : repeated_codes) add_replica_rows(rows, cells, code);
  return rows;
}

}  // namespace fairway::cubes
