// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// Fossen's eta and nu: where a vehicle truly is and how it moves.
struct VehicleState {
  Vec3 p_n = Vec3::Zero();                                   ///< body origin [m, NED]
  Eigen::Quaterniond q_nb = Eigen::Quaterniond::Identity();  ///< body to NED, unit
  Vec3 v_b = Vec3::Zero();                                   ///< u, v, w over ground [m/s, body]
  Vec3 omega_b = Vec3::Zero();                               ///< p, q, r [rad/s, body]

  /// Velocity over ground [m/s, NED].
  Vec3 v_n() const { return q_nb * v_b; }
};

/// Roll, pitch and yaw [rad] of Fossen's zyx convention (Fossen 2021, eq. 2.31).
struct Euler {
  double roll{};
  double pitch{};
  double yaw{};
};

inline double yaw_of(const Eigen::Quaterniond& q) {
  return math::atan2(2.0 * (q.w() * q.z() + q.x() * q.y()), 1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
}

inline Euler euler_of(const Eigen::Quaterniond& q) {
  const double sin_pitch = 2.0 * (q.w() * q.y() - q.z() * q.x());
  return {
      .roll = math::atan2(2.0 * (q.w() * q.x() + q.y() * q.z()), 1.0 - 2.0 * (q.x() * q.x() + q.y() * q.y())),
      .pitch = math::asin(math::fmax(-1.0, math::fmin(1.0, sin_pitch))),
      .yaw = yaw_of(q)};
}

inline Eigen::Quaterniond quaternion_of(const Euler& e) {
  const auto [sr, cr] = math::sin_cos(e.roll / 2);
  const auto [sp, cp] = math::sin_cos(e.pitch / 2);
  const auto [sy, cy] = math::sin_cos(e.yaw / 2);
  return {cy * cp * cr + sy * sp * sr, cy * cp * sr - sy * sp * cr, cy * sp * cr + sy * cp * sr,
          sy * cp * cr - cy * sp * sr};
}

inline bool is_finite(const VehicleState& x) {
  return is_finite(x.p_n) && is_finite(x.v_b) && is_finite(x.omega_b) && x.q_nb.coeffs().allFinite();
}

}  // namespace fairway
