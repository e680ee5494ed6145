// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/symmetry.hpp"

#include <algorithm>

#include "fairway/core/angles.hpp"

namespace fairway {
namespace {

constexpr double lean = 10.0 * pi / 180.0;
constexpr double least_lean = 5.0 * pi / 180.0;  // of those that are drawn, up to `lean` and as much more
constexpr double middle_share = 0.25;            // of the radii: to pass by less is to go for the middle

/// Whether `velocity`, relative to it, leads to the middle of what is at `place` from own ship.
bool leads_to_middle(const Vec3& place, const Vec3& velocity, double radii) {
  const Vec2 p = place.head<2>(), v = velocity.head<2>();
  return p.dot(v) > 0.0 && std::abs(cross(p, v)) < middle_share * radii * v.norm();
}

/// Whose rule it is to lean, seen by own ship.
bool leans(Symmetry symmetry, const Situation& s, const Track& track) {
  return symmetry != Symmetry::by_id || !track.reacts || number(s.own.id) > number(track.id);
}

bool is_symmetric(const Situation& s, Symmetry symmetry, const Vec3& preferred, double range) {
  const auto track_is_met = [&](const Track& track) {
    const Vec3 place = track.position - s.own.position;
    return place.norm() <= range && leans(symmetry, s, track) &&
           leads_to_middle(place, preferred - track.velocity, s.own.radius + track.radius);
  };
  const auto obstacle_is_met = [&](const Obstacle& obstacle) {
    const SurfacePoint nearest = nearest_point(obstacle, s.own.position);
    if (nearest.distance > range) return false;
    if (obstacle.kind == Obstacle::Kind::sphere)
      return leads_to_middle(obstacle.position - s.own.position, preferred, s.own.radius + obstacle.radius);
    return leads_to_middle(nearest.point - s.own.position, preferred, s.own.radius);
  };
  return std::ranges::any_of(s.tracks, track_is_met) || std::ranges::any_of(s.obstacles, obstacle_is_met);
}

/// To starboard if positive [rad].
double angle_of(Symmetry symmetry, const Context& context) {
  if (symmetry != Symmetry::drawn) return lean;
  Rng own = context.rng;  // a copy: the next decision draws the same
  const double side = own.index(2) == 0 ? 1.0 : -1.0;
  return side * own.uniform(least_lean, 2.0 * lean - least_lean);
}

}  // namespace

Vec3 preferred_velocity(const Situation& s, Symmetry symmetry, const Context& context,
                        double range) noexcept {
  Vec3 v = s.preferred_velocity();
  if (symmetry == Symmetry::none || !is_symmetric(s, symmetry, v, range)) return v;
  const double angle = angle_of(symmetry, context);
  v.head<2>() = turned(v.head<2>(), angle);
  return v;
}

}  // namespace fairway
