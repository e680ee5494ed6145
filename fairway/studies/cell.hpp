// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/studies/study_runs.hpp"

namespace fairway {

/// A way of getting there, with its parameters.
struct Method {
  std::string_view name;       ///< in tables
  std::string_view algorithm;  ///< of the catalog
  ParamValues params;
};

/// Runs that differ in their seed only, and what they came to, in order of the seeds.
struct Cell {
  std::string place;   ///< case or kind of field
  std::string method;  ///< as in tables
  std::string mode;    ///< plant, or how it was varied
  std::string part;    ///< of the study, where two parts have a cell of the same place, method and mode
  ParamValues params;  ///< what else tells it from others, where it is one of a grid
  std::vector<StudyRun> runs;
  std::vector<std::vector<Measure>> results;

  /// A quantity of run `i` of the first vehicle or the fleet; NaN where it was not measured.
  double value(std::size_t i, std::string_view quantity) const;

  /// What its runs share.
  Labels labels() const;

  /// Plans a run for each of `count` seeds from `first` on. Its key holds a digest of `scenario(seed)`, so
  /// that a changed scenario makes another run; where scenarios differ in nothing but what the seed draws,
  /// `one_digest` may serve them all.
  void add_runs(std::string_view study, int count, const std::function<Scenario(std::uint64_t)>& scenario,
                std::uint64_t first = 1, bool one_digest = false);
};

/// A cell with a run for each of the seeds 1, 2, ...
Cell planned_cell(std::string_view study, std::string_view place, std::string_view method,
                  std::string_view mode, int seeds, const std::function<Scenario(std::uint64_t)>& scenario);

/// The labels of a cell; `part` and `params` where it has them.
Labels cell_labels(std::string_view place, std::string_view method, std::string_view mode,
                   std::string_view part = "", const ParamValues& params = {});

/// Cells that are measured alike.
struct MeasuredCells {
  std::vector<Cell>* cells{};
  MeasureRun measure;
};

/// Makes what the store lacks of all runs of all cells, and hands out the results. False if stopped before,
/// or if one run was to be shown alone. Throws as make_runs().
bool make_cells(std::span<const MeasuredCells> groups, const StudyOptions& options);

/// The cell of that place, method and mode. Throws std::out_of_range.
const Cell& find_cell(const std::vector<Cell>& cells, std::string_view place, std::string_view method,
                      std::string_view mode);

// what became of run `i` of the first vehicle
bool arrived(const Cell& cell, std::size_t i);
bool touched(const Cell& cell, std::size_t i);    ///< its sphere met an obstacle
bool succeeded(const Cell& cell, std::size_t i);  ///< arrived, nothing touched

/// Runs of which `is` holds.
std::size_t count_runs(const Cell& cell, bool (*is)(const Cell&, std::size_t));

/// The finite values of a quantity over the runs that arrived.
std::vector<double> of_arrived(const Cell& cell, std::string_view quantity);

/// The least value of a quantity over all runs.
double least(const Cell& cell, std::string_view quantity);

/// The rows of which `holds` is true, and those in a mode.
std::vector<StudyRow> rows_where(std::span<const StudyRow> rows,
                                 const std::function<bool(const StudyRow&)>& holds);
std::vector<StudyRow> rows_in_mode(std::span<const StudyRow> rows, std::string_view mode);

/// A row of the cell's, without a published value.
StudyRow cell_row(const Cell& cell, std::string_view quantity, double measured = 0.0,
                  double low = -std::numeric_limits<double>::infinity(),
                  double high = std::numeric_limits<double>::infinity(), std::string note = "");

/// The share that `count` runs are of all, with Wilson's 95 % interval.
StudyRow share_row(const Cell& cell, std::string_view quantity, std::size_t count, std::string note);

/// The mean over the runs that arrived, with its 95 % interval; the note says how many are left out.
StudyRow mean_row(const Cell& cell, std::string_view quantity);
/// The mean of `values`, one of each run that has one, likewise.
StudyRow mean_row(const Cell& cell, std::string_view quantity, const std::vector<double>& values,
                  std::string note);

}  // namespace fairway
