// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/wrench.hpp"

namespace fairway {

/// How a vehicle answers to forces, as far as that is known on board: one axis at a time, in the order
/// surge, sway, heave, roll, pitch, yaw, about the body origin and through the water,
///
///     m nu' = tau - (d_l + d_q |nu|) nu - g,    least <= tau <= greatest.
///
/// For methods that command forces, and for those that foresee what a force comes to.
struct OnboardModel {
  Wrench mass = Wrench::Zero();               ///< rigid body and added mass m [kg, kg m2]
  Wrench linear_damping = Wrench::Zero();     ///< d_l >= 0 [kg/s, kg m2/s]
  Wrench quadratic_damping = Wrench::Zero();  ///< d_q >= 0 [kg/m, kg m2]
  Wrench restoring = Wrench::Zero();          ///< g when level [N, N m]
  Wrench least = Wrench::Zero();     ///< what the actuators give on an axis, the others at zero [N, N m]
  Wrench greatest = Wrench::Zero();  ///< likewise

  /// d(nu) of one axis [N, N m].
  double drag(int axis, double nu) const noexcept {
    return (linear_damping[axis] + quadratic_damping[axis] * (nu < 0.0 ? -nu : nu)) * nu;
  }
};

}  // namespace fairway
