// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/tracker/still_or_moving.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "fairway/core/math.hpp"

namespace fairway {
namespace {

constexpr double forgetting_hz = 0.02;      // by which what was observed loses its weight
constexpr double least_probability = 0.01;  // so that it may be believed again
constexpr double alike_s = 1.0;             // measurements err alike for so long
constexpr double most_evidence = 20.0;      // natural logarithm, of one measurement

/// Natural logarithm of the density of a measured place, but for a constant.
double log_density(const ConstantVelocity& foretold, const Vec3& measured, const Mat3& covariance) {
  const Mat3 spread = foretold.position_covariance + covariance;
  const Vec3 off = measured - foretold.position;
  return -0.5 * (off.dot(spread.inverse() * off) + math::log(spread.determinant()));
}

ConstantVelocity still_at(const Vec3& position, const Mat3& covariance, const StillOrMoving::Noise& noise) {
  return {.position = position,
          .position_covariance = covariance,
          .velocity_covariance = noise.wander * noise.wander * Mat3::Identity()};
}

}  // namespace

StillOrMoving::StillOrMoving(const Vec3& measured, const Mat3& covariance, double speed, const Noise& noise)
    : moving_{.position = measured,
              .position_covariance = covariance,
              .velocity_covariance = speed * speed * Mat3::Identity()},
      still_{still_at(measured, covariance, noise)},
      probability_{noise.still_ratio} {}

StillOrMoving StillOrMoving::predicted(double period, const Noise& noise) const {
  StillOrMoving later{*this};
  later.moving_ = moving_.predicted(period, noise.density);
  later.still_.position_covariance += noise.wander * noise.wander * period * Mat3::Identity();
  if (noise.still_ratio > 0.0)
    later.probability_ += std::min(forgetting_hz * period, 1.0) * (0.5 - probability_);
  return later;
}

void StillOrMoving::correct(const Vec3& measured, const Mat3& covariance, double period, const Noise& noise) {
  const double evidence =
      log_density(still_, measured, covariance) - log_density(moving_, measured, covariance);
  const double odds = math::exp(std::min(evidence * std::min(period / alike_s, 1.0), most_evidence));
  const double least = std::min(least_probability, noise.still_ratio);
  probability_ = std::max(probability_ * odds / (probability_ * odds + 1.0 - probability_), least);

  moving_ = moving_.corrected(measured, covariance);
  still_ = still_.corrected(measured, covariance);
  // what moves may stop where it is now
  if (probability_ <= least) still_ = still_at(moving_.position, moving_.position_covariance, noise);
}

ConstantVelocity StillOrMoving::believed() const { return probability_ < 0.5 ? moving_ : still_; }

}  // namespace fairway
