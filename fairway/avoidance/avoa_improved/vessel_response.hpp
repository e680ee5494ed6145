// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/core/vec.hpp"

namespace fairway::avoa_improved {

/// How the vessel answers its helm: first-order responses within limits,
///
///     r' = (clamp(k theta, +-w_max) - r) / T,  |r'| <= alpha_max,        u' = (u_c - u) / T,  |u'| <= a_max
///
/// with theta the heading error, u along the heading.
struct VesselResponse {
  double turn_gain{};              ///< k [1/s]
  double max_turn_rate{};          ///< w_max [rad/s]
  double max_turn_acceleration{};  ///< alpha_max [rad/s2]
  double max_acceleration{};       ///< a_max [m/s2]
  double response{};               ///< T [s]

  /// Commanded turn rate for a heading error [rad] -> [rad/s].
  double turn_rate(double error) const noexcept { return limited(turn_gain * error, max_turn_rate); }

  /// Share of the way to a set point that is gone in `h` seconds.
  double share(double h) const noexcept { return 1.0 - math::exp(-h / response); }

  /// The speed `h` seconds later, `share(h)` given.
  double speed_after(double speed, double commanded, double h, double gone) const noexcept {
    return speed + limited(gone * (commanded - speed), max_acceleration * h);
  }

  /// The turn rate `h` seconds later, likewise.
  double turn_rate_after(double rate, double commanded, double h, double gone) const noexcept {
    return rate + limited(gone * (commanded - rate), max_turn_acceleration * h);
  }

  static double limited(double change, double most) noexcept {
    return math::fmin(math::fmax(change, -most), most);
  }
};

}  // namespace fairway::avoa_improved
