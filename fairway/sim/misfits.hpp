// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/catalogs.hpp"

namespace fairway {

/// Where a method is not meant for its vehicle, or for what it meets there: a line for each kind of trouble,
/// "robot0 and 7 others: orca3d moves a point that goes any way at once, and sparus2 has to turn first".
/// Nothing is refused for it. What the catalogs do not know is passed over: whoever simulates it refuses it.
/// O(vehicles x layers + obstacles + legs).
std::vector<std::string> misfits(const Scenario& scenario, const Catalogs& catalogs);

}  // namespace fairway
