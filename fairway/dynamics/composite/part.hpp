// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "fairway/dynamics/submerged_body.hpp"

namespace fairway {

/// A thruster of a part.
struct Thruster {
  std::string name;                                  ///< of the actuator, ends in its unit
  std::string meaning;                               ///< what a positive thrust does
  fossen::Vector6 column = fossen::Vector6::Zero();  ///< wrench per newton about the part's origin, part axes
  Range range{};                                     ///< [N]
  double time_constant_s{};                          ///< of its first-order lag; 0 = none
  double propeller_diameter_m{0.1};                  ///< for power only
};

/// A rigid body that is fixed to others: where it sits on the whole, and its own numbers in its own axes.
struct Part {
  Vec3 position = Vec3::Zero();                                     ///< of its origin [m, body of the whole]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< part axes to body of the whole, unit
  SubmergedBodyNumbers numbers{};                                   ///< about its origin, in its axes
  std::vector<Thruster> thrusters{};
};

/// H of nu_part = H nu: the velocities of the part's origin in part axes from those of the whole,
/// [R^T, -R^T S(r); 0, R^T]. Its transpose brings wrenches from the part to the whole.
inline fossen::Matrix6 velocity_transform(const Part& part) {
  const fossen::Matrix3 R_t = part.orientation.toRotationMatrix().transpose();
  fossen::Matrix6 H;
  H << R_t, -R_t * fossen::skew(part.position), fossen::Matrix3::Zero(), R_t;
  return H;
}

}  // namespace fairway
