// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/submerged_body.hpp"

#include <Eigen/LU>

namespace fairway {
namespace {

fossen::Matrix6 mass_of(const SubmergedBodyNumbers& numbers) {
  return fossen::rigid_body_mass(numbers.mass, numbers.r_g, numbers.inertia) + numbers.added_mass;
}

fossen::Matrix6 coriolis_mass_of(const SubmergedBodyNumbers& numbers) {
  if (numbers.munk_moment) return mass_of(numbers);
  fossen::Matrix6 M = fossen::rigid_body_mass(numbers.mass, numbers.r_g, numbers.inertia);
  M.bottomRightCorner<3, 3>() += numbers.added_mass.bottomRightCorner<3, 3>();
  return M;
}

}  // namespace

SubmergedBody::Blocks::Blocks(const fossen::Matrix6& A)
    : A11{A.topLeftCorner<3, 3>()},
      A12{A.topRightCorner<3, 3>()},
      A21{A.bottomLeftCorner<3, 3>()},
      A22{A.bottomRightCorner<3, 3>()},
      diagonal_1{A11.diagonal()},
      diagonal_2{A22.diagonal()},
      diagonal{(A - fossen::Matrix6{A.diagonal().asDiagonal()}).isZero(0.0)} {}

SubmergedBody::SubmergedBody(const SubmergedBodyNumbers& numbers)
    : M_{mass_of(numbers)},
      M_C_{coriolis_mass_of(numbers)},
      M_inverse_{M_.inverse()},
      D_l_{numbers.linear_damping},
      D_q_{numbers.quadratic_damping},
      r_g_{numbers.r_g},
      r_b_{numbers.r_b},
      weight_r_g_{numbers.mass * fossen::gravity * numbers.r_g},
      weight_{numbers.mass * fossen::gravity},
      buoyancy_{numbers.displaced_mass * fossen::gravity},
      inverse_density_{1.0 / numbers.density} {}

Vec3 SubmergedBody::carried(const VehicleState& x, const Water& water) noexcept {
  return x.q_nb.conjugate() * water.current_rate_n;
}

fossen::Matrix6 SubmergedBody::coriolis_mass() const {
  fossen::Matrix6 M;
  M << M_C_.A11, M_C_.A12, M_C_.A21, M_C_.A22;
  return M;
}

fossen::Vector6 SubmergedBody::level_restoring() const {
  return fossen::restoring(weight_, buoyancy_, r_g_, r_b_, Vec3::UnitZ());
}

double SubmergedBody::energy(const VehicleState& x) const {
  fossen::Vector6 nu;
  nu << x.v_b, x.omega_b;
  const double kinetic = 0.5 * nu.dot(M_ * nu);
  const double depth_of_g = x.p_n.z() + (x.q_nb * r_g_).z();
  const double depth_of_b = x.p_n.z() + (x.q_nb * r_b_).z();
  return kinetic - weight_ * depth_of_g + buoyancy_ * depth_of_b;
}

}  // namespace fairway
