// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "fairway/control/body_request.hpp"
#include "fairway/control/fin_autopilot.hpp"
#include "fairway/control/thrust_allocator.hpp"
#include "fairway/control/velocity_controller.hpp"
#include "fairway/core/boxed.hpp"
#include "fairway/core/shared.hpp"
#include "fairway/dynamics/vehicle.hpp"

namespace fairway {

/// Turns body-velocity requests into actuator commands for one vehicle: a VelocityController where the
/// vehicle has thrusters, a FinAutopilot where it has fins, the request itself where its actuators are
/// velocity setpoints (surge_mps, sway_mps, heave_mps, yaw_rate_radps, in any order and number). A value.
class Autopilot {
 public:
  /// Throws InputError for a vehicle that can do none of these.
  explicit Autopilot(const Vehicle& vehicle, const VelocityController::Params& params = {},
                     AllocationMethod allocation = AllocationMethod::bounded);

  /// The actuator command for the next `h` [s], from velocities through the water [body axes] and the
  /// attitude, of which fins alone need to know. Neither allocates nor throws.
  ActuatorValues control(const BodyRequest& request, const Vec3& v_b, const Vec3& omega_b, double h,
                         const Eigen::Quaterniond& q_nb = Eigen::Quaterniond::Identity()) noexcept;

  /// The actuator command for a wrench about the body origin; nothing where the actuators do not push.
  std::optional<ActuatorValues> push(const Wrench& tau) const noexcept;

  /// Forgets what the integrators have gathered.
  void reset() noexcept;

 private:
  Boxed<VelocityController> controller_;
  Boxed<ThrustAllocator> allocator_;
  Boxed<FinAutopilot> fins_;
  Shared<std::vector<double BodyRequest::*>> setpoints_;  // of each actuator, without a controller
};

}  // namespace fairway
