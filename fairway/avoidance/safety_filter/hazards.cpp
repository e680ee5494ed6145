// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/safety_filter/hazards.hpp"

#include "fairway/avoidance/nearest_few.hpp"
#include "fairway/avoidance/parting.hpp"

namespace fairway {
namespace {

/// A nearest point this near to an end of a wall is that end, whichever way the last bits fell [m].
constexpr double corner_size = 1e-9;

constexpr std::size_t sure_tracks = max_hazards - max_hazards / 4;

/// Finds the hazards in range, and places for them.
class Lookout {
 public:
  Lookout(const Ownship& own, double range, Hazards& found) : own_{own}, range_{range}, found_{found} {}

  void see(const Hazard& hazard) {
    const double gap = hazard.gap(own_);
    if (!(gap <= range_)) return;
    const std::size_t place = places_.place_for(gap);
    if (place < max_hazards) found_.all[place] = hazard;
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

  void see(std::span<const Track> tracks) {
    for (const Track& track : tracks) see(track);
  }
  void see(std::span<const Obstacle> obstacles) {
    for (const Obstacle& obstacle : obstacles) see(obstacle);
  }

  /// Of those seen so far some are sure of their place, whatever comes nearer.
  void keep(std::size_t most) { places_.keep(most); }

  void end() {
    found_.count = places_.count();
    found_.left_out = places_.left_out();
  }

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
  Hazards& found_;
  NearestFew<max_hazards> places_;
};

}  // namespace

void find_hazards_near(const Situation& s, double range, Hazards& found) noexcept {
  Lookout lookout{s.own, range, found};
  lookout.see(s.obstacles);
  lookout.see(s.tracks);
  lookout.end();
  if (!found.left_out) return;

  // once more: no number of stones hides a vessel
  Lookout careful{s.own, range, found};
  careful.see(s.tracks);
  careful.keep(sure_tracks);
  careful.see(s.obstacles);
  careful.end();
  found.left_out = true;
}

}  // namespace fairway
