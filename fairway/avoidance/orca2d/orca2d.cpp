// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/orca2d/orca2d.hpp"

#include <algorithm>
#include <array>

#include "fairway/avoidance/orca2d/cone.hpp"
#include "fairway/avoidance/orca2d/shore.hpp"
#include "fairway/avoidance/parting.hpp"

namespace fairway {
namespace {

/// The half-planes of one decision, on the stack; those of what does not move come first.
class HalfPlanes {
 public:
  void add(const HalfPlane& h) { half_planes_[count_++] = h; }
  std::span<const HalfPlane> view() const { return {half_planes_.data(), count_}; }

 private:
  std::array<HalfPlane, orca2d::max_landmarks + 500> half_planes_;
  std::size_t count_ = 0;
};

Vec3 level(const Vec2& v) { return {v.x(), v.y(), 0.0}; }

/// What does not move leaves all of the change to us, and is not to be hit whatever the neighbours ask.
void add_shore(const Situation& s, const Orca2d::Params& params, HalfPlanes& half_planes) {
  const double tau = params.obstacle_time_horizon_s;
  const Vec2 position = s.own.position.head<2>();
  const orca2d::Mariner mariner{s.own.velocity.head<2>(), s.own.radius, tau, s.period,
                                parting_direction(s.own.id, TrackId{number(s.own.id)}).head<2>()};
  // a wall that cannot be reached within the horizon asks for nothing
  const double reach = tau * s.limits.max_speed + s.own.radius;
  const orca2d::Shore shore{s.obstacles,
                            {position, params.crit_dist_m, std::fmin(params.crit_dist_m, reach)}};

  for (const orca2d::Landmark& landmark : shore.landmarks()) {
    const Obstacle& obstacle = s.obstacles[landmark.obstacle];
    if (landmark.kind == orca2d::Landmark::Kind::disc) {
      const orca2d::Encounter encounter{obstacle.position.head<2>() - position, mariner.velocity,
                                        s.own.radius + obstacle.radius, mariner.parting};
      half_planes.add(half_plane(least_change(encounter, tau, s.period), mariner.velocity, 1.0));
      continue;
    }
    const orca2d::Wall wall = orca2d::wall_at(obstacle, landmark, position);
    if (landmark.kind == orca2d::Landmark::Kind::wall_from_inside) {
      half_planes.add(way_out(wall, mariner));
      continue;
    }
    const auto covers_it = [&](const HalfPlane& h) { return covers(h, wall, mariner); };
    if (std::ranges::any_of(half_planes.view(), covers_it)) continue;
    if (const auto allowed = half_plane(wall, mariner)) half_planes.add(*allowed);
  }
}

/// Vehicles share the work of avoiding each other; what does not react leaves all of it to us.
void add_tracks(const Situation& s, const Orca2d::Params& params, HalfPlanes& half_planes) {
  const Vec2 position = s.own.position.head<2>();
  const Vec2 v_opt = s.own.velocity.head<2>();
  const double radius = s.own.radius;
  const double tau = params.time_horizon_s;
  const double period = s.period;
  const double range2 = params.crit_dist_m * params.crit_dist_m;
  const double share = params.responsibility_ratio;
  int left = params.max_neighbours_count;
  for (const Track& track : s.tracks) {
    const Vec2 p = track.position.head<2>() - position;
    if (p.squaredNorm() > range2) continue;
    if (left-- == 0) break;
    const orca2d::Encounter encounter{p, v_opt - track.velocity.head<2>(), radius + track.radius,
                                      parting_direction(s.own.id, track.id).head<2>()};
    const orca2d::Change change = orca2d::least_change(encounter, tau, period);
    half_planes.add(half_plane(change, v_opt, track.reacts ? share : 1.0));
  }
}

}  // namespace

Command Orca2d::decide(const Situation& s, Memory&, Context& context) const noexcept {
  HalfPlanes half_planes;
  if (!s.obstacles.empty()) add_shore(s, params, half_planes);
  const std::size_t hard_count = half_planes.view().size();
  add_tracks(s, params, half_planes);

  const Vec2 preferred = s.preferred_velocity().head<2>();
  if (half_planes.view().empty()) return {.velocity = level(preferred), .mode = Mode::cruise};

  const PlaneChoice choice =
      nearest_in_plane({half_planes.view(), hard_count, s.limits.max_speed}, preferred);

  if (context.sketch) {
    for (std::size_t i = 0; i < half_planes.view().size(); ++i) {
      const HalfPlane& h = half_planes.view()[i];
      context.sketch->half_space(level(h.offset * h.normal), level(h.normal),
                                 i < hard_count ? "allowed by an obstacle" : "allowed by a neighbour");
    }
    context.sketch->velocity(level(preferred), "preferred");
    context.sketch->velocity(level(choice.point), "chosen");
  }
  return {.velocity = level(choice.point),
          .mode = choice.is_feasible() ? Mode::avoid : Mode::infeasible,
          .astern = true};
}

}  // namespace fairway
