// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/dynamics/composite/composite_body.hpp"
#include "fairway/dynamics/propulsion.hpp"

namespace fairway {

/// A composite body and the thrusters of its parts: what a vehicle model of such a body forwards to. The
/// numbers of the parts, and so the vehicle, belong to the density of the first part whatever the water's: it
/// is ballasted for where it works. derivative() and power() neither allocate nor throw.
class CompositeVehicle {
 public:
  /// Actuators are the thrusters in the order of the parts. With `planar`, those that push on none of surge,
  /// sway and yaw are left out. A thruster whose range is [0, 0] stays in the list and pushes nothing.
  /// Throws InputError for more than max_actuators thrusters, and as CompositeBody does.
  CompositeVehicle(std::span<const Part> parts, const CompositeBody::Options& options);

  std::span<const ActuatorInfo> actuators() const { return actuators_; }

  /// `u`: one thrust per actuator [N]. Of `water` only how it moves is read.
  StateRate derivative(const VehicleState& x, const ActuatorValues& u, const Water& water) const noexcept {
    fossen::Vector6 tau = fossen::Vector6::Zero();
    for (Eigen::Index i = 0; i < u.size(); ++i) tau += u[i] * propulsion_.effectiveness.col(i);
    return body_.derivative(
        x, tau, {.current_n = water.current_n, .density = density_, .current_rate_n = water.current_rate_n});
  }

  /// The power of ideal actuator disks of the propellers' diameters [W], a lower bound of the electrical
  /// power.
  double power(const ActuatorValues& u) const noexcept;

  const Propulsion& propulsion() const { return propulsion_; }
  const CompositeBody& body() const { return body_; }

 private:
  void equip(const Part& part, const Thruster& thruster);

  CompositeBody body_;
  double density_;  // [kg/m3]
  std::vector<ActuatorInfo> actuators_;
  std::vector<double> disk_areas_;  // [m2]
  Propulsion propulsion_;
};

}  // namespace fairway
