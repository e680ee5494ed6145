// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "fairway/scenario/load.hpp"
#include "fairway/studies/cubes/plan.hpp"
#include "fairway/studies/run_index.hpp"

namespace fairway::cubes {

/// The cell whose first run is made again to be looked at, among those of the corrected comparison: eight
/// vehicles in the small cube under ORCA as printed.
const Cell& chosen_cell(const std::vector<Cell>& cells);

/// That run: trajectories, and the least separation of each vehicle over time, at one point a second.
std::vector<nlohmann::json> chosen_run_blocks(const Overrides& overrides, const RunIndex& runs);

}  // namespace fairway::cubes
