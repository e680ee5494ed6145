// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "fairway/core/state.hpp"
#include "fairway/dynamics/vehicle_model.hpp"

/// The terms of Fossen's equations of motion as separate functions, in his symbols. Theorem and
/// equation numbers are those of T. I. Fossen, Handbook of Marine Craft Hydrodynamics and Motion
/// Control, 2nd edition, Wiley 2021. CO is the body origin; nu = [u v w p q r] holds its velocity
/// and the angular velocity in body axes.
namespace fairway::fossen {

using Matrix3 = Eigen::Matrix3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Acceleration of gravity g [m/s2].
inline constexpr double gravity = 9.81;

/// S(a), the matrix of the cross product: S(a) b = a x b.
inline Matrix3 skew(const Vec3& a) {
  return Matrix3{{0.0, -a.z(), a.y()}, {a.z(), 0.0, -a.x()}, {-a.y(), a.x(), 0.0}};
}

/// M_RB [kg, kg m, kg m2] of mass `m` [kg] whose centre of gravity lies `r_g` [m, body] from CO and whose
/// inertia about that centre is `I_g` [kg m2] (section 3.3: parallel axes, I_b = I_g - m S(r_g)^2).
Matrix6 rigid_body_mass(double m, const Vec3& r_g, const Matrix3& I_g);

/// C(nu) of a symmetric mass matrix by its momenta a = M11 v + M12 omega, b = M21 v + M22 omega
/// (Theorem 3.2): [0, -S(a); -S(a), -S(b)]. Skew-symmetric. For checks; the simulation needs only the
/// product.
Matrix6 coriolis_matrix(const Matrix6& M, const Vector6& nu);

/// C(nu) nu = [omega x a; v x a + omega x b] from the momenta h = [a; b] = M nu (Theorem 3.2). It does no
/// work: nu^T C(nu) nu = omega.(v x a) + v.(omega x a) = 0 for any h. 18 products.
inline Vector6 coriolis_force(const Vector6& h, const Vec3& v, const Vec3& omega) {
  const Vec3 a = h.head<3>(), b = h.tail<3>();
  Vector6 force;
  force.head<3>() = omega.cross(a);
  force.tail<3>() = v.cross(a) + omega.cross(b);
  return force;
}

/// R(q), body to NED (section 2.2.2), of a quaternion near unit length.
inline Matrix3 rotation(const Eigen::Quaterniond& q) { return q.toRotationMatrix(); }

/// q' = T(q) omega (2.78), as coefficients x, y, z, w.
inline Eigen::Vector4d quaternion_rate(const Eigen::Quaterniond& q, const Vec3& omega) {
  const double p = 0.5 * omega.x(), q_ = 0.5 * omega.y(), r = 0.5 * omega.z();
  return {q.w() * p + q.y() * r - q.z() * q_,  //
          q.w() * q_ + q.z() * p - q.x() * r,  //
          q.w() * r + q.x() * q_ - q.y() * p,  //
          -q.x() * p - q.y() * q_ - q.z() * r};
}

/// g(eta) of a submerged body (section 4.1): weight `W` [N] at `r_g`, buoyancy `B` [N] at `r_b` [m, body];
/// `down_b` is the third row of R, the direction of gravity in body axes.
inline Vector6 restoring(double W, double B, const Vec3& r_g, const Vec3& r_b, const Vec3& down_b) {
  Vector6 g;
  g.head<3>() = (B - W) * down_b;
  g.tail<3>() = (B * r_b - W * r_g).cross(down_b);
  return g;
}

/// The column of the thrust configuration matrix of a thruster at `position` [m, body] pushing along the
/// unit vector `direction` [body] (section 11.1): body wrench per newton.
inline Vector6 thruster_column(const Vec3& position, const Vec3& direction) {
  Vector6 column;
  column.head<3>() = direction;
  column.tail<3>() = position.cross(direction);
  return column;
}

/// Power [W] that an ideal actuator disk of area `A` [m2] takes to push with `F` [N] in still water of
/// density `rho` [kg/m3]: |F|^(3/2) / sqrt(2 rho A). Losses of propeller, motor and drive come on top.
double ideal_disk_power(double F, double A, double rho);

}  // namespace fairway::fossen
