// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/perception/tracker/constant_velocity.hpp"

namespace fairway {

/// What is believed of something that either stands still or keeps its velocity: both at once, and how likely
/// the first is, by how well each foretold the places measured (static multiple models: Bar-Shalom, Li,
/// Kirubarajan 2001, section 11.6.2). A buoy that is out of sight stays where it was, where a filter of
/// velocities has it drift away by the error of its velocity.
class StillOrMoving {
 public:
  struct Noise {
    double density{};      ///< of the acceleration of what moves [m2/s3]
    double wander{};       ///< of the place of what stands still in 1 s, standard deviation [m]
    double still_ratio{};  ///< of what is seen stands still, before it is observed
  };

  /// Measured once, with the positive definite `covariance`; `speed` is the standard deviation of each
  /// component of its velocity if it moves [m/s].
  StillOrMoving(const Vec3& measured, const Mat3& covariance, double speed, const Noise& noise);

  /// After `period` [s].
  StillOrMoving predicted(double period, const Noise& noise) const;

  /// With a measured position. Errors of the measurements of a second are alike: they count as one for
  /// whether it stands still, the last of which was `period` before [s].
  void correct(const Vec3& measured, const Mat3& covariance, double period, const Noise& noise);

  /// Where it is and how it moves, as the likelier of the two has it; a velocity of exactly zero where that
  /// is to stand still.
  ConstantVelocity believed() const;

 private:
  ConstantVelocity moving_;
  ConstantVelocity still_;  // of velocity zero
  double probability_{};    // that it stands still
};

}  // namespace fairway
