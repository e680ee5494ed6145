// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fairway/experiment/run.hpp"
#include "fairway/studies/cubes/cube_case.hpp"

namespace fairway::cubes {

/// A cell as published.
inline constexpr int published_runs = 5;

/// Which part of the experiment a run belongs to.
enum class Part { tuning, comparison };

/// Runs that differ in their seed only.
struct Cell {
  Part part{};
  const CubeCase* cube{};
  const Method* method{};
  Code code{};
  Tuning tuning;
  int runs{};

  /// "tuning", or the name of the case.
  std::string name() const { return part == Part::tuning ? "tuning" : std::string(cube->name); }

  /// The parameters that the published tuning varies.
  ParamValues varied() const;

  Labels labels() const;
};

/// 36 APF and 108 ORCA cells of five runs (raja2024, section V-A).
std::vector<Cell> tuning_cells();

/// Six cases by four methods (section V-B).
std::vector<Cell> comparison_cells(Code code, int runs);

/// The cells in which the heading at the origin matters most: APF, eight vehicles, the large cube.
std::vector<Cell> heading_cells();

/// One run of a cell.
struct PlannedRun {
  const Cell* cell{};
  RunSpec spec;
};

/// The runs of one cell, seeds 1, 2, …
std::vector<RunSpec> specs_of(const Cell& cell);

/// Every run of the cells, seeds 1, 2, … in each, so that runs of different cells pair by seed. `cells` must
/// outlive the plan.
std::vector<PlannedRun> plan_of(const std::vector<Cell>& cells);

/// The results of a cell: for each run, by seed, its measures.
struct CellResults {
  const Cell* cell{};
  std::vector<std::vector<Measure>> runs;

  /// The values of a quantity, one for each vehicle and run; or for vehicle `index` only.
  std::vector<double> values(std::string_view quantity, int vehicle = -2) const;

  /// One for each run: the mean over its vehicles.
  std::vector<double> run_means(std::string_view quantity) const;

  /// Over all vehicles and runs.
  double total(std::string_view quantity) const;
};

}  // namespace fairway::cubes
