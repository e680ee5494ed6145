// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fairway/scenario/load.hpp"
#include "fairway/studies/run_index.hpp"
#include "fairway/studies/transport/transport_case.hpp"

namespace fairway::transport {

/// A published run made again to be looked at, on both plants: where it goes, and the forces commanded (of
/// the compatible plant), at one point a second; as the published Figures 5, 6, 7 and 9.
std::vector<nlohmann::json> redrawn(const PublishedRun& run, const std::string& title,
                                    const Overrides& overrides, const RunIndex& runs);

/// The way of each method through a case, seen from above.
nlohmann::json ways(Case which, std::span<const Method> methods, const Overrides& overrides,
                    const RunIndex& runs);

/// The waypoints of Table 7 and a path planned here among the same obstacles, as Figure 8.
nlohmann::json planned_paths();

}  // namespace fairway::transport
