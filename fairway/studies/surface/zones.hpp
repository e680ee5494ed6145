// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

namespace fairway::surface {

/// Figures 3 to 6 of campos2019, drawn by AVOA itself: protective zones and cost of danger of one static
/// obstacle, and of a static and a moving one, without and with the thrusters' limits; then two moving
/// obstacles, whose zones hold the desired velocity, and the metric over all velocities. The paper's
/// positions are not published.
std::vector<nlohmann::json> zone_figures();

}  // namespace fairway::surface
