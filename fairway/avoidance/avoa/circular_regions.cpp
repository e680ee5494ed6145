// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/circular_regions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fairway/avoidance/parting.hpp"
#include "fairway/core/math.hpp"

namespace fairway::avoa {
namespace {

/// The most circles that stand for one edge.
constexpr double most_circles = 256.0;

/// Adds what there is, in the axes of own ship.
class RegionWriter {
 public:
  RegionWriter(const Situation& situation, const Regions& regions, ProtectiveZones& zones)
      : own_{situation.own},
        regions_{regions},
        zones_{zones},
        cosine_{math::cos(own_.yaw)},
        sine_{math::sin(own_.yaw)},
        band_{own_.radius + regions.margin},
        range_{regions.window_at_rest * std::numbers::sqrt2 * zones.grid().reach() + band_} {}

  void add(const Track& track) {
    zones_.add({.position = from_own(track.position),
                .radius = band_ + track.radius,
                .velocity = in_own_axes(track.velocity),
                .inward = -in_own_axes(parting_direction(own_.id, track.id))},
               regions_.window, regions_.contact);
  }

  void add(const Obstacle& obstacle) {
    switch (obstacle.kind) {
      case Obstacle::Kind::sphere:
        put({.position = from_own(obstacle.position),
             .radius = band_ + obstacle.radius,
             .inward = in_own_axes(-Vec3::UnitX())});
        break;
      case Obstacle::Kind::segment:
        add_edge(from_own(obstacle.from), from_own(obstacle.to));
        break;
      case Obstacle::Kind::polygon:
        add_polygon(obstacle);
        break;
    }
  }

 private:
  Vec2 in_own_axes(const Vec3& v) const {
    return {cosine_ * v.x() + sine_ * v.y(), cosine_ * v.y() - sine_ * v.x()};
  }
  Vec2 from_own(const Vec3& p) const { return in_own_axes(p - own_.position); }

  void put(const MovingDisc& disc) { zones_.add(disc, regions_.window_at_rest, regions_.contact); }

  void add_polygon(const Obstacle& polygon) {
    const SurfacePoint surface = nearest_point(polygon, own_.position);
    if (surface.distance < 0.0) {
      put({.position = -from_own(surface.point), .radius = -surface.distance + band_});
      return;
    }
    const std::span<const Vec3> vertices = polygon.vertices;
    for (std::size_t i = 0, j = vertices.size() - 1; i < vertices.size(); j = i++) {
      add_edge(from_own(vertices[j]), from_own(vertices[i]));
    }
  }

  /// Discs from `a` to `b` that cover the band between and round them, as far as it is in range.
  void add_edge(const Vec2& a, const Vec2& b) {
    Vec2 edge = b - a;
    constexpr double longest = 1e100;  // [m]: squares of more overflow
    if (const double whole = edge.stableNorm(); whole > longest) edge *= longest / whole;
    const double squared_length = edge.squaredNorm();
    const double middle = squared_length > 0.0 ? -a.dot(edge) / squared_length : 0.0;
    const double squared_half = range_ * range_ - (a + middle * edge).squaredNorm();
    if (squared_half < 0.0) return;

    const double length = std::sqrt(squared_length);
    const double half = length > 0.0 ? std::sqrt(squared_half) / length : 0.0;
    const double from = std::clamp(middle - half, 0.0, 1.0);
    const double to = std::clamp(middle + half, 0.0, 1.0);
    const double pieces = std::min(std::ceil((to - from) * length / regions_.spacing), most_circles);
    if (pieces < 1.0) {
      put({.position = a + from * edge, .radius = band_});
      return;
    }

    const double step = (to - from) / pieces;
    const double radius = math::hypot(band_, 0.5 * step * length);
    for (int i = 0; i <= static_cast<int>(pieces); ++i) {
      put({.position = a + (from + i * step) * edge, .radius = radius});
    }
  }

  const Ownship& own_;
  const Regions& regions_;
  ProtectiveZones& zones_;
  double cosine_;
  double sine_;
  double band_;   // half its width: own radius and margin [m]
  double range_;  // of what can matter [m]
};

}  // namespace

void add_everyone(const Situation& situation, const Regions& regions, ProtectiveZones& zones) {
  RegionWriter writer{situation, regions, zones};
  for (const Track& track : situation.tracks) writer.add(track);
  for (const Obstacle& obstacle : situation.obstacles) writer.add(obstacle);
}

}  // namespace fairway::avoa
