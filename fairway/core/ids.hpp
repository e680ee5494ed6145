// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

namespace fairway {

/// Strong ids: a track is not a vehicle, and neither is an index.
enum class VehicleId : std::uint32_t {};
enum class TrackId : std::uint32_t {};

// Who a track is: what a vehicle told of itself has that vehicle's number, and so has what is known of it
// exactly; what a sensor found, and obstacles that drift, are counted from these.
inline constexpr std::uint32_t first_tracker_id = 0x4000'0000U;
inline constexpr std::uint32_t first_drifter_id = 0x8000'0000U;

// The smaller priority has the right of way.
inline constexpr std::int32_t first_priority =
    std::numeric_limits<std::int32_t>::min();  // gives way to nobody
inline constexpr std::int32_t last_priority = std::numeric_limits<std::int32_t>::max();  // to everyone

constexpr std::uint32_t number(VehicleId id) { return static_cast<std::uint32_t>(id); }
constexpr std::uint32_t number(TrackId id) { return static_cast<std::uint32_t>(id); }

}  // namespace fairway
