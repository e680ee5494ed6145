// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "fairway/record/frame.hpp"
#include "fairway/record/quantities.hpp"

namespace fairway {

/// A named number or word of a track: a column of its CSV export, a line of a difference.
struct TrackQuantity {
  std::string_view name;              ///< with its unit: "x_m", "reacts"
  std::string (*text)(const Track&);  ///< to full precision; empty if there is none
};

/// Everything in a Track; covariances row by row.
std::span<const TrackQuantity> track_quantities();

/// The first in which what two vehicles perceived differs, "tracks[2].x_m" or "echoes[0].range_m"; none if it
/// is the same to the bit, but for the payloads of NaN.
std::optional<QuantityDifference> first_perception_difference(const VehicleFrame& a, const VehicleFrame& b);

}  // namespace fairway
