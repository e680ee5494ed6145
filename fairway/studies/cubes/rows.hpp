// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "fairway/studies/cubes/plan.hpp"

namespace fairway::cubes {

/// A quantity of the published tables.
struct Quantity {
  std::string_view name;
  bool is_total;  ///< published as a total over robots and runs; else as a mean
};
std::span<const Quantity> published_quantities();

/// Published numbers beside measured ones.
///
/// Of each cell: means with a 95 % t interval over runs; totals of collisions and stuck robots, scaled to
/// five runs, with a Poisson interval; the shares of runs in which no two vehicles came within 3 m and within
/// 6 m, with Wilson's interval, and the least separation. Cells of a grid carry their parameters. That nobody
/// collided in the parameter phase is one row, not one for each of its cells.
///
/// Of each cell that repeats the published experiment, instead: means over repetitions, the range of the
/// middle 95 % of them, and the place of the published value; likewise of the standard deviation over the
/// five runs; the share of runs with a collision with Fisher's p; and over all cells how many published
/// values lie in their range, and how many navigation times within 15 %.
std::vector<StudyRow> rows_of(const std::vector<Cell>& cells);

}  // namespace fairway::cubes
