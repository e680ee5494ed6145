// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/neighbourhood.hpp"

#include <algorithm>

#include "fairway/avoidance/label.hpp"
#include "fairway/avoidance/lanes/kernel.hpp"
#include "fairway/avoidance/parting.hpp"
#include "fairway/core/segments.hpp"

namespace fairway::velocity_obstacle {
namespace {

Vec2 from_own(const Vec3& position, const Situation& s) { return (position - s.own.position).head<2>(); }

TrackId own_id(const Situation& s) { return TrackId{number(s.own.id)}; }

/// From its very middle it is left as `id` would be.
RelativeCapsule disc(const Vec2& p, double radius, TrackId id, const Situation& s) {
  return {.from = p, .to = p, .radius = radius, .parting = parting_direction(s.own.id, id).head<2>()};
}

/// Who is exactly on it leaves it to starboard of the way from `from` to `to`.
RelativeCapsule wall(const Vec2& from, const Vec2& to, const Situation& s) {
  RelativeCapsule solid = disc(from, s.own.radius, own_id(s), s);
  const double length = (to - from).norm();
  if (length > 0.0) solid.parting = starboard_of(to - from) / length;
  solid.to = to;
  return solid;
}

void put(const Track& track, bool shares, const Situation& s, Discs& discs) {
  const std::size_t at = discs.count++;
  const Vec2 p = from_own(track.position, s);
  discs.north[at] = p.x();
  discs.east[at] = p.y();
  discs.radius[at] = s.own.radius + track.radius;
  discs.velocity_north[at] = track.velocity.x();
  discs.velocity_east[at] = track.velocity.y();
  discs.shares[at] = shares && track.reacts ? 1.0 : 0.0;
}

}  // namespace

Neighbourhood::Neighbourhood(const Situation& s, const Params& params,
                             Responsibility responsibility) noexcept {
  add_tracks(s, params, responsibility);
  for (const Obstacle& obstacle : s.obstacles) add_obstacle(obstacle, s, params);
}

void Neighbourhood::add_tracks(const Situation& s, const Params& params,
                               Responsibility responsibility) noexcept {
  const lanes::Kernel& kernel = lanes::kernel_for(lanes::most_lanes);
  Discs discs;
  discs.own_north = s.own.velocity.x();
  discs.own_east = s.own.velocity.y();
  discs.inverse_horizon = 1.0 / params.time_horizon_s;
  discs.inverse_interval = 1.0 / params.planning_interval_s;
  discs.by_side = responsibility == Responsibility::by_side;

  const double range = params.crit_dist_m;
  for (const Track& track : s.tracks) {
    if (discs.count == static_cast<std::size_t>(params.max_neighbours_count)) break;
    if (from_own(track.position, s).squaredNorm() > range * range) continue;
    ids_[discs.count] = track.id;
    put(track, responsibility != Responsibility::all, s, discs);
  }
  kernel.cones(discs);
  for (; track_count_ < discs.count; ++track_count_) {
    const std::size_t at = places_.place_for(0.0);
    obstacles_[at] = VelocityObstacle(discs, at, parting_direction(s.own.id, ids_[at]).head<2>());
  }
  places_.keep();
}

void Neighbourhood::add_obstacle(const Obstacle& obstacle, const Situation& s,
                                 const Params& params) noexcept {
  switch (obstacle.kind) {
    case Obstacle::Kind::sphere:
      add_solid(disc(from_own(obstacle.position, s), s.own.radius + obstacle.radius, own_id(s), s), params);
      break;
    case Obstacle::Kind::segment:
      add_solid(wall(from_own(obstacle.from, s), from_own(obstacle.to, s), s), params);
      break;
    case Obstacle::Kind::polygon:
      add_polygon(obstacle, s, params);
      break;
  }
}

void Neighbourhood::add_polygon(const Obstacle& polygon, const Situation& s, const Params& params) noexcept {
  // from inside, all that counts is the way out
  const SurfacePoint surface = nearest_point(polygon, s.own.position);
  if (surface.distance < 0.0) {
    RelativeCapsule side = disc(from_own(surface.point, s), s.own.radius, own_id(s), s);
    side.within = true;
    add_solid(side, params);
    return;
  }

  // from outside it is its sides; counter-clockwise, so outside is to starboard of the way back
  for (std::size_t i = 0, j = polygon.vertices.size() - 1; i < polygon.vertices.size(); j = i++) {
    add_solid(wall(from_own(polygon.vertices[i], s), from_own(polygon.vertices[j], s), s), params);
  }
}

void Neighbourhood::add_solid(const RelativeCapsule& solid, const Params& params) noexcept {
  const double range = params.crit_dist_m + solid.radius;
  const Vec2 nearest = nearest_on_segment<Vec2>(solid.from, solid.to, Vec2::Zero());
  const double distance = nearest.norm();
  if (distance > range) return;
  const std::size_t at = places_.place_for(distance - solid.radius);
  if (at == max_obstacles) return;
  obstacles_[at] = VelocityObstacle(solid, {params.obstacle_time_horizon_s, params.planning_interval_s});
}

void Neighbourhood::draw(double reach, Sketch& sketch) const {
  for (std::size_t i = 0; i < places_.count(); ++i) {
    const Outline outline = obstacles_[i].outline(reach);
    std::array<Vec3, Outline::max_points> points;
    const auto level = [](const Vec2& v) { return Vec3{v.x(), v.y(), 0.0}; };
    std::ranges::transform(outline.view(), points.begin(), level);
    const std::span<const Vec3> region{points.data(), outline.view().size()};
    if (i < track_count_) {
      sketch.region(region, Label{"velocity obstacle of", ids_[i]});
    } else {
      sketch.region(region, "velocity obstacle of an obstacle");
    }
  }
}

}  // namespace fairway::velocity_obstacle
