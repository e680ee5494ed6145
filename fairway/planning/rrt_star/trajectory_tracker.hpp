// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/core/params.hpp"
#include "fairway/planning/minimum_snap/trajectory.hpp"

namespace fairway {

/// Gains of the tracking of a trajectory; those of forces are rehman2021's (Table 8).
struct TrackingParams {
  double kp_x_npm = 10.0;
  double kd_x_npmps = 80.0;
  double kp_y_npm = 20.0;
  double kd_y_npmps = 40.0;
  double kp_psi_nmprad = 5.0;
  double kd_psi_nmpradps = 1.0;
  double integral_hz = 0.0;
  bool feed_forward = true;
  double heading_rad = 0.0;
  double position_bandwidth_radps = 0.3;

  static consteval auto fields() {
    using P = TrackingParams;
    constexpr Range gain{0, 1e6};
    return std::tuple{
        field<&P::kp_x_npm>(gain, "force north per position error"),
        field<&P::kd_x_npmps>(gain, "force north per velocity error"),
        field<&P::kp_y_npm>(gain, "force east per position error"),
        field<&P::kd_y_npmps>(gain, "force east per velocity error"),
        field<&P::kp_psi_nmprad>(gain, "moment per heading error"),
        field<&P::kd_psi_nmpradps>(gain, "moment per yaw rate"),
        field<&P::integral_hz>({0, 100}, "rate at which the proportional parts are integrated (1 / T_i)"),
        field<&P::feed_forward>("add the forces that the trajectory takes by the model of the vehicle"),
        field<&P::heading_rad>({-6.3, 6.3}, "held while forces are commanded"),
        field<&P::position_bandwidth_radps>({0, 10}, "velocity command per position error"),
    };
  }
};

/// Follows a trajectory, by velocity and, where the situation has a model of the vehicle, by force
/// (rehman2021, section IV-B-2). With e the Earth-fixed error of position and R the rotation from body axes:
///
///     velocity   v_d + omega e                                        omega = position_bandwidth_radps
///     force      R^T (Kp e + Kd e' + Ki int e) + m a_d + d(v_d)       the last two with feed_forward, in
///     body axes moment     kp_psi e_psi - kd_psi r + ki_psi int e_psi           at the heading heading_rad
///
/// What restores the vehicle at rest is balanced; roll and pitch are left alone. All in the horizontal plane:
/// the velocity is level. Water is taken to be at rest.
struct TrajectoryTracker {
  /// Integral parts: force north and east [N], moment [N m].
  struct Memory {
    Vec3 integral = Vec3::Zero();
  };

  TrackingParams params;

  /// What to do at `time` [s] of the trajectory. Where forces are commanded, the heading is too. The integral
  /// parts grow no larger than what the actuators give. O(log segments), neither allocates nor throws.
  Command follow(const Trajectory& trajectory, double time, const Situation& s,
                 Memory& memory) const noexcept;
};

}  // namespace fairway
