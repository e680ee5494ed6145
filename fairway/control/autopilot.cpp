// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/autopilot.hpp"

namespace fairway {
namespace {

/// The part of a request that a setpoint actuator takes, or null.
double BodyRequest::*setpoint_of(std::string_view actuator) {
  if (actuator == "surge_mps") return &BodyRequest::surge_mps;
  if (actuator == "sway_mps") return &BodyRequest::sway_mps;
  if (actuator == "heave_mps") return &BodyRequest::heave_mps;
  if (actuator == "yaw_rate_radps") return &BodyRequest::yaw_rate_radps;
  return nullptr;
}

}  // namespace

Autopilot::Autopilot(const Vehicle& vehicle, const VelocityController::Params& params,
                     AllocationMethod allocation) {
  if (const Propulsion* propulsion = vehicle.propulsion()) {
    controller_.emplace(*propulsion, vehicle.actuators(), params);
    allocator_.emplace(*propulsion, vehicle.actuators(), allocation);
    return;
  }
  if (const FinDrive* drive = vehicle.fin_drive()) {
    fins_.emplace(*drive, vehicle.actuators());
    return;
  }
  std::vector<double BodyRequest::*> setpoints;
  for (const ActuatorInfo& actuator : vehicle.actuators()) {
    double BodyRequest::*const setpoint = setpoint_of(actuator.name);
    if (setpoint == nullptr) {
      throw InputError("no autopilot drives actuator " + actuator.name + " of " +
                       std::string(vehicle.info().name) +
                       ": it is not a velocity setpoint and the vehicle does not tell how it pushes");
    }
    setpoints.push_back(setpoint);
  }
  setpoints_ = std::move(setpoints);
}

ActuatorValues Autopilot::control(const BodyRequest& request, const Vec3& v_b, const Vec3& omega_b, double h,
                                  const Eigen::Quaterniond& q_nb) noexcept {
  if (controller_) return controller_->control(request, v_b, omega_b, h);
  if (fins_) return fins_->control(request, euler_of(q_nb).pitch, v_b, omega_b, h);

  const std::vector<double BodyRequest::*>& setpoints = *setpoints_;
  ActuatorValues command(static_cast<Eigen::Index>(setpoints.size()));
  for (std::size_t i = 0; i < setpoints.size(); ++i)
    command[static_cast<Eigen::Index>(i)] = request.*setpoints[i];
  return command;
}

std::optional<ActuatorValues> Autopilot::push(const Wrench& tau) const noexcept {
  if (!allocator_) return {};
  return allocator_->allocate(tau);
}

void Autopilot::reset() noexcept {
  if (controller_) controller_->reset();
  if (fins_) fins_->reset();
}

}  // namespace fairway
