// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "fairway/record/frame.hpp"
#include "fairway/record/quantities.hpp"

namespace fairway {

/// The first in which what two vehicles perceived differs, "tracks[2].x_m" or "echoes[0].range_m"; none if it
/// is the same to the bit, but for the payloads of NaN.
std::optional<QuantityDifference> first_perception_difference(const VehicleFrame& a, const VehicleFrame& b);

}  // namespace fairway
