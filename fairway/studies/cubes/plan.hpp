// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/experiment/run.hpp"
#include "fairway/studies/cubes/cube_case.hpp"
#include "fairway/studies/cubes/published.hpp"

namespace fairway::cubes {

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
  std::uint64_t first_seed{1};
  ParamValues heard;  ///< of AsHeard, of the modes that say timing
  double told_m{};    ///< of what is corrected_told

  Scenario scenario(std::uint64_t seed) const {
    return cube_scenario(*cube, *method, code, tuning, seed, heard);
  }

  /// "tuning", or the name of the case.
  std::string name() const { return part == Part::tuning ? "tuning" : std::string(cube->name); }

  /// The parameters that tell it from cells of the same case, method and code.
  ParamValues varied() const;

  Labels labels() const;
};

/// 36 APF and 108 ORCA cells of five runs (raja2024, section V-A).
std::vector<Cell> tuning_cells();

/// Six cases by four methods (section V-B).
std::vector<Cell> comparison_cells(Code code, int runs);

/// The cells in which the heading at the origin matters most: APF, eight vehicles, the large cube.
std::vector<Cell> heading_cells();

/// The published comparison that many times, five runs a cell each time, on seeds from 6 on, so that none is
/// a run of the published part.
std::vector<Cell> replica_cells(Code code, int replicas);

/// Potential fields from drawn headings and from recorded starts, with messages and odometry late, lost,
/// noisy or out of step.
std::vector<Cell> timing_cells(int runs);

/// The corrected methods, all told to keep 3 m and all told to keep 6 m between centres: ORCA by its radii,
/// potential fields by a CRIT_DIST of twice as much, which is what 3 m and the published 6 m are. The printed
/// repulsion depends on distance / CRIT_DIST alone.
std::vector<Cell> told_cells(int runs);

/// The runs of one cell, by seed; those of different cells pair by it.
std::vector<RunSpec> specs_of(const Cell& cell);

/// The results of a cell: for each run, by seed, its measures.
struct CellResults {
  const Cell* cell{};
  std::vector<std::vector<Measure>> runs;

  /// The values of a quantity, one for each vehicle and run; or of one vehicle only.
  std::vector<double> values(std::string_view quantity, std::optional<int> vehicle = {}) const;

  /// One for each run: the mean over its vehicles.
  std::vector<double> run_means(std::string_view quantity) const;

  /// One for each run: the sum over its vehicles.
  std::vector<double> run_totals(std::string_view quantity) const;

  /// How many runs had a collision.
  std::size_t colliding_runs() const;

  /// Over all vehicles and runs.
  double total(std::string_view quantity) const;
};

}  // namespace fairway::cubes
