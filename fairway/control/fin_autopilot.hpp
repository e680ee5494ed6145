// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/control/acceleration_observer.hpp"
#include "fairway/control/body_request.hpp"
#include "fairway/core/vec.hpp"
#include "fairway/dynamics/actuators.hpp"
#include "fairway/dynamics/fin_drive.hpp"

namespace fairway {

/// Drives surge, heave and yaw rate of a body with a propeller, a rudder and stern planes; sway is nobody's.
/// Each in its cascade (Fossen 2021, chapter 15), with U the speed through the water and a what an
/// AccelerationObserver has learnt of its axis:
///
///     speed_per_turn n = u_d + (omega (u_d - u) - a) surge_distance / u
///     rudder_moment U^2 rudder = yaw_damping r_d + I_z (omega (r_d - r) - a)
///     theta_d = alpha - asin(w_d / U)                              alpha: the angle of attack, as measured
///     stern_moment U^2 stern = pitch_restoring sin(theta_d) + k_theta (theta_d - theta) - k_q q - I_y a
///
/// with k_theta = max(0, I_y omega_theta^2 - pitch_restoring), k_q = max(0, 2 omega_theta I_y -
/// pitch_damping): where the body rights itself faster than that, its planes only hold it. All gains come
/// from the model: omega from the lag of the fins. Below steerage_way() fins are set as if at it, so that
/// their angles stay bounded, and steer less. A value; control() neither allocates nor throws.
class FinAutopilot {
 public:
  /// Throws InputError for a body that its fins do not turn.
  FinAutopilot(const FinDrive& drive, std::span<const ActuatorInfo> actuators);

  /// Actuator commands for the next `h` [s], within their limits, from velocities through the water [body
  /// axes] and the pitch [rad]; `heave_mps` is how fast it is to sink through the water, whatever its pitch.
  /// A request or a velocity that is not finite counts as 0.
  ActuatorValues control(const BodyRequest& request, double pitch, const Vec3& v_b, const Vec3& omega_b,
                         double h) noexcept;

  /// The least speed through the water at which its planes hold a pitch of 0.2 rad [m/s].
  double steerage_way() const { return steerage_way_; }
  /// Yaw rate to ask for by heading error, a third of the bandwidth of yaw rate [1/s].
  double turn_gain() const { return bandwidth_ / 3.0; }
  /// The radius of the circle that the rudder hard over and linear damping give at `speed` through the water
  /// [m]; drag across the hull makes it wider.
  double turning_radius(double speed) const;

  /// Forgets the accelerations learnt so far.
  void reset() noexcept;

 private:
  double propeller_for(double surge, double u) const noexcept;
  double rudder_for(double yaw_rate, double r, double U2) const noexcept;
  double stern_for(double sinking, double pitch, const Vec3& v_b, double q, double U2) const noexcept;
  void observe(double pitch, const Vec3& v_b, const Vec3& omega_b, double U2) noexcept;

  FinDrive drive_;
  double largest_rudder_{};  // either way [rad]
  double largest_stern_{};
  double bandwidth_{};  // omega [rad/s]
  double steerage_way_{};
  Actuators actuators_;  // as they should be
  ActuatorValues mean_;  // over their last step
  AccelerationObserver surge_, yaw_, pitch_;
  double kept_{1.0};  // exp(-omega h) for the actuators' step
};

}  // namespace fairway
