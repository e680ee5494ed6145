// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/dynamics/fossen.hpp"

namespace fairway {

/// A vehicle without forces: its velocities through the water follow setpoints within limits, it keeps
/// level and, unless it is given sway, never slips sideways. README.md beside this file has the equations.
class Kinematic {
 public:
  static constexpr VehicleInfo info{.name = "kinematic",
                                    .title = "Limited velocities, no forces",
                                    .source =
                                        "unicycle with first-order, limited response; "
                                        "fairway/dynamics/kinematic/README.md"};

  struct Params {
    double max_speed_mps{0.5};
    double max_reverse_mps{0.5};
    double max_sway_mps{0.0};
    double max_heave_mps{0.5};
    double max_turn_rate_radps{0.45};
    double max_acceleration_mps2{0.5};
    double max_turn_acceleration_radps2{0.5};
    double time_constant_s{0.2};

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::max_speed_mps>({0, 50}, "fastest ahead through the water"),
          field<&P::max_reverse_mps>({0, 50}, "fastest astern"),
          field<&P::max_sway_mps>({0, 50}, "fastest to either side; 0 for a vehicle that cannot"),
          field<&P::max_heave_mps>({0, 50}, "fastest down and up; 0 for a surface vehicle"),
          field<&P::max_turn_rate_radps>({0, 10}, "fastest turn to either side"),
          field<&P::max_acceleration_mps2>({0.001, 100}, "of surge, sway and heave together"),
          field<&P::max_turn_acceleration_radps2>({0.001, 100}, "of the turn rate"),
          field<&P::time_constant_s>({0.02, 10},
                                     "of the approach to a setpoint; steps of up to 2.7 times it are stable"),
      };
    }
  };

  explicit Kinematic(const Params& params);

  /// surge_mps, heave_mps (positive down), yaw_rate_radps (positive to starboard) and, where there is sway,
  /// sway_mps (positive to starboard): setpoints through the water.
  std::span<const ActuatorInfo> actuators() const {
    return std::span{actuators_}.first(sways_ ? actuators_.size() : actuators_.size() - 1);
  }

  [[gnu::always_inline]] StateRate derivative(const VehicleState& x, const ActuatorValues& u,
                                              const Water& water) const noexcept {
    const fossen::Matrix3 R = fossen::rotation(x.q_nb);
    const Vec3 v_c = R.transpose() * water.current_n;

    // first-order approach, no faster than the acceleration limits
    const Vec3 v = x.v_b - v_c;
    const double sway = sways_ ? u[3] : 0.0;
    Vec3 a = rate_ * (Vec3{u[0], sway, u[1]} - v);
    if (a.squaredNorm() > max_acceleration_ * max_acceleration_) a *= max_acceleration_ / a.norm();
    const Vec3 alpha = rate_ * (Vec3{0.0, 0.0, u[2]} - x.omega_b);

    StateRate rate;
    rate.p_n.noalias() = R * x.v_b;
    rate.q_nb = fossen::quaternion_rate(x.q_nb, x.omega_b);
    rate.v_b = a - x.omega_b.cross(v_c) + R.transpose() * water.current_rate_n;
    rate.omega_b = alpha.cwiseMax(-max_turn_acceleration_).cwiseMin(max_turn_acceleration_);
    return rate;
  }

  /// Nothing is known about its drive: 0.
  double power(const ActuatorValues&) const noexcept { return 0.0; }

 private:
  double rate_;  // 1 / time constant [1/s]
  double max_acceleration_;
  double max_turn_acceleration_;
  bool sways_;
  std::array<ActuatorInfo, 4> actuators_;
};

}  // namespace fairway
