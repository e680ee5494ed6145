// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <optional>
#include <type_traits>

#include "fairway/core/ids.hpp"
#include "fairway/core/record.hpp"
#include "fairway/core/vec.hpp"
#include "fairway/core/wrench.hpp"

// What kinds of members a record may have.

namespace fairway::detail {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <class T>
concept Id = std::same_as<T, VehicleId> || std::same_as<T, TrackId>;

template <class T>
concept Discrete = std::integral<T> || std::is_enum_v<T>;

template <class T>
concept Real =
    std::same_as<T, double> || std::same_as<T, Vec3> || std::same_as<T, Wrench> || std::same_as<T, Mat3>;

}  // namespace fairway::detail
