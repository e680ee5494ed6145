// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fairway/studies/cubes/plan.hpp"
#include "fairway/studies/study.hpp"

namespace fairway::cubes {

/// A quantity of the published tables.
struct Quantity {
  std::string_view name;
  bool is_total;  ///< published as a total over robots and runs; else as a mean
};
std::span<const Quantity> published_quantities();

/// Every published number beside the measured one: means with a 95 % t interval over runs; totals of
/// collisions and stuck robots, scaled to five runs, with a Poisson interval; the share of runs without
/// collision with Wilson's interval. Tuning cells carry their parameters.
std::vector<StudyRow> rows_of(const std::vector<CellResults>& results);

/// What was found out about the differences, by experiment (docs/studies/cubes.md).
std::vector<std::string> causes(std::span<const StudyRow> rows);

/// What the rows say of the published claims, in sentences: trends of the parameter phase, cells that do not
/// reproduce and why.
std::vector<std::string> findings(const std::vector<CellResults>& results, std::span<const StudyRow> rows);

}  // namespace fairway::cubes
