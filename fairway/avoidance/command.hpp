// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>

#include "fairway/core/params.hpp"
#include "fairway/core/record.hpp"
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
  Vec3 velocity = Vec3::Zero();
  Mode mode{Mode::cruise};
  bool astern{false};
  std::optional<double> heading;

  /// With a turn rate the part of `velocity` along the present heading is the surge that is wanted, astern if
  /// negative.
  std::optional<double> turn_rate;

  /// A vehicle that knows how its actuators push carries out the wrench; any other follows `velocity`, which
  /// is where the forces are meant to lead.
  std::optional<Wrench> wrench;

  std::string_view note;  ///< text that outlives the program's run

  static consteval auto members() {
    using R = Command;
    return std::tuple{
        member<&R::velocity>("mps", "desired, over ground [m/s, NED]"),
        member<&R::mode>("", "why it is what it is"),
        member<&R::astern>("", "the vehicle may go stern first rather than turn round"),
        member<&R::heading>("rad", "desired yaw, where the method commands one [rad], or none"),
        member<&R::turn_rate>(
            "radps",
            "desired yaw rate, where the method commands one [rad/s, positive to starboard], or none"),
        member<&R::wrench>(
            "", "X, Y, Z [N], K, M, N [N m] in body axes, where the method commands forces, or none"),
        member<&R::note>("", "why, in a few words for people, where the mode does not say it"),
    };
  }

  friend bool operator==(const Command&, const Command&) = default;
};

inline bool is_finite(const Command& command) {
  return is_finite(command.velocity) && (!command.heading || std::isfinite(*command.heading)) &&
         (!command.turn_rate || std::isfinite(*command.turn_rate)) &&
         (!command.wrench || command.wrench->allFinite());
}

}  // namespace fairway
