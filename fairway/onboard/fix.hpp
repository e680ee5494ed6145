// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/core/params.hpp"
#include "fairway/core/state.hpp"

namespace fairway {

/// Where a vehicle says that it is and how it moves, at one instant.
struct Fix {
  double time{};  ///< [s, of the clock that the helm is updated with]
  VehicleState state;
  std::optional<Vec3> through_water_b;  ///< velocity through the water, where it is measured [m/s, body]
  double position_sigma{};  ///< deviation of the error of position, to the worst side; 0: not stated [m]
};

/// What became of a fix that was handed in. Whatever is not `accepted` changes nothing but a count.
enum class FixVerdict {
  accepted,
  invalid,    ///< not a number, or an attitude that is none
  backwards,  ///< not later than the last one
  ahead,      ///< too far ahead of the clock
  jumped,     ///< not where it could have come to; believed once enough agree
  frozen,     ///< the same position to the bit for too long, though it moves
};

template <>
struct EnumNames<FixVerdict> {
  static constexpr std::array names{"accepted", "invalid", "backwards", "ahead", "jumped", "frozen"};
};

}  // namespace fairway
