// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "fairway/scenario/parts.hpp"

namespace fairway::yaml {

/// Writes the vehicles of `fleet:` out at the end of `vehicles:`: where each starts, its heading and a
/// mission of one transit, unless `defaults` say. All else of them is for the defaults. Throws InputError for
/// what the key does not accept and for places that cannot be. O(count log count).
void write_out_fleet(Tree& document, std::optional<std::uint64_t> seed);

/// The key itself: read once the vehicles are, it throws where spheres of the fleet overlap.
Key<Scenario> fleet();

}  // namespace fairway::yaml
