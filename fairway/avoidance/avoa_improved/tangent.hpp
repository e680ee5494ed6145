// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/core/vec.hpp"

namespace fairway::avoa_improved {

/// Which way a circle is gone round.
enum class Side {
  to_port,       ///< turning to port: the circle lies to port
  to_starboard,  ///< turning to starboard: the circle lies to starboard
};

/// 1 to starboard, -1 to port.
constexpr double sign_of(Side side) { return side == Side::to_starboard ? 1.0 : -1.0; }

/// A circle that is gone round, or a point if it has no radius. [m, NED]
struct Turn {
  Vec2 centre = Vec2::Zero();
  double radius{};
  Side side{Side::to_port};

  Vec2 at(double angle) const;

  /// From `arrival` to `departure` in the way of the turn, in [0, 2 pi) [rad].
  double sweep(double arrival, double departure) const;
};

/// The straight line on which a turn is left for another.
struct Tangent {
  double heading{};    ///< [rad]
  double length{};     ///< [m]
  double departure{};  ///< where the one is left, as an angle at its centre [rad]
  double arrival{};    ///< where the other is met, as an angle at its centre [rad]
};

/// There is one at most; none where one circle lies within the other, or where they cross and are to be gone
/// round on different sides. O(1).
std::optional<Tangent> tangent(const Turn& from, const Turn& to);

}  // namespace fairway::avoa_improved
