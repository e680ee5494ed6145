// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/fossen.hpp"

#include <cmath>

namespace fairway::fossen {

Matrix6 rigid_body_mass(double m, const Vec3& r_g, const Matrix3& I_g) {
  const Matrix3 S = skew(r_g);
  Matrix6 M;
  M.topLeftCorner<3, 3>() = m * Matrix3::Identity();
  M.topRightCorner<3, 3>() = -m * S;
  M.bottomLeftCorner<3, 3>() = m * S;
  M.bottomRightCorner<3, 3>() = I_g - m * S * S;
  return M;
}

Matrix6 coriolis_matrix(const Matrix6& M, const Vector6& nu) {
  const Vector6 h = M * nu;
  Matrix6 C = Matrix6::Zero();
  C.topRightCorner<3, 3>() = -skew(h.head<3>());
  C.bottomLeftCorner<3, 3>() = -skew(h.head<3>());
  C.bottomRightCorner<3, 3>() = -skew(h.tail<3>());
  return C;
}

double ideal_disk_power(double F, double A, double rho) {
  const double thrust = std::abs(F);
  return thrust * std::sqrt(thrust / (2.0 * rho * A));
}

}  // namespace fairway::fossen
