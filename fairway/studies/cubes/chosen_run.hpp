// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "fairway/scenario/load.hpp"
#include "fairway/studies/cubes/plan.hpp"
#include "fairway/studies/run_index.hpp"

namespace fairway::cubes {

/// The cell and the seed of the run that is made again to be looked at: eight vehicles in the small cube
/// under ORCA as printed.
Cell chosen_cell();
inline constexpr std::uint64_t chosen_seed = 1;

/// That run: trajectories, and the least separation of each vehicle over time, at one point a second.
std::vector<nlohmann::json> chosen_run_blocks(const Overrides& overrides, const RunIndex& runs);

}  // namespace fairway::cubes
