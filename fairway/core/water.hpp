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

  /// Straight down through the surface [NED, unit].
  Vec3 surface_normal() const { return Vec3{slope_n.x(), slope_n.y(), 1.0}.normalized(); }
};

}  // namespace fairway
