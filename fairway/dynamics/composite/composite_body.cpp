// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/composite/composite_body.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace fairway {
namespace {

using fossen::Matrix6;
using fossen::Vector6;

/// Velocities and wrenches of surge, sway and yaw among all six.
Eigen::Matrix<double, 6, 3> planar_axes() {
  Eigen::Matrix<double, 6, 3> E = Eigen::Matrix<double, 6, 3>::Zero();
  E(0, 0) = E(1, 1) = E(5, 2) = 1.0;
  return E;
}

}  // namespace

CompositeBody::Composition::Composition(std::span<const Part> parts, bool quadratic_drag) {
  if (parts.empty()) throw InputError("a composite body has no parts");
  const double density = parts.front().numbers.density;
  inverse_density = 1.0 / density;
  for (const Part& part : parts) add(part, density / part.numbers.density, quadratic_drag);
}

void CompositeBody::Composition::add(const Part& part, double relative_density, bool quadratic_drag) {
  const SubmergedBodyNumbers& n = part.numbers;
  const SubmergedBody body{n};
  const Matrix6 H = velocity_transform(part);

  M += H.transpose() * body.mass() * H;
  M_C += H.transpose() * body.coriolis_mass() * H;
  D_l += relative_density * H.transpose() * n.linear_damping.asDiagonal() * H;
  if (quadratic_drag) {
    for (int i = 0; i < 6; ++i) {
      add_line<6>(lines, H.row(i).transpose(), relative_density * n.quadratic_damping[i]);
    }
  }

  const double W = n.mass * fossen::gravity;
  const double B = relative_density * n.displaced_mass * fossen::gravity;
  weight += W;
  buoyancy += B;
  weight_moment += W * (part.position + part.orientation * n.r_g);
  buoyancy_moment += B * (part.position + part.orientation * n.r_b);
}

template <int N>
CompositeBody::Axes<N>::Axes(const Composition& whole, const Eigen::Matrix<double, 6, N>& free)
    : M_C{free.transpose() * whole.M_C * free}, D_l{free.transpose() * whole.D_l * free} {
  const Eigen::LLT<Matrix> M{free.transpose() * whole.M * free};
  if (M.info() != Eigen::Success)
    throw InputError("the mass matrix of a composite body is not positive definite");
  M_inverse = M.solve(Matrix::Identity());
  for (const DragLine<6>& line : whole.lines) {
    add_line<N>(lines, free.transpose() * line.direction, line.coefficient);
  }
}

CompositeBody::CompositeBody(std::span<const Part> parts, const Options& options)
    : options_{options},
      whole_{parts, options.quadratic_drag},
      axes_{options.degrees_of_freedom == DegreesOfFreedom::six
                ? decltype(axes_){Axes<6>{whole_, Matrix6::Identity()}}
                : decltype(axes_){Axes<3>{whole_, planar_axes()}}} {}

template <int N>
void CompositeBody::add_line(DragLines<N>& lines, const Eigen::Matrix<double, N, 1>& row,
                             double coefficient) {
  const double length = row.norm();
  if (!(coefficient > 0.0) || length < 1e-9) return;
  const Eigen::Matrix<double, N, 1> direction = row / length;
  const double along_unit = coefficient * length * length * length;
  for (DragLine<N>& line : lines) {
    // |1 - |cos|| = angle^2 / 2: opposite directions are the same line
    if (1.0 - std::abs(line.direction.dot(direction)) > 1e-14) continue;
    line.coefficient += along_unit;
    return;
  }
  lines.push_back({direction, along_unit});
}

template <int N>
Eigen::Matrix<double, N, 1> CompositeBody::drag_of(const DragLines<N>& lines,
                                                   const Eigen::Matrix<double, N, 1>& nu) noexcept {
  Eigen::Matrix<double, N, 1> drag = Eigen::Matrix<double, N, 1>::Zero();
  for (const DragLine<N>& line : lines) {
    const double along = line.direction.dot(nu);
    drag += (line.coefficient * std::abs(along) * along) * line.direction;
  }
  return drag;
}

Vector6 CompositeBody::quadratic_drag(const Vector6& nu) const noexcept { return drag_of(whole_.lines, nu); }

Vector6 CompositeBody::quadratic_damping() const {
  Vector6 pure;
  for (int axis = 0; axis < 6; ++axis) pure[axis] = quadratic_drag(Vector6::Unit(axis))[axis];
  return pure;
}

