// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "fairway/avoidance/velocity_obstacle/velocity_obstacle.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/segments.hpp"

/// What a velocity obstacle is by its definitions, without its geometry.
namespace fairway::velocity_obstacle {

/// The least distance between a disc's centre or a wall and a point that goes from the origin at `w` for
/// `horizon` [m]: between two segments, which is 0 or at one of four ends.
inline double closest_approach(const RelativeCapsule& solid, const Vec2& w, double horizon) {
  const Vec2 origin = Vec2::Zero();
  const Vec2 end = horizon * w;
  const auto parts = [](const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q) {
    return cross(b - a, p - a) * cross(b - a, q - a) < 0.0;
  };
  if (parts(origin, end, solid.from, solid.to) && parts(solid.from, solid.to, origin, end)) return 0.0;
  const auto apart = [](const Vec2& p, const Vec2& a, const Vec2& b) {
    return distance_to_segment<Vec2>(a, b, p);
  };
  return std::min({apart(origin, solid.from, solid.to), apart(end, solid.from, solid.to),
                   apart(solid.from, origin, end), apart(solid.to, origin, end)});
}

/// cao2022 after eq. 6, as printed but with atan2 for arctan: the relative velocity's angle theta lies in
/// (theta_uo - theta_o, theta_uo + theta_o). No horizon; d > R.
inline bool is_within_printed_angles(const Vec2& p, double radius, const Vec2& relative_velocity) {
  const double theta_uo = std::atan2(p.y(), p.x());
  const double theta_o = std::asin(radius / p.norm());
  const double theta = std::atan2(relative_velocity.y(), relative_velocity.x());
  return std::fabs(wrap_angle(theta - theta_uo)) < theta_o;
}

}  // namespace fairway::velocity_obstacle
