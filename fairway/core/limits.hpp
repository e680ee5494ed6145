// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace fairway {

/// What a vehicle can or may do. A limit that is not set does not bind.
struct Limits {
  static constexpr double none = std::numeric_limits<double>::infinity();

  double max_speed{none};         ///< over ground [m/s]
  double max_climb_rate{none};    ///< vertical, either way [m/s]; zero for a surface vehicle
  double max_acceleration{none};  ///< [m/s2]; for the methods that reason about reachable velocities
  double max_turn_rate{none};     ///< [rad/s]; likewise
  double min_depth{-none};        ///< ceiling: no command leads above it [m]
  double max_depth{none};         ///< floor: no command leads below it [m]

  // what the vehicle cannot do, whatever it is told; by default it can do all of it
  double min_speed{0.0};  ///< through the water; slower than this it does not steer [m/s]
  bool sternway{true};    ///< it can go astern
  bool sway{true};        ///< it can go sideways

  friend bool operator==(const Limits&, const Limits&) = default;
};

/// `limit`, or `otherwise` where it does not bind.
constexpr double limit_or(double limit, double otherwise) { return limit < Limits::none ? limit : otherwise; }

}  // namespace fairway
