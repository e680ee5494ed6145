// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "fairway/avoidance/avoa/velocity_grid.hpp"

namespace fairway::avoa {

/// The velocities that two thrusters side by side cannot make, PZ^K (campos2019, eqs. 3-5): the turn rate
/// omega that leads to a heading is k |theta|, at most `max_turn_rate`. And, of a vehicle that cannot stop,
/// those that are too slow for it or, without sternway, abaft its beam. Who foresees what the vehicle makes
/// of a velocity slows it for the turn to the desired heading by itself: theta is then from the nearer of
/// that and the bow.
struct KinematicZone {
  double alpha{};           ///< thruster speed per speed [-]
  double beta{};            ///< thruster speed per turn rate [m]
  double turn_gain{};       ///< k [1/s]
  double max_turn_rate{};   ///< [rad/s]
  double thruster_speed{};  ///< v_max^t [m/s]
  double max_speed{};       ///< v_max [m/s]
  double min_speed{};       ///< [m/s]
  bool only_ahead{};
  std::optional<double> foreseen_heading;  ///< the desired one, off the bow, where somebody foresees [rad]

  bool contains(const PolarVelocity& v) const {
    double turn = std::abs(v.heading);
    if (foreseen_heading) turn = std::min(turn, std::abs(wrapped(v.heading - *foreseen_heading)));
    const double omega = std::min(turn_gain * turn, max_turn_rate);
    // the outer thruster, v_1 to starboard and v_2 to port, is the faster one
    if (v.speed < min_speed || (only_ahead && std::abs(v.heading) > 0.5 * pi)) return true;
    return v.speed > max_speed || alpha * v.speed + beta * omega > thruster_speed;
  }

  friend bool operator==(const KinematicZone&, const KinematicZone&) = default;
};

}  // namespace fairway::avoa
