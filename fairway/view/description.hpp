// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/sim/catalogs.hpp"

namespace fairway {

/// What `fairway describe --json` says of an algorithm, vehicle, metric or kind of exchange, perception or
/// navigation: title, source, and parameters with units, ranges, defaults and meanings. Nothing if none of
/// these is called so; the names that there are have been added to `known` then. Of a vehicle it measures the
/// envelope, which takes seconds of simulated time.
std::optional<nlohmann::json> description(const std::string& name, const Catalogs& catalogs,
                                          std::vector<std::string_view>& known);

}  // namespace fairway
