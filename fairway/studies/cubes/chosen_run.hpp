// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "fairway/scenario/load.hpp"
#include "fairway/studies/cubes/cube_case.hpp"

namespace fairway::cubes {

/// One run made again to be looked at: trajectories, and the least separation of each vehicle over time,
/// at one point a second.
std::vector<nlohmann::json> chosen_run_blocks(const CubeCase& cube, const Method& method, Code code,
                                              std::uint64_t seed, const Overrides& overrides);

}  // namespace fairway::cubes
