// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/submerged_body.hpp"

#include <Eigen/LU>
#include <algorithm>

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

lanes::Blocks blocks_of(const fossen::Matrix6& A) {
  lanes::Blocks blocks;
  for (Eigen::Index i = 0; i < 6; ++i)
    for (Eigen::Index j = 0; j < 6; ++j) blocks.rows[i][j] = A(i, j);
  blocks.diagonal = (A - fossen::Matrix6{A.diagonal().asDiagonal()}).isZero(0.0);
  return blocks;
}

lanes::BodyNumbers plain(const SubmergedBodyNumbers& numbers) {
  lanes::BodyNumbers plain{.coriolis = blocks_of(coriolis_mass_of(numbers)),
                           .inverse_mass = blocks_of(mass_of(numbers).inverse()),
                           .weight = numbers.mass * fossen::gravity,
                           .buoyancy = numbers.displaced_mass * fossen::gravity,
                           .inverse_density = 1.0 / numbers.density};
  std::ranges::copy(numbers.linear_damping, plain.linear_damping);
  std::ranges::copy(numbers.quadratic_damping, plain.quadratic_damping);
  std::ranges::copy(numbers.r_b, plain.r_b);
  std::ranges::copy(Vec3{plain.weight * numbers.r_g}, plain.weight_r_g);
  return plain;
}

}  // namespace

SubmergedBody::SubmergedBody(const SubmergedBodyNumbers& numbers)
    : M_{mass_of(numbers)}, r_g_{numbers.r_g}, numbers_{plain(numbers)} {}

fossen::Matrix6 SubmergedBody::coriolis_mass() const {
  fossen::Matrix6 M;
  for (Eigen::Index i = 0; i < 6; ++i)
    for (Eigen::Index j = 0; j < 6; ++j) M(i, j) = numbers_.coriolis.rows[i][j];
  return M;
}

fossen::Vector6 SubmergedBody::level_restoring() const {
  return fossen::restoring(numbers_.weight, numbers_.buoyancy, r_g_, Vec3{numbers_.r_b}, Vec3::UnitZ());
}

double SubmergedBody::energy(const VehicleState& x) const {
  fossen::Vector6 nu;
  nu << x.v_b, x.omega_b;
  const double kinetic = 0.5 * nu.dot(M_ * nu);
  const double depth_of_g = x.p_n.z() + (x.q_nb * r_g_).z();
  const double depth_of_b = x.p_n.z() + (x.q_nb * Vec3{numbers_.r_b}).z();
  return kinetic - numbers_.weight * depth_of_g + numbers_.buoyancy * depth_of_b;
}

}  // namespace fairway
