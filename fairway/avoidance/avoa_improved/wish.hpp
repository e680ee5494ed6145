// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "fairway/avoidance/avoa_improved/avoa_improved.hpp"
#include "fairway/avoidance/avoa_improved/way_round.hpp"

namespace fairway::avoa_improved {

/// What the vessel is to do if nothing near hinders it.
struct Wish {
  double speed{};            ///< [m/s]
  double speed_after{};      ///< once on the heading [m/s]
  double heading{};          ///< [rad]
  double margin{};           ///< that is to be kept on the way [m]
  bool is_preferred = true;  ///< as the mission wants it
};

/// Where a mover can be met first by who makes `speed`, and on from there for `bow` seconds of its course, as
/// a solid that stays there; nothing if it cannot be met within `soon` seconds.
std::optional<Capsule> meeting(const Capsule& mover, const Vec2& own, double speed, double soon,
                               double bow) noexcept;

/// Along the shortest way round everything known, if `params.memory`, else as the mission wants it. Keeps to
/// the way of the last time, which `memory.committed` says, until the goal is in sight. If there is no way,
/// that regardless of who is met, then with half of the margin; if there is none either, straight. If
/// `params.turn_aware`, slower the farther the vessel has to turn.
Wish wish_of(const AvoaImproved::Params& params, const Situation& s, std::span<const Capsule> moving,
             AvoaImproved::Memory& memory, Sketch* sketch) noexcept;

}  // namespace fairway::avoa_improved
