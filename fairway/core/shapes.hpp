// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "fairway/core/params.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// Something solid that does not move. Only the members of its kind mean anything.
struct Obstacle {
  enum class Kind {
    sphere,   ///< `position`, `radius`
    segment,  ///< a thin wall from `from` to `to`
    polygon,  ///< solid vertical prism through every depth; vertices counter-clockwise, n as x and e as y
  };
  Kind kind{};
  Vec3 position = Vec3::Zero();    ///< [m, NED]
  double radius{};                 ///< [m]
  Vec3 from = Vec3::Zero();        ///< [m, NED]
  Vec3 to = Vec3::Zero();          ///< [m, NED]
  std::span<const Vec3> vertices;  ///< [m, NED]; at least three
  bool charted{true};              ///< known before the mission; else met on the way
};

template <>
struct EnumNames<Obstacle::Kind> {
  static constexpr std::array names{"sphere", "segment", "polygon"};
};

/// Whether the members of its kind are finite and make a solid. O(1), or O(vertices) for a polygon.
bool has_shape(const Obstacle& obstacle) noexcept;

/// A solid that may drift at a constant velocity; only spheres do.
struct DriftingObstacle {
  Obstacle start;                ///< where it is at time 0
  Vec3 velocity = Vec3::Zero();  ///< [m/s, NED]

  Obstacle at(double time) const noexcept {
    Obstacle now = start;
    now.position += time * velocity;
    return now;
  }
};

/// The surface point of an obstacle nearest to `p`, and how far away it is.
struct SurfacePoint {
  Vec3 point = Vec3::Zero();  ///< [m, NED]
  double distance{};          ///< [m], negative inside a solid
};

/// O(1), or O(vertices) for a polygon. At the exact centre of a sphere the point lies due north.
SurfacePoint nearest_point(const Obstacle& obstacle, const Vec3& p) noexcept;

/// Where the obstacle is, as one point: the centre of a sphere, the middle of a segment, the mean of a
/// polygon's vertices (at the depth of their mean). [m, NED]
Vec3 centre_of(const Obstacle& obstacle) noexcept;

}  // namespace fairway
