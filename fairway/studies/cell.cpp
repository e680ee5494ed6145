// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fairway/core/math.hpp"
#include "fairway/core/text.hpp"
#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/statistics.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway {

double Cell::value(std::size_t i, std::string_view quantity) const {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (i >= results.size()) return unknown;
  for (const Measure& measure : results[i]) {
    if (measure.quantity == quantity) return measure.value;
  }
  return unknown;
}

void Cell::add_runs(std::string_view study, int count, const std::function<Scenario(std::uint64_t)>& scenario,
                    std::uint64_t first, bool one_digest) {
  const auto digest_of = [&](std::uint64_t seed) { return Digest::of(to_yaml(scenario(seed))); };
  const std::string common = one_digest ? digest_of(0) : "";
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed) {
    std::string key = fmt::format("{}/{}/{}/{}/{}/{}/{}", study, place, method, mode,
                                  one_digest ? common : digest_of(seed), results_epoch, seed);
    runs.push_back({{std::move(key), labels(), seed, {}}, [scenario, seed] { return scenario(seed); }, {}});
  }
}

Cell planned_cell(std::string_view study, std::string_view place, std::string_view method,
                  std::string_view mode, int seeds, const std::function<Scenario(std::uint64_t)>& scenario) {
  Cell cell{.place = std::string(place), .method = std::string(method), .mode = std::string(mode)};
  cell.add_runs(study, seeds, scenario);
  return cell;
}

Labels Cell::labels() const { return cell_labels(place, method, mode, part, params); }

Labels cell_labels(std::string_view place, std::string_view method, std::string_view mode,
                   std::string_view part, const ParamValues& params) {
  Labels labels{{"case", std::string(place)}, {"method", std::string(method)}, {"mode", std::string(mode)}};
  if (!part.empty()) labels.emplace_back("part", std::string(part));
  for (const auto& [name, value] : params) {
    const double* number = std::get_if<double>(&value);
    labels.emplace_back(name, number != nullptr ? number_text(*number) : "true");
  }
  return labels;
}

bool make_cells(std::span<const MeasuredCells> groups, const StudyOptions& options) {
  std::vector<StudyRun> runs;
  for (const MeasuredCells& group : groups) {
    for (Cell& cell : *group.cells) {
      for (StudyRun& run : cell.runs) run.measure = group.measure;
      std::ranges::copy(cell.runs, std::back_inserter(runs));
    }
  }
  auto measures = make_runs(runs, options);
  if (!measures) return false;

  auto next = measures->begin();
  for (const MeasuredCells& group : groups) {
    for (Cell& cell : *group.cells) {
      for (std::size_t i = 0; i < cell.runs.size(); ++i) cell.results.push_back(std::move(*next++));
    }
  }
  return true;
}

const Cell& find_cell(const std::vector<Cell>& cells, std::string_view place, std::string_view method,
                      std::string_view mode) {
  for (const Cell& cell : cells) {
    if (cell.place == place && cell.method == method && cell.mode == mode) return cell;
  }
  throw std::out_of_range(fmt::format("no cell {} {} {}", place, method, mode));
}

bool arrived(const Cell& cell, std::size_t i) { return cell.value(i, "arrived_ratio") == 1.0; }
bool touched(const Cell& cell, std::size_t i) { return cell.value(i, "footprint_clearance_m") < 0.0; }
bool succeeded(const Cell& cell, std::size_t i) { return arrived(cell, i) && !touched(cell, i); }

std::size_t count_runs(const Cell& cell, bool (*is)(const Cell&, std::size_t)) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < cell.results.size(); ++i) count += is(cell, i) ? 1 : 0;
  return count;
}

std::vector<double> of_arrived(const Cell& cell, std::string_view quantity) {
  std::vector<double> values;
  for (std::size_t i = 0; i < cell.results.size(); ++i) {
    const double value = cell.value(i, quantity);
    if (arrived(cell, i) && std::isfinite(value)) values.push_back(value);
  }
  return values;
}

double least(const Cell& cell, std::string_view quantity) {
  double value = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cell.results.size(); ++i) value = math::fmin(value, cell.value(i, quantity));
  return value;
}

std::vector<StudyRow> rows_where(std::span<const StudyRow> rows,
                                 const std::function<bool(const StudyRow&)>& holds) {
  std::vector<StudyRow> chosen;
  std::ranges::copy_if(rows, std::back_inserter(chosen), holds);
  return chosen;
}

std::vector<StudyRow> rows_in_mode(std::span<const StudyRow> rows, std::string_view mode) {
  return rows_where(rows, [&](const StudyRow& row) { return row.mode == mode; });
}

StudyRow cell_row(const Cell& cell, std::string_view quantity, double measured, double low, double high,
                  std::string note) {
  return {.cell = cell.place,
          .method = cell.method,
          .mode = cell.mode,
          .part = cell.part,
          .quantity = std::string(quantity),
          .params = cell.params,
          .measured = measured,
          .low = low,
          .high = high,
          .runs = static_cast<int>(cell.results.size()),
          .note = std::move(note)};
}

StudyRow share_row(const Cell& cell, std::string_view quantity, std::size_t count, std::string note) {
  const RateEstimate rate = wilson_interval(count, cell.results.size());
  return cell_row(cell, quantity, rate.rate, rate.low, rate.high, std::move(note));
}

StudyRow mean_row(const Cell& cell, std::string_view quantity) {
  return mean_row(cell, quantity, of_arrived(cell, quantity), "of the runs that arrived");
}

StudyRow mean_row(const Cell& cell, std::string_view quantity, const std::vector<double>& values,
                  std::string note) {
  const MeanEstimate mean = estimate_mean(values);
  if (const std::size_t left_out = cell.results.size() - values.size(); left_out > 0)
    note += fmt::format("; {} of {} left out", left_out, cell.results.size());
  return cell_row(cell, quantity, mean.mean, mean.low, mean.high, std::move(note));
}

}  // namespace fairway
