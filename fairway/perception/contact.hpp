// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/vec.hpp"

namespace fairway {

/// One solid thing as a sensor made it out at one instant.
struct Contact {
  Vec3 position = Vec3::Zero();    ///< of its centre [m, NED]
  Mat3 covariance = Mat3::Zero();  ///< of the whole error of `position` [m2, NED]
  Mat3 lasting = Mat3::Zero();     ///< the part of it that stays alike, so that no average takes it away
  double radius{};                 ///< of the sphere taken for it [m]
  double radius_sigma{};           ///< standard deviation of `radius` [m]
};

}  // namespace fairway
