// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/replicas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "fairway/core/rng.hpp"
#include "fairway/experiment/statistics.hpp"

namespace fairway::cubes {
namespace {

constexpr double alike_within = 0.15;

/// Sets what was measured, its middle 95 %, and the place and verdict of what was published.
void compare(StudyRow& row, std::vector<double> repeated, std::optional<double> published_value) {
  if (repeated.empty()) return;
  std::ranges::sort(repeated);
  row.published = published_value;
  row.measured = estimate_mean(repeated).mean;
  row.low = quantile(repeated, 0.025);
  row.high = quantile(repeated, 0.975);
  if (!published_value) return;
  row.place_ratio = place_among(*published_value, repeated);
  const bool covered = row.low <= *published_value && *published_value <= row.high;
  row.verdict = covered ? Verdict::within_spread : Verdict::not_reproduced;
  row.note =
      fmt::format("five of {} runs, drawn {} times; {:.0f} % of the draws lie below the published value",
                  row.runs, repeated.size(), 100 * *row.place_ratio);
}

/// Five different runs of so many, drawn again and again; the same for the same number of runs.
std::vector<std::array<std::size_t, published_runs>> fives_of(std::size_t runs, const Cell& cell) {
  std::vector<std::array<std::size_t, published_runs>> fives;
  if (runs < published_runs) return fives;
  Rng rng = Rng{0}.stream(cell.place + cell.method, runs);
  std::vector<std::size_t> order(runs);
  std::iota(order.begin(), order.end(), std::size_t{0});
  fives.resize(repetition_count);
  for (auto& five : fives) {
    for (std::size_t i = 0; i < five.size(); ++i) {
      std::swap(order[i], order[i + rng.index(runs - i)]);
      five[i] = order[i];
    }
  }
  return fives;
}

/// The standard deviation of five runs' navigation times, one for each repetition.
std::vector<double> deviations(const Cell& cell) {
  const std::vector<double> means = run_means(cell, "navigation_time_s");
  std::vector<double> found;
  for (const auto& five : fives_of(means.size(), cell)) {
    std::array<double, published_runs> values{};
    std::ranges::transform(five, values.begin(), [&](std::size_t run) { return means[run]; });
    found.push_back(estimate_mean(values).deviation);
  }
  return found;
}

StudyRow colliding_row(const Cell& cell, const PublishedCell& published_cell) {
  const auto there = static_cast<std::size_t>(published_cell.colliding_run_count);
  const std::size_t here = colliding_runs(cell), runs = cell.results.size();
  StudyRow row =
      share_row(cell, "colliding_run_ratio", here,
                fmt::format("{} of 5 runs published, {} of {} here; Fisher's exact test", there, here, runs));
  row.published = static_cast<double>(there) / published_runs;
  row.p_value = fisher_exact(there, published_runs, here, runs);
  row.verdict = *row.p_value < 0.05 ? Verdict::not_reproduced : Verdict::within_spread;
  return row;
}

StudyRow summary_row(const StudyRow& like, std::string quantity) {
  return {
      .cell = "all", .method = "all", .mode = like.mode, .quantity = std::move(quantity), .runs = like.runs};
}

/// How many published values of a quantity lie in the middle 95 % of the repetitions.
StudyRow covered_row(std::span<const StudyRow> rows, std::string_view quantity) {
  StudyRow row = summary_row(rows.front(), fmt::format("{}_covered_count", quantity));
  int all = 0;
  for (const StudyRow& cell : rows) {
    if (cell.quantity != quantity || !cell.place_ratio) continue;
    row.measured += cell.verdict == Verdict::within_spread ? 1 : 0;
    ++all;
  }
  row.note = fmt::format("of {} published values, those within the middle 95 % of the repetitions", all);
  return row;
}

/// How many cells of one repetition come within 15 % of the published value.
StudyRow alike_row(std::span<const Cell* const> cells, const Quantity& quantity, const StudyRow& like) {
  StudyRow row = summary_row(like, fmt::format("{}_within_15_percent_count", quantity.name));
  std::vector<double> counts;
  for (const Cell* cell : cells) {
    const auto there = published(cell->place, cell->method, quantity.name);
    const std::vector<double> repeated = repetitions(*cell, quantity);
    counts.resize(std::max(counts.size(), repeated.size()));
    for (std::size_t i = 0; there && i < repeated.size(); ++i)
      counts[i] += std::abs(repeated[i] / *there - 1.0) <= alike_within ? 1 : 0;
  }
  compare(row, std::move(counts), std::nullopt);
  row.note = fmt::format("of {} cells, in each repetition; the range is the middle 95 %", cells.size());
  return row;
}

}  // namespace

bool is_repeated(const Cell& cell) {
  return std::ranges::any_of(repeated_codes, [&](Code code) { return cell.mode == name_of(code); });
}

std::vector<double> repetitions(const Cell& cell, const Quantity& quantity) {
  const std::vector<double> runs =
      quantity.is_total ? run_totals(cell, quantity.name) : run_means(cell, quantity.name);
  std::vector<double> repeated;
  for (const auto& five : fives_of(runs.size(), cell)) {
    double sum = 0.0;
    for (const std::size_t run : five) sum += runs[run];
    repeated.push_back(quantity.is_total ? sum : sum / published_runs);
  }
  return repeated;
}

std::optional<double> place_among(double value, std::span<const double> others) {
  if (others.empty()) return std::nullopt;
  double below = 0.0;
  for (const double other : others) below += other < value ? 1.0 : other == value ? 0.5 : 0.0;
  return below / static_cast<double>(others.size());
}

void add_replica_rows(std::vector<StudyRow>& rows, const std::vector<Cell>& all, Code code) {
  std::vector<const Cell*> cells;
  for (const Cell& cell : all) {
    if (cell.mode == name_of(code) && cell.results.size() >= published_runs) cells.push_back(&cell);
  }
  if (cells.empty()) return;

  std::vector<StudyRow> mine;
  for (const Cell* cell : cells) {
    const PublishedCell* there = published_cell(cell->place, cell->method);
    if (there == nullptr) continue;
    for (const Quantity& quantity : published_quantities()) {
      compare(mine.emplace_back(cell_row(*cell, quantity.name)), repetitions(*cell, quantity),
              published(there->cube, there->method, quantity.name));
    }
    compare(mine.emplace_back(cell_row(*cell, "navigation_time_deviation_s")), deviations(*cell),
            there->navigation_time_s.deviation);
    mine.push_back(colliding_row(*cell, *there));
  }
  std::vector<StudyRow> summary;
  for (const Quantity& quantity : published_quantities()) {
    summary.push_back(covered_row(mine, quantity.name));
    if (!quantity.is_total) summary.push_back(alike_row(cells, quantity, mine.front()));
  }
  summary.push_back(covered_row(mine, "navigation_time_deviation_s"));
  std::ranges::move(mine, std::back_inserter(rows));
  std::ranges::move(summary, std::back_inserter(rows));
}

}  // namespace fairway::cubes
