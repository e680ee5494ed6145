// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// How many may be in the team in which a method agrees: the range of its parameter `team_count`; nothing for
/// a method that agrees with nobody. Throws InputError for an unknown name.
std::optional<Range> team_sizes(const Catalog& avoiders, std::string_view name);

/// The parameters of a vehicle's avoider: those of its spec, and where its method agrees in a team and the
/// spec does not say how many that are, as many as the scenario has vehicles whose methods do, by their ids.
/// Throws InputError for an unknown name. O(vehicles) for a method that agrees.
ParamValues avoider_params(const VehicleSpec& spec, const Scenario& scenario, const Catalog& avoiders);

/// How many agree with a vehicle by that; nothing for a method that agrees with nobody. Likewise.
std::optional<double> team_size(const VehicleSpec& spec, const Scenario& scenario, const Catalog& avoiders);

}  // namespace fairway
