// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "fairway/record/frame.hpp"

namespace fairway {

/// A named number or word of a vehicle in a frame: a column of the CSV export, a line of a difference.
struct Quantity {
  std::string_view name;  ///< with its unit: "x_m", "mode"
  std::string (*text)(const VehicleFrame&, int);
  int index;  ///< along the vector that it is of

  /// To full precision; empty if there is none.
  std::string of(const VehicleFrame& vehicle) const { return text(vehicle, index); }
};

/// Everything in a VehicleFrame but its actuators, whose number differs between vehicles.
std::span<const Quantity> quantities();

/// A quantity that is not the same to the bit, and its two values.
struct QuantityDifference {
  std::string quantity;
  std::string a;
  std::string b;
};

/// Whether two numbers are the same to the bit. number_text() tells every two apart, but not the payloads of
/// NaN.
inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// "tick 4 (0.4 s)", the time without the last digits of its rounding.
std::string instant_text(Tick tick, double time);

/// The first in which two vehicle frames differ, actuators last; none if they are the same to the bit.
std::optional<QuantityDifference> first_difference(const VehicleFrame& a, const VehicleFrame& b);

/// The first in which what two vehicles perceived differs, "tracks[2].x_m" or "echoes[0].range_m"; none if it
/// is the same to the bit, but for the payloads of NaN.
std::optional<QuantityDifference> first_perception_difference(const VehicleFrame& a, const VehicleFrame& b);

/// The first in which what two vehicles drew differs, "sketch[3].points[0]" or "stroke_count"; none if it
/// is the same to the bit. O(size).
std::optional<QuantityDifference> first_sketch_difference(std::span<const Stroke> a,
                                                          std::span<const Stroke> b);

/// Likewise of messages under way: "flights[2].arrives_s".
std::optional<QuantityDifference> first_flight_difference(std::span<const MessageFlight> a,
                                                          std::span<const MessageFlight> b);

/// Likewise of two words: "from_index", "sent_s" or "bytes".
std::optional<QuantityDifference> first_word_difference(const SpokenWord& a, const SpokenWord& b);

/// Whether neither of these finds anything in two frames.
bool same_sketches(const Frame& a, const Frame& b);

}  // namespace fairway
