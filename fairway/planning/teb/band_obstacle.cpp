// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/teb/band_obstacle.hpp"

#include "fairway/planning/planar_map.hpp"

namespace fairway::teb {
namespace {

constexpr double stands_still = 1e-3;  ///< slower than this nothing is said to move [m/s]

Obstacle flattened(Obstacle o) {
  o.position.z() = o.from.z() = o.to.z() = 0.0;
  return o;
}

}  // namespace

BandObstacle::BandObstacle(const Obstacle& obstacle, double own_radius)
    : shape_{flattened(obstacle)}, centre_{seen_from_above(centre_of(obstacle))}, grown_{own_radius} {
  if (shape_.kind == Obstacle::Kind::sphere) grown_ += shape_.radius;
}

BandObstacle::BandObstacle(const Track& track, double own_radius, bool moves)
    : BandObstacle{
          Obstacle{.kind = Obstacle::Kind::sphere, .position = track.position, .radius = track.radius},
          own_radius} {
  velocity_ = moves ? seen_from_above(track.velocity) : Vec2{Vec2::Zero()};
  moves_ = velocity_.norm() > stands_still;
}

Separation BandObstacle::from(const Vec2& p, double time) const noexcept {
  if (shape_.kind == Obstacle::Kind::sphere) {
    const Vec2 out = p - centre(time);
    const double range = out.norm();
    return {range - grown_, range > 0.0 ? Vec2{out / range} : Vec2{Vec2::Zero()}};
  }
  const SurfacePoint nearest = nearest_point(shape_, {p.x(), p.y(), 0.0});
  const Vec2 out = p - seen_from_above(nearest.point);
  const double range = nearest.distance;  // negative inside, where the way to the surface leads out
  return {range - grown_, range != 0.0 ? Vec2{out / range} : Vec2{Vec2::Zero()}};
}

std::vector<BandObstacle> band_obstacles_near(const TebParams& params, const Situation& s) {
  const Vec2 own = seen_from_above(s.own.position);
  const double reach = params.max_global_plan_lookahead_dist_m +
                       params.obstacle_association_cutoff_factor_ratio * params.min_obstacle_dist_m;
  const double lasts = 2.0 * params.max_global_plan_lookahead_dist_m / params.max_vel_x_mps;

  std::vector<BandObstacle> near;
  for (const Track& track : s.tracks) {
    const BandObstacle barrier{track, s.own.radius, params.include_dynamic_obstacles};
    if (barrier.from(own).distance < reach + lasts * barrier.velocity().norm()) near.push_back(barrier);
  }
  for (const Obstacle& obstacle : s.obstacles) {
    const BandObstacle barrier{obstacle, s.own.radius};
    if (barrier.from(own).distance < reach) near.push_back(barrier);
  }
  return near;
}

}  // namespace fairway::teb
