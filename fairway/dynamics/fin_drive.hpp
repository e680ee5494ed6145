// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace fairway {

/// What a controller may know of a body that is driven by one propeller and steered by a rudder and stern
/// planes, all at its stern. A fin's moment is in proportion to its angle and to the square of the speed u
/// through the water (Fossen 2021, chapter 9, small angles), so that without way there is no steering:
///
///     I_z r' = rudder_moment u^2 rudder - yaw_damping r + ...
///     I_y q' = stern_moment u^2 stern - pitch_damping q - pitch_restoring sin(pitch) + ...
///     u'     = (speed_per_turn n - u) u / surge_distance + ...
struct FinDrive {
  // among actuators()
  std::size_t propeller{};
  std::size_t rudder{};
  std::size_t stern{};

  double speed_per_turn{};  ///< steady speed ahead by the unit of the propeller's actuator
  double surge_distance{};  ///< sailed while the speed comes to 1 - 1/e of a change [m]

  double yaw_inertia{};      ///< I_z with added inertia [kg m2]
  double yaw_damping{};      ///< linear, >= 0 [N m s]
  double rudder_moment{};    ///< N by angle and u^2 [kg], positive: positive angles turn to starboard
  double pitch_inertia{};    ///< I_y with added inertia [kg m2]
  double pitch_damping{};    ///< linear, >= 0 [N m s]
  double pitch_restoring{};  ///< W (z_g - z_b) [N m]
  double stern_moment{};     ///< M by angle and u^2 [kg], negative: positive angles dive
};

}  // namespace fairway
