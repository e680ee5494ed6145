// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fairway/core/ids.hpp"

namespace fairway {

/// What a method says of its own accord in its vehicle's turn: as many bytes as the team record has. Without
/// any the vehicle says nothing of its own.
struct Speech {
  static constexpr std::size_t most_bytes = 25;

  std::array<std::uint8_t, most_bytes> bytes{};
  std::uint8_t size{0};

  bool empty() const { return size == 0; }
  std::span<const std::uint8_t> view() const { return {bytes.data(), size}; }

  friend bool operator==(const Speech&, const Speech&) = default;
};

/// A speech that has come in.
struct Heard {
  VehicleId from{};
  double sent{};  ///< when it was said [s], by the mission's time
  Speech speech{};
};

/// A distance that a modem has measured by the time that sound took. By one word it is that from where the
/// other was when it spoke to where this vehicle was at `back`, and has the clocks' difference in it, so that
/// it may be negative. By a word and its answer it is the mean of the two ways, and `out` is earlier.
struct AcousticRange {
  VehicleId to{};
  double distance{};   ///< [m]
  double deviation{};  ///< standard, of the measurement alone [m]
  double out{};        ///< when the own word went out, if there was one, else `back` [s], as `back`
  double back{};       ///< when the other's came in [s], by the clock on board and the mission's time
};

/// What a vehicle's modem offers a method that speaks.
struct Link {
  std::span<const Heard> heard;  ///< the last speech of each of the others that was heard, by vehicle
  double turn_period{};          ///< at most, from one own turn to the next [s]
  double next_turn{};            ///< when the next one begins [s], by the mission's time
  std::span<const AcousticRange>
      ranges{};  ///< the last of each of the others, by vehicle; none where none are measured
};

}  // namespace fairway
