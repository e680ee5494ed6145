// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/composite/composite_vehicle.hpp"

namespace fairway {

CompositeVehicle::CompositeVehicle(std::span<const Part> parts, const CompositeBody::Options& options)
    : body_{parts, options}, density_{parts.front().numbers.density} {
  propulsion_.effectiveness.resize(6, 0);
  for (const Part& part : parts) {
    for (const Thruster& thruster : part.thrusters) equip(part, thruster);
  }
  propulsion_.mass = body_.mass();
  propulsion_.linear_damping = body_.linear_damping().diagonal();
  propulsion_.quadratic_damping = body_.quadratic_damping();
  propulsion_.restoring = body_.level_restoring();
}

void CompositeVehicle::equip(const Part& part, const Thruster& thruster) {
  fossen::Vector6 column = velocity_transform(part).transpose() * thruster.column;
  column = (column.array().abs() > 1e-12).select(column, 0.0);  // what rotations leave of a zero
  if (body_.degrees_of_freedom() == DegreesOfFreedom::planar) {
    column.segment<3>(2).setZero();
    if (column.isZero(1e-9)) return;
  }
  if (actuators_.size() == max_actuators) {
    throw InputError("a vehicle has more than " + std::to_string(max_actuators) + " thrusters");
  }
  actuators_.push_back({thruster.name, thruster.meaning, thruster.range, thruster.time_constant_s});
  const double diameter = thruster.propeller_diameter_m;
  disk_areas_.push_back(pi / 4 * diameter * diameter);

  const bool dead = thruster.range.lo == 0.0 && thruster.range.hi == 0.0;
  auto& B = propulsion_.effectiveness;
  B.conservativeResize(Eigen::NoChange, B.cols() + 1);
  B.rightCols<1>() = dead ? fossen::Vector6::Zero().eval() : column;
}

double CompositeVehicle::power(const ActuatorValues& u) const noexcept {
  double watts = 0.0;
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    watts += fossen::ideal_disk_power(u[i], disk_areas_[static_cast<std::size_t>(i)], density_);
  }
  return watts;
}

}  // namespace fairway
