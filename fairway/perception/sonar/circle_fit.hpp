// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>

#include "fairway/core/echo.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// A circle in the plane of the hull and how well it is known.
struct Circle {
  Vec2 centre = Vec2::Zero();      ///< ahead and to starboard [m]
  double radius{};                 ///< [m]
  Mat3 covariance = Mat3::Zero();  ///< of centre and radius [m2], positive definite
};

/// Variances of the noise of one echo.
struct EchoNoise {
  double range;    ///< [m2]
  double bearing;  ///< [rad2]
};

/// The circle that fits what was thought before and the echoes from its near side best: the distances of
/// the echoes from it, weighed by how much of their noise runs along its normal there, Gauss-Newton. The
/// covariance is that of the linearised problem, so a short arc says little and tells so. At least one echo;
/// `sights` has the unit vector of the bearing of each. O(echoes).
Circle fitted(const Circle& prior, std::span<const Echo> echoes, std::span<const Vec2> sights,
              const EchoNoise& noise);

}  // namespace fairway
