// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "fairway/studies/cubes/cube_case.hpp"
#include "fairway/studies/cubes/published.hpp"

namespace fairway::cubes {

/// The place of the cells of the parameter phase.
inline constexpr std::string_view tuning_place = "tuning";

/// 36 APF and 108 ORCA cells of five runs (raja2024, section V-A), each with the parameters that are tried.
std::vector<Cell> tuning_cells();

/// Six cases by four methods (section V-B), `runs` each on the seeds from `first_seed` on.
std::vector<Cell> comparison_cells(Code code, int runs, std::uint64_t first_seed = 1);

/// The cells in which the heading at the origin matters most: APF, eight vehicles, the large cube.
std::vector<Cell> heading_cells();

/// The published comparison that many times, five runs a cell each time, on seeds from 6 on, so that none is
/// a run of the published part.
std::vector<Cell> replica_cells(Code code, int replicas);

/// Potential fields from drawn headings and from recorded starts, with messages and odometry late, lost,
/// noisy or out of step, as the parameters of the cell say (AsHeard).
std::vector<Cell> timing_cells(int runs);

/// The corrected methods, all told to keep 3 m and all told to keep 6 m between centres: ORCA by its radii,
/// potential fields by a CRIT_DIST of twice as much, which is what 3 m and the published 6 m are. The printed
/// repulsion depends on distance / CRIT_DIST alone. `told_m` is the parameter of the cell.
std::vector<Cell> told_cells(int runs);

/// The values of a quantity of a cell, one for each vehicle and run; or of one vehicle only.
std::vector<double> values_of(const Cell& cell, std::string_view quantity, std::optional<int> vehicle = {});

/// One for each run of a cell: the mean over its vehicles.
std::vector<double> run_means(const Cell& cell, std::string_view quantity);

/// One for each run of a cell: the sum over its vehicles.
std::vector<double> run_totals(const Cell& cell, std::string_view quantity);

/// How many runs of a cell had a collision.
std::size_t colliding_runs(const Cell& cell);

}  // namespace fairway::cubes
