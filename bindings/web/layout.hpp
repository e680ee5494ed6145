// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "fairway/scenario/load.hpp"

namespace fairway::web {

/// What of a scenario may be moved, and how: {"handles": [{"path", "what", "name", "vehicle", "position_m"}],
/// "fleet_count"}. A `path` is one of `--set`, `position_m` what it is set to now, with two coordinates where
/// a third means nothing; `what` is start, goal or obstacle; `vehicle` an index or null. Of more than 64
/// vehicles there are no handles, nor are there of legs that a named mission brings. `fleet_count` is null
/// where there is no fleet. `scenario` is what the other arguments were read as.
nlohmann::json layout(const std::string& yaml, const std::string& file, const Overrides& set,
                      std::optional<std::uint64_t> seed, const Scenario& scenario);

}  // namespace fairway::web
