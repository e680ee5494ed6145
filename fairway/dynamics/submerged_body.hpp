// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/dynamics/fossen.hpp"
#include "fairway/dynamics/submerged_motion.hpp"

namespace fairway {

/// The numbers of a fully submerged rigid body with diagonal damping. Added mass, damping and displacement
/// belong to water of `density`.
struct SubmergedBodyNumbers {
  double mass{};                                                ///< m [kg]
  double displaced_mass{};                                      ///< B / g [kg] in water of `density`
  double density{1000.0};                                       ///< rho [kg/m3]
  Vec3 r_g = Vec3::Zero();                                      ///< centre of gravity from CO [m, body]
  Vec3 r_b = Vec3::Zero();                                      ///< centre of buoyancy from CO [m, body]
  fossen::Matrix3 inertia = fossen::Matrix3::Zero();            ///< I_g, about the centre of gravity [kg m2]
  fossen::Matrix6 added_mass = fossen::Matrix6::Zero();         ///< M_A = -[X_udot ...]: symmetric, >= 0
  fossen::Vector6 linear_damping = fossen::Vector6::Zero();     ///< -[X_u ... N_r] >= 0 [kg/s, kg m2/s]
  fossen::Vector6 quadratic_damping = fossen::Vector6::Zero();  ///< -[X_|u|u ... N_|r|r] >= 0 [kg/m, kg m2]

  /// Whether the momentum of the translational added mass enters C_A. See SubmergedBody.
  bool munk_moment{true};
};

/// A submerged rigid body in an irrotational current (6.111-6.116, relative form):
///
///     eta' = J(eta) nu
///     nu'  = M^-1 (tau - C(nu_r) nu_r - D(nu_r) nu_r - g(eta)) + nu_c'
///     nu_r = nu - [R^T v_c; 0],   nu_c' = [R^T v_c' - S(omega) R^T v_c; 0],   M = M_RB + M_A
///
/// M_RB and C_RB may stand together with nu_r because m S(omega) does not depend on the linear velocity
/// (chapter 10, irrotational constant current). Where waves accelerate the water by v_c', M nu_c' is what its
/// pressure pushes a neutrally buoyant body with: such a body, released in the water, goes with it exactly.
///
/// `munk_moment` = true takes C_A from all of M_A. The moments it contains, (Z_wdot - X_udot) u w in pitch
/// and (X_udot - Y_vdot) u v in yaw, are those of an ideal fluid on a bare hull and turn it broadside; on a
/// real vehicle the lift of tail and fins opposes them. A set of numbers without lift terms has nothing to
/// oppose them with; `munk_moment` = false then leaves the translational momentum of M_A out of C_A (as
/// Fossen's own remus100 and otter models leave out its pitch and yaw terms, in skew-symmetric pairs) and
/// keeps the rotational block. Either way C_A(nu_r) nu_r does no work.
///
/// Damping and buoyancy scale with the water's density. M_A does not (M^-1 is kept): an error of 2.6 % of M_A
/// in sea water for numbers given in fresh water.
///
/// Constants only. derivative(): O(1), no trigonometry, about 145 products and sums.
class SubmergedBody {
 public:
  explicit SubmergedBody(const SubmergedBodyNumbers& numbers);

  /// State derivative under the wrench `tau` of the actuators about CO [N, N m, body]. The equations stand in
  /// submerged_motion.hpp.
  [[gnu::always_inline]] StateRate derivative(const VehicleState& x, const fossen::Vector6& tau,
                                              const Water& water) const noexcept {
    return derivative(x, lanes::PushOf<double>{Vec3{tau.head<3>()}, Vec3{tau.tail<3>()}}, water);
  }
  [[gnu::always_inline]] StateRate derivative(const VehicleState& x, const lanes::PushOf<double>& push,
                                              const Water& water) const noexcept {
    const Motion rate = lanes::rate_of(numbers_, motion_of(x), push, flow_of(water));
    return {rate.p, {rate.q[1], rate.q[2], rate.q[3], rate.q[0]}, rate.v, rate.omega};
  }

  /// `x` one step of `h` [s] later by the classical Runge-Kutta method of order 4, under the same wrench all
  /// the while; the quaternion is normalised after it.
  [[gnu::always_inline]] VehicleState advanced(const VehicleState& x, const lanes::PushOf<double>& push,
                                               const Water& water, double h) const noexcept {
    const Motion y = lanes::stepped(numbers_, motion_of(x), push, flow_of(water), h);
    return {y.p, {y.q[0], y.q[1], y.q[2], y.q[3]}, y.v, y.omega};
  }

  const lanes::BodyNumbers& numbers() const { return numbers_; }
  const fossen::Matrix6& mass() const { return M_; }  ///< M = M_RB + M_A
  fossen::Matrix6 coriolis_mass() const;              ///< the part of M whose momentum makes C(nu)
  fossen::Vector6 linear_damping() const { return fossen::Vector6{numbers_.linear_damping}; }
  fossen::Vector6 quadratic_damping() const { return fossen::Vector6{numbers_.quadratic_damping}; }

  /// g(eta) when level, in water of the numbers' density.
  fossen::Vector6 level_restoring() const;

  /// Kinetic energy of body and water, nu_r^T M nu_r / 2, plus what gravity and buoyancy have stored
  /// relative to CO at depth 0 [J]. Constant without damping, thrust and current.
  double energy(const VehicleState& x) const;

 private:
  using Motion = lanes::MotionOf<double>;

  static Motion motion_of(const VehicleState& x) {
    return {x.p_n, {x.q_nb.w(), x.q_nb.x(), x.q_nb.y(), x.q_nb.z()}, x.v_b, x.omega_b};
  }
  static lanes::FlowOf<double> flow_of(const Water& water) {
    return {water.current_n, water.current_rate_n, water.density, water.current_n != Vec3::Zero(),
            water.current_rate_n != Vec3::Zero()};
  }

  fossen::Matrix6 M_;
  Vec3 r_g_;
  lanes::BodyNumbers numbers_;
};

}  // namespace fairway
