// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "fairway/core/params.hpp"
#include "fairway/core/vec.hpp"
#include "fairway/core/wrench.hpp"

namespace fairway {

/// Why the command is what it is. Metrics such as "time spent holding" count these.
enum class Mode : std::uint8_t {
  cruise,      ///< nothing in the way
  avoid,       ///< deviating from the preferred velocity, or someone close enough that it might
  hold,        ///< waiting on purpose: keep the present position
  infeasible,  ///< no safe choice that the vehicle can carry out, or no sense in the input; the least bad one
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

  /// Desired yaw rate, where the method commands one; then the part of `velocity` along the present heading
  /// is the surge it wants, astern if negative. [rad/s, positive to starboard]
  std::optional<double> turn_rate;

  /// Where the method commands forces: a vehicle that knows how its actuators push carries these out, any
  /// other follows `velocity`, which is where the forces are meant to lead. [N, N m, body]
  std::optional<Wrench> wrench;

  /// Why, in a few words for people, where `mode` does not say it. Text that outlives the program's run.
  std::string_view note;

  friend bool operator==(const Command&, const Command&) = default;
};

inline bool is_finite(const Command& command) {
  return is_finite(command.velocity) && (!command.heading || std::isfinite(*command.heading)) &&
         (!command.turn_rate || std::isfinite(*command.turn_rate)) &&
         (!command.wrench || command.wrench->allFinite());
}

}  // namespace fairway
