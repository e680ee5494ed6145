// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/dynamics/cross_flow.hpp"
#include "fairway/dynamics/fossen.hpp"

namespace fairway {

/// What can be changed about an Otter.
struct OtterParams {
  double payload_kg{25.0};
  double payload_x_m{0.05}, payload_y_m{0.0}, payload_z_m{-0.35};
  double max_speed_mps{3.0864};
  double sway_time_constant_s{1.0}, yaw_time_constant_s{1.0};
  double propeller_time_constant_s{0.1};
  double propeller_diameter_m{0.2};

  static consteval auto fields() {
    using P = OtterParams;
    return std::tuple{
        field<&P::payload_kg>({0, 45}, "mass of what it carries"),
        field<&P::payload_x_m>({-1, 1}, "centre of the payload, forward of the body origin"),
        field<&P::payload_y_m>({-0.5, 0.5}, "centre of the payload, to starboard"),
        field<&P::payload_z_m>({-1, 0.2}, "centre of the payload, below; negative is above"),
        field<&P::max_speed_mps>({0.5, 10}, "steady speed at full thrust: sets the damping in surge"),
        field<&P::sway_time_constant_s>({0.05, 100}, "of sway by linear damping alone"),
        field<&P::yaw_time_constant_s>({0.05, 100}, "of yaw by linear damping alone"),
        field<&P::propeller_time_constant_s>({0, 10}, "lag of the propellers"),
        field<&P::propeller_diameter_m>({0.01, 1}, "of each propeller; for power only"),
    };
  }
};

/// The hull of an Otter, a catamaran of 2.0 m, under the thrust of its two propellers (Fossen 2021, 6.111 to
/// 6.116, relative form, with linear hydrostatics):
///
///     M nu_r' + C(nu_r) nu_r + D(nu_r) nu_r + G eta_s = tau + cross-flow + g_0(eta_s),    M = M_RB + M_A
///
/// The body origin is midships on the centreline in the waterline without payload. The payload is part of M
/// and C; its weight enters as the external g_0, which depends on the attitude. eta_0 = G^-1 g_0 is the trim.
/// eta_s is eta as seen from the surface of the water.
///
/// Roll and pitch of a state include the trim, the axes that the hull moves along do not: positions and
/// angles follow eta' = J(eta - eta_0) nu, as published, so that a trimmed boat runs level.
///
/// The current is turned by yaw alone. z, roll and pitch are held to the surface: on waves, which are taken
/// as long against the boat, it lies on their slope. The water is sea water of 1025 kg/m3, whatever
/// `Water::density` says, as every number belongs to it.
///
/// Constants only. README.md beside this file has every number.
class OtterHull {
 public:
  static constexpr double propeller_y_m = 0.395;         ///< to either side, at the pontoons' centrelines
  static constexpr double density_kgpm3 = 1025.0;        ///< of the water
  static constexpr double yaw_quadratic_damping = 10.0;  ///< N = N_r (1 + 10 |r|) r [s/rad]
  static constexpr double max_ahead_n = 0.5 * 24.4 * fossen::gravity;   ///< of each propeller, bollard pull
  static constexpr double max_astern_n = 0.5 * 13.6 * fossen::gravity;  ///< of each propeller, bollard pull

  /// Throws InputError if the boat has no positive metacentric height under its payload.
  explicit OtterHull(const OtterParams& params);

  /// State derivative under the thrust [N, positive ahead] of the two propellers. About 0.2 us.
  StateRate derivative(const VehicleState& x, double port_n, double starboard_n,
                       const Water& water) const noexcept;

  /// How it floats at rest in still water, heading north: nothing moves.
  VehicleState floating() const;

  const fossen::Matrix6& mass() const { return M_; }            ///< M = M_RB + M_A
  const fossen::Vector6& linear_damping() const { return D_; }  ///< -[X_u ... N_r]

 private:
  /// z, roll and pitch: what the water holds the boat by.
  using Hydrostatic = Vec3;

  Hydrostatic trim(const Vec3& down_b) const noexcept;

  fossen::Matrix6 M_;
  fossen::Matrix6 M_inverse_;
  fossen::Vector6 D_;
  fossen::Matrix3 G_;
  fossen::Matrix3 G_inverse_;
  Vec3 payload_;           // r_p [m, body]
  double payload_weight_;  // [N]
  double strip_coefficient_;
  CrossFlow strips_;
};

}  // namespace fairway
