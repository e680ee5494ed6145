// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fairway/studies/run_index.hpp"
#include "fairway/studies/uuv/encounter.hpp"

namespace fairway::uuv {

/// An encounter under RVO made again to be looked at: everyone's way with the spheres at the times that the
/// paper's Figures 4 and 5 show, and the UUVs' speeds over time.
std::vector<nlohmann::json> redrawn(Encounter encounter, const Setting& setting, const std::string& title,
                                    const Overrides& overrides, const RunIndex& runs);

/// The ways of other methods through the same encounter in the common setting.
nlohmann::json ways_of(Encounter encounter, std::span<const std::string_view> methods,
                       const std::string& title, const Overrides& overrides, const RunIndex& runs);

}  // namespace fairway::uuv
