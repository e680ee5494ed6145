// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/safety_filter/hazards.hpp"

#include "fairway/avoidance/parting.hpp"

namespace fairway {
namespace {

/// A nearest point this near to an end of a wall is that end, whichever way the last bits fell [m].
constexpr double corner_size = 1e-9;

/// Fills a span with the hazards in range.
class Lookout {
 public:
  Lookout(const Ownship& own, double range, std::span<Hazard> found)
      : own_{own}, range_{range}, found_{found} {}

  void see(const Hazard& hazard) {
    if (count_ < found_.size() && hazard.gap(own_) <= range_) found_[count_++] = hazard;
  }

  void see(const Track& t) {
    see(Hazard{t.position, t.velocity, t.radius, false, t.reacts, parting_direction(own_.id, t.id)});
  }

  void see(const Obstacle& obstacle) {
    if (obstacle.kind == Obstacle::Kind::sphere) {
      see_fixed(obstacle.position, obstacle.radius, false);
    } else if (obstacle.kind == Obstacle::Kind::segment) {
      const Vec3 point = nearest_point(obstacle, own_.position).point;
      const auto is_at = [&](const Vec3& end) {
        return (point - end).squaredNorm() < corner_size * corner_size;
      };
      see_fixed(point, 0.0, !is_at(obstacle.from) && !is_at(obstacle.to));
    } else {
      see_polygon(obstacle);
    }
  }

  std::size_t count() const { return count_; }

 private:
  void see_fixed(const Vec3& centre, double radius, bool is_flat) {
    see(Hazard{centre, Vec3::Zero(), radius, is_flat, false, Vec3::UnitX()});
  }

  void see_polygon(const Obstacle& polygon) {
    const SurfacePoint nearest = nearest_point(polygon, own_.position);
    if (nearest.distance < 0.0) {
      see_fixed(2.0 * own_.position - nearest.point, -2.0 * nearest.distance, true);
      return;
    }
    const std::size_t corners = polygon.vertices.size();
    for (std::size_t i = 0, j = corners - 1; i < corners; j = i++) {
      Obstacle edge{.kind = Obstacle::Kind::segment, .from = polygon.vertices[j], .to = polygon.vertices[i]};
      edge.from.z() = edge.to.z() = own_.position.z();
      see(edge);
    }
  }

  const Ownship& own_;
  double range_;
  std::span<Hazard> found_;
  std::size_t count_ = 0;
};

}  // namespace

std::size_t hazards_near(const Situation& s, double range, std::span<Hazard> found) noexcept {
  Lookout lookout{s.own, range, found};
  for (const Obstacle& obstacle : s.obstacles) lookout.see(obstacle);
  for (const Track& track : s.tracks) lookout.see(track);
  return lookout.count();
}

}  // namespace fairway
