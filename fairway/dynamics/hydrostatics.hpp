// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/dynamics/fossen.hpp"

namespace fairway {

/// What holds a floating hull up and level: linear hydrostatics about the body origin, which floats in the
/// waterline (Fossen 2021, section 4.2). Roll and pitch are held to the surface, not to gravity: a hull that
/// is short against the waves lies on their slope.
struct Hydrostatics {
  double heave{};  ///< rho g A_wp [N/m]
  double roll{};   ///< W GM_T [N m/rad]
  double pitch{};  ///< W GM_L [N m/rad]

  /// The wrench of the water on the hull. It derives from the potential
  /// heave/2 (z + elevation)^2 + roll/2 d_y^2 + pitch/2 d_x^2, d the downward normal of the surface in body
  /// axes, so that in still water no energy is made or lost at any angle.
  Wrench wrench(const VehicleState& x, const Water& water) const noexcept {
    const fossen::Matrix3 R = fossen::rotation(x.q_nb);
    const Vec3 d = R.transpose() * water.surface_normal();
    Wrench tau;
    tau.head<3>() = -heave * (x.p_n.z() + water.elevation) * R.row(2).transpose();
    tau.tail<3>() = d.cross(Vec3{pitch * d.x(), roll * d.y(), 0.0});
    return tau;
  }
};

}  // namespace fairway
