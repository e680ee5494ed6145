// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "fairway/record/frame.hpp"
#include "fairway/record/quantities.hpp"

namespace fairway {

/// The first in which what two vehicles drew differs, "sketch[3].points[0]" or "stroke_count"; none if it
/// is the same to the bit. O(size).
std::optional<QuantityDifference> first_sketch_difference(std::span<const Stroke> a,
                                                          std::span<const Stroke> b);

/// Likewise of messages under way: "flights[2].arrives_s".
std::optional<QuantityDifference> first_flight_difference(std::span<const MessageFlight> a,
                                                          std::span<const MessageFlight> b);

/// Whether neither of these finds anything in two frames.
bool same_sketches(const Frame& a, const Frame& b);

}  // namespace fairway
