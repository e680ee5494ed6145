// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/tracker/constant_velocity.hpp"

#include <Eigen/LU>

namespace fairway {
namespace {

/// The symmetric part of a matrix that is symmetric but for rounding.
Mat3 symmetric(const Mat3& m) { return 0.5 * (m + m.transpose()); }

}  // namespace

ConstantVelocity ConstantVelocity::predicted(double period, double density) const {
  const double t = period;
  const Mat3 noise = density * t * Mat3::Identity();
  const Mat3 swept = cross_covariance + cross_covariance.transpose();
  return {.position = position + t * velocity,
          .velocity = velocity,
          .position_covariance =
              position_covariance + t * swept + t * t * velocity_covariance + (t * t / 3.0) * noise,
          .cross_covariance = cross_covariance + t * velocity_covariance + (0.5 * t) * noise,
          .velocity_covariance = velocity_covariance + noise};
}

ConstantVelocity ConstantVelocity::corrected(const Vec3& measured, const Mat3& covariance) const {
  const Mat3 inverse = symmetric((position_covariance + covariance).inverse());
  const Mat3 gain = position_covariance * inverse;
  const Mat3 rate_gain = cross_covariance.transpose() * inverse;
  const Vec3 innovation = measured - position;

  // (I - K H) P (I - K H)' + K R K', block by block
  const Mat3 kept = Mat3::Identity() - gain;
  const Mat3 moved = cross_covariance - position_covariance * rate_gain.transpose();
  return {.position = position + gain * innovation,
          .velocity = velocity + rate_gain * innovation,
          .position_covariance =
              symmetric(kept * position_covariance * kept.transpose() + gain * covariance * gain.transpose()),
          .cross_covariance = kept * moved + gain * covariance * rate_gain.transpose(),
          .velocity_covariance =
              symmetric(velocity_covariance - rate_gain * cross_covariance - (rate_gain * moved).transpose() +
                        rate_gain * covariance * rate_gain.transpose())};
}

}  // namespace fairway
