// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "fairway/dynamics/vehicle_model.hpp"

namespace fairway {

/// What a controller may know of a thruster-driven vehicle.
struct Propulsion {
  /// Body wrench per unit of each actuator (Fossen's B, 6 x actuators).
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, max_actuators> effectiveness;
  Eigen::Matrix<double, 6, 6> mass;               ///< rigid body and added mass M
  Eigen::Matrix<double, 6, 1> linear_damping;     ///< diagonal of D_l, >= 0
  Eigen::Matrix<double, 6, 1> quadratic_damping;  ///< diagonal of D_q, >= 0: D(nu) = D_l + D_q |nu|
  Wrench restoring;                               ///< g(eta) when level: what the thrusters must hold
};

}  // namespace fairway
