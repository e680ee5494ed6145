// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/vec.hpp"

namespace fairway {

/// What is believed of something that moves: position and velocity with the covariance of their error, as
/// three by three blocks. It keeps its velocity but for white noise of acceleration (Bar-Shalom, Li,
/// Kirubarajan 2001, section 6.2.2).
struct ConstantVelocity {
  Vec3 position = Vec3::Zero();             ///< [m, NED]
  Vec3 velocity = Vec3::Zero();             ///< [m/s, NED]
  Mat3 position_covariance = Mat3::Zero();  ///< [m2], symmetric
  Mat3 cross_covariance = Mat3::Zero();     ///< of position with velocity [m2/s]
  Mat3 velocity_covariance = Mat3::Zero();  ///< [m2/s2], symmetric

  /// After `period` [s], with accelerations of spectral density `density` [m2/s3] along each axis.
  ConstantVelocity predicted(double period, double density) const;

  /// With a measured position whose error has the positive definite `covariance`: the Kalman filter's update,
  /// in Joseph's form, which stays symmetric and positive.
  ConstantVelocity corrected(const Vec3& measured, const Mat3& covariance) const;
};

}  // namespace fairway
