// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "fairway/comms/message.hpp"

namespace fairway {

/// A message in the 25 bytes that a modem's packet leaves free for it, most significant bit first:
///
///     field        bits        step      holds
///     from         10          1         the number modulo `record_ids`
///     sent         16          20 ms     modulo 1310.72 s
///     position     24, 24, 22  1 cm      +-83.9 km, depth +-21 km; beyond, the nearest that fits
///     velocity     3 x 12      1 cm/s    +-20.47 m/s; a faster one is shortened, its direction kept
///     yaw          8           1.41 deg  modulo a turn
///     radius       9           0.1 m     rounded up; at most 51.1 m
///     priority     10          1         -512 .. 510, beyond which it saturates; 511 is last of all
///     destination  14, 14, 12  25 cm     from the position as told, +-2047 m, depth +-511 m; if
///                                        farther, shortened along the line to it
///
/// and one bit that says whether there is a destination. What is not a number is told as the lowest value.
using TeamRecord = std::array<std::uint8_t, 25>;

/// Numbers of vehicles are told modulo this.
inline constexpr std::uint32_t record_ids = 1024;

/// Times are told modulo this [s].
inline constexpr double record_cycle_s = 1310.72;

/// Who is as large as this, by a record, or larger is told as this [m].
inline constexpr double most_told_radius_m = 51.1;

/// Whether a position [m, NED] is nearer to the origin, along each axis, than the farthest that fits: what is
/// farther is told as that, and so is somewhere else.
bool can_be_told(const Vec3& position) noexcept;

/// What can be told in a TeamRecord: up to half a step off, the radius up to a whole one above. `period` is
/// that of the ticks that the message is stamped with [s]. O(1).
TeamRecord encode(const Message& message, double period);

/// The message in a record that was sent up to 1310 s ago by the receiver's clock, `now`. The sender's clock
/// is taken to go alike. `sent` is the tick nearest to the time told, not after `now`. O(1).
Message decode(const TeamRecord& record, Tick now, double period);

}  // namespace fairway
