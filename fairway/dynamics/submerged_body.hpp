// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "fairway/dynamics/fossen.hpp"

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

  /// State derivative under the wrench `tau` of the actuators about CO [N, N m, body].
  [[gnu::always_inline]] StateRate derivative(const VehicleState& x, const fossen::Vector6& tau,
                                              const Water& water) const noexcept {
    return derivative(x, tau.head<3>(), tau.tail<3>(), water);
  }

  /// The same, the wrench given as force [N, body] and moment about CO [N m, body].
  [[gnu::always_inline]] StateRate derivative(const VehicleState& x, const Vec3& force, const Vec3& moment,
                                              const Water& water) const noexcept {
    const Vec3& omega = x.omega_b;
    const double relative_density = water.density * inverse_density_;

    // motion through the water: nu_r = [v; omega]
    const fossen::Matrix3 R = fossen::rotation(x.q_nb);
    const bool flows = water.current_n != Vec3::Zero();
    const Vec3 v_c = flows ? Vec3{R.transpose() * water.current_n} : Vec3{Vec3::Zero()};
    const Vec3 v = x.v_b - v_c;

    // C(nu_r) nu_r = [omega x a; v x a + omega x b] from the momenta a, b
    const auto [a, b] = M_C_.times(v, omega);
    // D(nu_r) nu_r
    const Vec3 drag = D_l_.head<3>() + D_q_.head<3>().cwiseProduct(v.cwiseAbs());
    const Vec3 twist = D_l_.tail<3>() + D_q_.tail<3>().cwiseProduct(omega.cwiseAbs());
    // g(eta)
    const Vec3 down_b = R.row(2).transpose();
    const double B = relative_density * buoyancy_;

    const Vec3 f = force - omega.cross(a) - relative_density * drag.cwiseProduct(v) + (weight_ - B) * down_b;
    const Vec3 m = moment - v.cross(a) - omega.cross(b) - relative_density * twist.cwiseProduct(omega) +
                   (weight_r_g_ - B * r_b_).cross(down_b);
    const auto [v_dot, omega_dot] = M_inverse_.times(f, m);

    StateRate rate;
    rate.p_n.noalias() = R * x.v_b;
    rate.q_nb = fossen::quaternion_rate(x.q_nb, omega);
    rate.v_b = v_dot;
    if (flows) rate.v_b -= omega.cross(v_c);
    if (water.current_rate_n != Vec3::Zero()) [[unlikely]]
      rate.v_b += carried(x, water);
    rate.omega_b = omega_dot;
    return rate;
  }

  const fossen::Matrix6& mass() const { return M_; }  ///< M = M_RB + M_A
  fossen::Matrix6 coriolis_mass() const;              ///< the part of M whose momentum makes C(nu)
  const fossen::Vector6& linear_damping() const { return D_l_; }
  const fossen::Vector6& quadratic_damping() const { return D_q_; }

  /// g(eta) when level, in water of the numbers' density.
  fossen::Vector6 level_restoring() const;

  /// Kinetic energy of body and water, nu_r^T M nu_r / 2, plus what gravity and buoyancy have stored
  /// relative to CO at depth 0 [J]. Constant without damping, thrust and current.
  double energy(const VehicleState& x) const;

 private:
  /// R^T v_c' [m/s2, body]. Not inlined: that would cost still water 4 % of the step.
  [[gnu::noinline, gnu::cold]] static Vec3 carried(const VehicleState& x, const Water& water) noexcept;

  /// A 6 x 6 matrix for products with two 3-vectors. Working in threes keeps values in registers; a diagonal
  /// matrix (CO at the centre of gravity, principal axes) takes 6 products instead of 36.
  struct Blocks {
    fossen::Matrix3 A11, A12, A21, A22;
    Vec3 diagonal_1, diagonal_2;
    bool diagonal{};

    explicit Blocks(const fossen::Matrix6& A);
    std::pair<Vec3, Vec3> times(const Vec3& x, const Vec3& y) const noexcept {
      if (diagonal) return {diagonal_1.cwiseProduct(x), diagonal_2.cwiseProduct(y)};
      return {A11 * x + A12 * y, A21 * x + A22 * y};
    }
  };

  fossen::Matrix6 M_;
  Blocks M_C_;
  Blocks M_inverse_;
  fossen::Vector6 D_l_;
  fossen::Vector6 D_q_;
  Vec3 r_g_;
  Vec3 r_b_;
  Vec3 weight_r_g_;  // W r_g
  double weight_;    // W
  double buoyancy_;  // B in water of the numbers' density
  double inverse_density_;
};

}  // namespace fairway
