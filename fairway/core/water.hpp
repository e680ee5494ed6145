// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/vec.hpp"

namespace fairway {

/// The water around one vehicle at one instant: the same for all of a hull that is short against the waves.
struct Water {
  Vec3 current_n = Vec3::Zero();  ///< how it moves, waves included [m/s, NED], taken as irrotational
  double density{1000.0};         ///< [kg/m3]

  Vec3 current_rate_n = Vec3::Zero();  ///< acceleration of the water that is there [m/s2, NED]
  double elevation{};                  ///< of the surface over the calm one, above the vehicle [m, up]
  Vec2 slope_n = Vec2::Zero();         ///< of the surface there: d(elevation)/d(north), d(east)
};

}  // namespace fairway
