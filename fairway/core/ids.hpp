// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace fairway {

/// Strong ids: a track is not a vehicle, and neither is an index.
enum class VehicleId : std::uint32_t {};
enum class TrackId : std::uint32_t {};

constexpr std::uint32_t number(VehicleId id) { return static_cast<std::uint32_t>(id); }
constexpr std::uint32_t number(TrackId id) { return static_cast<std::uint32_t>(id); }

}  // namespace fairway
