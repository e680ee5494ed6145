// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fairway/core/params.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// Why the command is what it is. Metrics such as "time spent holding" count these.
enum class Mode : std::uint8_t {
  cruise,      ///< nothing in the way
  avoid,       ///< deviating from the preferred velocity, or someone close enough that it might
  hold,        ///< waiting on purpose: keep the present position
  infeasible,  ///< no safe choice was found, or the input made no sense; the velocity is the least bad one
};

template <>
struct EnumNames<Mode> {
  static constexpr std::array names{"cruise", "avoid", "hold", "infeasible"};
};

/// What the vehicle should do until the next decision.
struct Command {
  Vec3 velocity = Vec3::Zero();  ///< desired, over ground [m/s, NED]
  Mode mode{Mode::cruise};
  bool astern{false};             ///< the vehicle may go stern first rather than turn round
  std::optional<double> heading;  ///< desired yaw, where the method commands one [rad]

  friend bool operator==(const Command&, const Command&) = default;
};

}  // namespace fairway
