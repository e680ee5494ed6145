// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/core/segments.hpp"

namespace fairway {
namespace {

SurfacePoint nearest_on_sphere(const Obstacle& sphere, const Vec3& p) {
  const Vec3 out = p - sphere.position;
  const double distance = out.norm();
  const Vec3 direction = distance > 0.0 ? Vec3{out / distance} : Vec3::UnitX();
  return {sphere.position + sphere.radius * direction, distance - sphere.radius};
}

SurfacePoint nearest_on_prism(std::span<const Vec3> vertices, const Vec3& p) {
  SurfacePoint best{.distance = std::numeric_limits<double>::infinity()};
  bool inside = false;
  for (std::size_t i = 0, j = vertices.size() - 1; i < vertices.size(); j = i++) {
    Vec3 a = vertices[j];
    Vec3 b = vertices[i];
    a.z() = b.z() = p.z();

    const Vec3 q = nearest_on_segment(a, b, p);
    const double distance = (p - q).norm();
    if (distance < best.distance) best = {q, distance};

    // even-odd rule: does a ray due north from p cross this edge?
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      inside = !inside;
    }
  }
  if (inside) best.distance = -best.distance;
  return best;
}

}  // namespace

bool has_shape(const Obstacle& obstacle) noexcept {
  switch (obstacle.kind) {
    case Obstacle::Kind::sphere:
      return is_finite(obstacle.position) && obstacle.radius >= 0.0 && std::isfinite(obstacle.radius);
    case Obstacle::Kind::segment:
      return is_finite(obstacle.from) && is_finite(obstacle.to);
    case Obstacle::Kind::polygon:
      return obstacle.vertices.size() >= 3 &&
             std::ranges::all_of(obstacle.vertices, [](const Vec3& v) { return is_finite(v); });
  }
  return false;
}

SurfacePoint nearest_point(const Obstacle& obstacle, const Vec3& p) noexcept {
  switch (obstacle.kind) {
    case Obstacle::Kind::sphere:
      return nearest_on_sphere(obstacle, p);
    case Obstacle::Kind::segment: {
      const Vec3 q = nearest_on_segment(obstacle.from, obstacle.to, p);
      return {q, (p - q).norm()};
    }
    case Obstacle::Kind::polygon:
      if (!obstacle.vertices.empty()) return nearest_on_prism(obstacle.vertices, p);
      break;
  }
  return {p, std::numeric_limits<double>::infinity()};
}

Vec3 centre_of(const Obstacle& obstacle) noexcept {
  if (obstacle.kind == Obstacle::Kind::segment) return 0.5 * (obstacle.from + obstacle.to);
  if (obstacle.kind == Obstacle::Kind::sphere || obstacle.vertices.empty()) return obstacle.position;
  Vec3 sum = Vec3::Zero();
  for (const Vec3& vertex : obstacle.vertices) sum += vertex;
  return sum / static_cast<double>(obstacle.vertices.size());
}

}  // namespace fairway
