// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/core/state.hpp"

namespace fairway {

/// The part of the water that a forward-looking sensor looks into.
struct Fan {
  Vec3 origin = Vec3::Zero();                                ///< [m, NED]
  Eigen::Quaterniond q_nb = Eigen::Quaterniond::Identity();  ///< body to NED, unit
  double half_field{};                                       ///< to port and to starboard of ahead [rad]
  double half_aperture{};                                    ///< above and below the plane of the hull [rad]
  double min_range{};                                        ///< [m]
  double max_range{};                                        ///< [m]

  /// Whether a ball round the point `p` [m, NED] is to be seen in it: its middle lies within, and its near
  /// side is not too near.
  bool covers(const Vec3& p, double radius = 0.0) const {
    const Vec3 r_b = q_nb.conjugate() * (p - origin);
    const double range = r_b.norm();
    return range - radius >= min_range && range <= max_range &&
           std::abs(math::atan2(r_b.y(), r_b.x())) <= half_field &&
           std::abs(math::atan2(r_b.z(), horizontal_norm(r_b))) <= half_aperture;
  }
};

}  // namespace fairway
