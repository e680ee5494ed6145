// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "fairway/avoidance/command.hpp"
#include "fairway/core/limits.hpp"

namespace fairway {

/// What of a command is beyond the vehicle.
enum class Shortfall : std::uint8_t {
  none,
  too_slow,  ///< it cannot stop, and is to stop or to go slower than it steers
  astern,    ///< it cannot go astern, and is to go against its heading
  sideways,  ///< it cannot go sideways, and is to go across its heading
};

template <>
struct EnumNames<Shortfall> {
  static constexpr std::array names{"none", "too_slow", "astern", "sideways"};
};

/// Whether it always makes way ahead: it can neither stop, so as to turn on the spot, nor go astern.
constexpr bool only_goes_ahead(const Limits& limits) { return limits.min_speed > 0.0 && !limits.sternway; }

/// What of `command` a vehicle with these limits cannot carry out from heading `yaw` [rad], taken in still
/// water, since a command does not know what runs.
///
/// A turn that is still to be made is no shortfall for who can stop: it turns, and then it goes. Who cannot
/// goes on ahead meanwhile, away from what is abaft its beam. Nor is there a turn left to make where the
/// command says a heading or a turn rate as well, or that the vehicle may go stern first: then a velocity
/// against that heading (with a turn rate, the present one) takes sternway, and one that is more across it
/// than along it takes sway. Velocities are horizontal: nobody dives on the spot who cannot stop. O(1).
Shortfall shortfall(const Limits& limits, const Command& command, double yaw) noexcept;

/// The same where it does not depend on the heading; else nothing.
std::optional<Shortfall> shortfall_on_any_heading(const Limits& limits, const Command& command) noexcept;

/// In a few words for people; empty for none. Text that outlives the program's run.
std::string_view words_of(Shortfall shortfall) noexcept;

}  // namespace fairway
