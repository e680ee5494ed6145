// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "fairway/studies/cubes/rows.hpp"

namespace fairway::cubes {

/// Those whose cells are the published five runs again and again.
inline constexpr std::array repeated_codes{Code::as_coded_replicas, Code::as_coded_starts};
bool is_repeated(const Cell& cell);

/// How often five runs are drawn.
inline constexpr int repetition_count = 2000;

/// A quantity of five different runs drawn from the cell's, again and again: the mean of the five, or their
/// sum. Of fewer than five runs, none. The draws are the same for every quantity of a cell.
std::vector<double> repetitions(const Cell& cell, const Quantity& quantity);

/// Where a value lies among others: the share below it, ties counted half. Of none, nothing.
std::optional<double> place_among(double value, std::span<const double> others);

/// The rows of a repeated code: see rows_of().
void add_replica_rows(std::vector<StudyRow>& rows, const std::vector<Cell>& cells, Code code);

}  // namespace fairway::cubes
