// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// What keeps a vehicle whose method agrees with others by words (`needs_link`) from doing so, each thing as
/// a clause about its method: that a parameter which all have to have in common is another than the first
/// one's, and that a place of its mission is too far from its datum to be told. Throws InputError for an
/// unknown name. O(vehicles + legs).
std::vector<std::string> amiss_in_words(const VehicleSpec& spec, const Scenario& scenario,
                                        const Catalog& avoiders);

/// The first vehicle with another method, whom one that knows others by their words alone does not know; null
/// if there is none. Likewise.
const VehicleSpec* first_stranger(const VehicleSpec& spec, const Scenario& scenario, const Catalog& avoiders);

}  // namespace fairway
