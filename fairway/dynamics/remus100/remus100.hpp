// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/dynamics/cross_flow.hpp"
#include "fairway/dynamics/fin_drive.hpp"
#include "fairway/dynamics/fossen.hpp"

namespace fairway {

/// REMUS 100, a torpedo-shaped AUV (1.6 m x 0.19 m, 31.9 kg) with a rudder, stern planes and one propeller
/// (Fossen 2021, 6.111 to 6.116, relative form; section 8.4.2 for its numbers):
///
///     M nu_r' + C(nu_r) nu_r + D(U) nu_r + g(eta) = tau + lift and drag + cross-flow,    M = M_RB + M_A
///
/// The hull is a prolate spheroid about the body origin, neutrally buoyant. The water is sea water of
/// 1026 kg/m3, whatever `Water::density` says, as every number belongs to it.
///
/// Rudder, planes and propeller push by the speed through the water as well as by their own setting, so that
/// there is no Propulsion but a FinDrive. README.md beside this file has equations, numbers and limits.
class Remus100 {
 public:
  static constexpr VehicleInfo info{
      .name = "remus100",
      .title = "REMUS 100 AUV",
      .source =
          "Fossen, MSS toolbox, remus100.m (2025), drag and propeller after Allen et al. (2000); "
          "fairway/dynamics/remus100/README.md"};

  struct Params {
    double surge_time_constant_s{20.0}, sway_time_constant_s{20.0}, yaw_time_constant_s{1.0};
    double roll_damping_ratio{0.3}, pitch_damping_ratio{0.8};
    double drag_ratio{0.42};
    double rudder_lift_ratio{0.5}, stern_lift_ratio{0.7};
    double fin_time_constant_s{1.0}, propeller_time_constant_s{1.0};

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::surge_time_constant_s>({0.1, 1000}, "of surge by linear damping at standstill"),
          field<&P::sway_time_constant_s>({0.1, 1000}, "of sway and heave by linear damping alone"),
          field<&P::yaw_time_constant_s>({0.1, 1000}, "of yaw by linear damping alone"),
          field<&P::roll_damping_ratio>({0, 2}, "linear damping in roll, of critical"),
          field<&P::pitch_damping_ratio>({0, 2}, "linear damping in pitch, of critical"),
          field<&P::drag_ratio>({0.01, 2}, "drag coefficient of the hull by its frontal area"),
          field<&P::rudder_lift_ratio>({0, 10}, "lift coefficient of the rudder per radian"),
          field<&P::stern_lift_ratio>({0, 10}, "lift coefficient of the stern planes per radian"),
          field<&P::fin_time_constant_s>({0, 10}, "lag of rudder and stern planes"),
          field<&P::propeller_time_constant_s>({0, 10}, "lag of the propeller"),
      };
    }
  };

  explicit Remus100(const Params& params);

  /// rudder_rad (positive turns to starboard), stern_rad (positive dives), n_rpm.
  std::span<const ActuatorInfo> actuators() const { return actuators_; }

  /// State derivative. About 0.2 us.
  StateRate derivative(const VehicleState& x, const ActuatorValues& u, const Water& water) const noexcept;

  /// The power of the propeller's shaft in steady straight running [W]: 2 pi n Q at the advance number
  /// 0.6632. The vehicle settles within 2 % of that whatever n; held fast it takes 2.2 times as much.
  double power(const ActuatorValues& u) const noexcept;

  const FinDrive& fin_drive() const { return fin_drive_; }

  const fossen::Matrix6& mass() const { return M_; }  ///< M = M_RB + M_A

 private:
  /// Force along and moment about the x axis of the body.
  struct Screw {
    double thrust_n;
    double torque_nm;
  };

  FinDrive describe_drive() const;
  static Screw propeller(double n_rps, double speed) noexcept;
  fossen::Vector6 actuator_wrench(const ActuatorValues& u, const Vec3& v) const noexcept;
  fossen::Vector6 hull_wrench(const Vec3& v, const Vec3& omega) const noexcept;
  fossen::Vector6 coriolis(const Vec3& v, const Vec3& omega) const noexcept;

  fossen::Matrix6 M_RB_;
  fossen::Vector6 M_A_;  // diagonal
  fossen::Matrix6 M_;
  fossen::Matrix6 M_inverse_;
  fossen::Vector6 D_;  // at standstill
  double weight_;      // W = B [N]
  double parasitic_drag_;
  double rudder_lift_, stern_lift_;
  CylinderDrag cylinder_;
  CrossFlow strips_;
  std::array<ActuatorInfo, 3> actuators_;
  FinDrive fin_drive_;
};

}  // namespace fairway
