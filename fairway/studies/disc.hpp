// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// A sphere at `at` [m, NED], which in the plane is a disc; it drifts if it has a velocity [m/s].
inline ObstacleSpec disc(const Vec3& at, double radius, const Vec3& velocity = Vec3::Zero()) {
  return {
      .kind = Obstacle::Kind::sphere, .velocity = velocity, .position = at, .radius = radius, .vertices = {}};
}

}  // namespace fairway
