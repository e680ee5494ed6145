// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/planar_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "fairway/core/error.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/segments.hpp"

namespace fairway {
namespace {

Vec3 at_depth_zero(const Vec3& p) { return {p.x(), p.y(), 0.0}; }

Vec3 at_depth_zero(const Vec2& p) { return {p.x(), p.y(), 0.0}; }

}  // namespace

PlanarMap::FlatObstacle PlanarMap::flattened(const Obstacle& obstacle) {
  FlatObstacle solid{.kind = obstacle.kind,
                     .position = at_depth_zero(obstacle.position),
                     .radius = obstacle.radius,
                     .from = at_depth_zero(obstacle.from),
                     .to = at_depth_zero(obstacle.to)};
  for (const Vec3& vertex : obstacle.vertices) solid.vertices.push_back(at_depth_zero(vertex));
  return solid;
}

SurfacePoint PlanarMap::FlatObstacle::nearest(const Vec2& p) const noexcept {
  return nearest_point(
      {.kind = kind, .position = position, .radius = radius, .from = from, .to = to, .vertices = vertices},
      at_depth_zero(p));
}

double PlanarMap::FlatObstacle::distance(const Vec2& a, const Vec2& b) const noexcept {
  switch (kind) {
    case Obstacle::Kind::sphere:
      return math::fmax(0.0, distance_to_segment<Vec2>(a, b, position.head<2>()) - radius);
    case Obstacle::Kind::segment:
      return distance_between(a, b, Vec2{from.head<2>()}, Vec2{to.head<2>()});
    case Obstacle::Kind::polygon:
      break;
  }
  if (nearest(a).distance <= 0.0) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = vertices.size() - 1; i < vertices.size(); j = i++) {
    least =
        math::fmin(least, distance_between(a, b, Vec2{vertices[j].head<2>()}, Vec2{vertices[i].head<2>()}));
  }
  return least;
}

Eigen::AlignedBox2d PlanarMap::FlatObstacle::bounds() const {
  Eigen::AlignedBox2d box;
  switch (kind) {
    case Obstacle::Kind::sphere:
      box.extend(Vec2{position.head<2>().array() - radius});
      box.extend(Vec2{position.head<2>().array() + radius});
      break;
    case Obstacle::Kind::segment:
      box.extend(Vec2{from.head<2>()});
      box.extend(Vec2{to.head<2>()});
      break;
    case Obstacle::Kind::polygon:
      for (const Vec3& vertex : vertices) box.extend(Vec2{vertex.head<2>()});
      break;
  }
  return box;
}

PlanarMap::PlanarMap(std::span<const Obstacle> obstacles, double inflation_m) : inflation_{inflation_m} {
  if (!(inflation_m >= 0.0 && std::isfinite(inflation_m))) {
    throw InputError("the inflation of a map must be 0 m or more, not " + std::to_string(inflation_m));
  }
  for (const Obstacle& obstacle : obstacles) {
    if (!has_shape(obstacle)) {
      throw InputError("obstacles[" + std::to_string(solids_.size()) + "] of a map has no usable shape");
    }
    solids_.push_back(flattened(obstacle));
    const Eigen::AlignedBox2d box = solids_.back().bounds();
    bounds_.extend(Vec2{box.min().array() - inflation_});
    bounds_.extend(Vec2{box.max().array() + inflation_});
  }
}

double PlanarMap::clearance(const Vec2& p) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (const FlatObstacle& solid : solids_) least = math::fmin(least, solid.nearest(p).distance);
  return least - inflation_;
}

double PlanarMap::clearance(const Vec2& a, const Vec2& b) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (const FlatObstacle& solid : solids_) least = math::fmin(least, solid.distance(a, b));
  return least - inflation_;
}

Vec2 PlanarMap::outward(const Vec2& p) const noexcept {
  SurfacePoint nearest{.distance = std::numeric_limits<double>::infinity()};
  for (const FlatObstacle& solid : solids_) {
    const SurfacePoint candidate = solid.nearest(p);
    if (candidate.distance < nearest.distance) nearest = candidate;
  }
  const Vec2 away = p - seen_from_above(nearest.point);
  if (!std::isfinite(nearest.distance) || nearest.distance == 0.0) return Vec2::UnitX();
  return away / nearest.distance;  // towards the surface from inside, where the distance is negative
}

double length_of(std::span<const Vec2> points) noexcept {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

PlanarMap PlanarMap::grown(double more_m) const {
  PlanarMap map = *this;
  map.inflation_ += more_m;
  if (!bounds_.isEmpty()) {
    map.bounds_.min().array() -= more_m;
    map.bounds_.max().array() += more_m;
  }
  return map;
}

}  // namespace fairway