Vector6 CompositeBody::level_restoring() const {
  if (options_.degrees_of_freedom == DegreesOfFreedom::planar) return Vector6::Zero();
  Vector6 g = Vector6::Zero();
  g[2] = whole_.buoyancy - whole_.weight;
  g.tail<3>() = (whole_.buoyancy_moment - whole_.weight_moment).cross(Vec3::UnitZ());
  return g;
}

StateRate CompositeBody::derivative(const VehicleState& x, const Vector6& tau,
                                    const Water& water) const noexcept {
  if (const auto* planar = std::get_if<Axes<3>>(&axes_)) return rate(*planar, x, tau, water);
  return rate(*std::get_if<Axes<6>>(&axes_), x, tau, water);
}

StateRate CompositeBody::rate(const Axes<3>& axes, const VehicleState& x, const Vector6& tau,
                              const Water& water) const noexcept {
  const double relative_density = water.density * whole_.inverse_density;

  // motion through the water
  const Eigen::Quaterniond& q = x.q_nb;
  const double cos_yaw = 1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z());
  const double sin_yaw = 2.0 * (q.w() * q.z() + q.x() * q.y());
  const double u = x.v_b.x(), v = x.v_b.y(), r = x.omega_b.z();
  const auto in_body = [&](const Vec3& a) {
    return Vec2{cos_yaw * a.x() + sin_yaw * a.y(), cos_yaw * a.y() - sin_yaw * a.x()};
  };
  const Vec2 v_c = in_body(water.current_n), v_c_dot = in_body(water.current_rate_n);
  const Vec3 nu{u - v_c.x(), v - v_c.y(), r};

  Vec3 force{tau[0], tau[1], tau[5]};
  force -= relative_density * (axes.D_l * nu + drag_of(axes.lines, nu));
  if (options_.coriolis) {
    const double a_x = axes.M_C.row(0).dot(nu), a_y = axes.M_C.row(1).dot(nu);
    force -= Vec3{-r * a_y, r * a_x, nu.x() * a_y - nu.y() * a_x};
  }
  const Vec3 nu_dot = axes.M_inverse * force;

  StateRate rate;
  rate.p_n = {cos_yaw * u - sin_yaw * v, sin_yaw * u + cos_yaw * v, 0.0};
  rate.q_nb = fossen::quaternion_rate(q, {0.0, 0.0, r});
  rate.v_b = {nu_dot.x() + r * v_c.y() + v_c_dot.x(), nu_dot.y() - r * v_c.x() + v_c_dot.y(), 0.0};
  rate.omega_b = {0.0, 0.0, nu_dot.z()};
  return rate;
}

StateRate CompositeBody::rate(const Axes<6>& axes, const VehicleState& x, const Vector6& tau,
                              const Water& water) const noexcept {
  const double relative_density = water.density * whole_.inverse_density;

  // motion through the water
  const fossen::Matrix3 R = fossen::rotation(x.q_nb);
  const Vec3 v_c = R.transpose() * water.current_n;
  Vector6 nu;
  nu << x.v_b - v_c, x.omega_b;

  // tau - C(nu_r) nu_r - D_l nu_r - d_q(nu_r) - g(eta)
  Vector6 force = tau - relative_density * (axes.D_l * nu + drag_of(axes.lines, nu));
  if (options_.coriolis) {
    const Vector6 h = axes.M_C * nu;
    force -= fossen::coriolis_force(h, nu.head<3>(), nu.tail<3>());
  }
  const Vec3 down_b = R.row(2).transpose();
  const double B = relative_density * whole_.buoyancy;
  force.head<3>() += (whole_.weight - B) * down_b;
  force.tail<3>() += (whole_.weight_moment - relative_density * whole_.buoyancy_moment).cross(down_b);
  const Vector6 nu_dot = axes.M_inverse * force;

  StateRate rate;
  rate.p_n = R * x.v_b;
  rate.q_nb = fossen::quaternion_rate(x.q_nb, x.omega_b);
  rate.v_b = nu_dot.head<3>() - x.omega_b.cross(v_c) + R.transpose() * water.current_rate_n;
  rate.omega_b = nu_dot.tail<3>();
  return rate;
}

}  // namespace fairway
