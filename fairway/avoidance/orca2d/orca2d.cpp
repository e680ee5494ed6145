// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/orca2d/orca2d.hpp"

#include <algorithm>
#include <array>

#include "fairway/avoidance/label.hpp"
#include "fairway/avoidance/orca2d/cone.hpp"
#include "fairway/avoidance/orca2d/shore.hpp"
#include "fairway/avoidance/parting.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

constexpr int max_neighbours = 500;

Vec3 horizontal(const Vec2& v) { return {v.x(), v.y(), 0.0}; }

/// The half-planes of one decision, on the stack; those of what does not move come first.
class AllowedVelocities {
 public:
  void add(const HalfPlane& h) { half_planes_[count_++] = h; }
  void add(const HalfPlane& h, TrackId whose) {
    ids_[track_count_++] = whose;
    add(h);
  }
  std::span<const HalfPlane> view() const { return {half_planes_.data(), count_}; }

  void draw(Sketch& sketch) const {
    const std::size_t hard_count = count_ - track_count_;
    for (std::size_t i = 0; i < count_; ++i) {
      const HalfPlane& h = half_planes_[i];
      const Vec3 point = horizontal(h.offset * h.normal);
      if (i < hard_count) {
        sketch.half_space(point, horizontal(h.normal), "allowed by an obstacle");
      } else {
        sketch.half_space(point, horizontal(h.normal), Label{"allowed by", ids_[i - hard_count]});
      }
    }
  }

 private:
  std::array<HalfPlane, orca2d::max_landmarks + max_neighbours> half_planes_;
  std::array<TrackId, max_neighbours> ids_;  // of the tracks
  std::size_t count_ = 0;
  std::size_t track_count_ = 0;
};

/// What does not move leaves all of the change to us, and is not to be hit whatever the neighbours ask.
void add_shore(const Situation& s, const Orca2d::Params& params, AllowedVelocities& allowed) {
  const double tau = params.obstacle_time_horizon_s;
  const Vec2 position = s.own.position.head<2>();
  const orca2d::Mariner mariner{s.own.velocity.head<2>(), s.own.radius, tau, params.interval(s),
                                parting_direction(s.own.id, TrackId{number(s.own.id)}).head<2>()};
  // a wall that cannot be reached within the horizon asks for nothing
  const double reach = tau * s.limits.max_speed + s.own.radius;
  const orca2d::Shore shore{s.obstacles,
                            {position, params.crit_dist_m, math::fmin(params.crit_dist_m, reach)}};

  for (const orca2d::Landmark& landmark : shore.landmarks()) {
    const Obstacle& obstacle = s.obstacles[landmark.obstacle];
    if (landmark.kind == orca2d::Landmark::Kind::disc) {
      const orca2d::RelativeNeighbour encounter{obstacle.position.head<2>() - position, mariner.velocity,
                                                s.own.radius + obstacle.radius, mariner.parting};
      allowed.add(half_plane(least_change(encounter, tau, params.interval(s)), mariner.velocity, 1.0));
      continue;
    }
    const orca2d::Wall wall = orca2d::wall_at(obstacle, landmark, position);
    if (landmark.kind == orca2d::Landmark::Kind::wall_from_inside) {
      allowed.add(way_out(wall, mariner));
      continue;
    }
    const auto covers_it = [&](const HalfPlane& h) { return covers(h, wall, mariner); };
    if (std::ranges::any_of(allowed.view(), covers_it)) continue;
    if (const auto beyond = half_plane(wall, mariner)) allowed.add(*beyond);
  }
}

/// Vehicles share the work of avoiding each other; what does not react leaves all of it to us.
void add_tracks(const Situation& s, const Orca2d::Params& params, AllowedVelocities& allowed) {
  const Vec2 position = s.own.position.head<2>();
  const Vec2 v_opt = s.own.velocity.head<2>();
  const double radius = s.own.radius;
  const double tau = params.time_horizon_s;
  const double period = params.interval(s);
  const double range2 = params.crit_dist_m * params.crit_dist_m;
  const double share = params.responsibility_ratio;
  int left = std::min(params.max_neighbours_count, max_neighbours);
  for (const Track& track : s.tracks) {
    const Vec2 p = track.position.head<2>() - position;
    if (p.squaredNorm() > range2) continue;
    if (left-- == 0) break;
    const orca2d::RelativeNeighbour encounter{p, v_opt - track.velocity.head<2>(), radius + track.radius,
                                              parting_direction(s.own.id, track.id).head<2>()};
    const orca2d::Change change = orca2d::least_change(encounter, tau, period);
    allowed.add(half_plane(change, v_opt, track.reacts ? share : 1.0), track.id);
  }
}

}  // namespace

Command Orca2d::decide(const Situation& s, Memory&, Context& context) const noexcept {
  AllowedVelocities allowed;
  if (!s.obstacles.empty()) add_shore(s, params, allowed);
  const std::size_t hard_count = allowed.view().size();
  add_tracks(s, params, allowed);

  const Vec2 preferred = preferred_velocity(s, params.symmetry, context, params.crit_dist_m).head<2>();
  if (allowed.view().empty()) return {.velocity = horizontal(preferred), .mode = Mode::cruise};

  const PlaneChoice choice = nearest_in_plane({allowed.view(), hard_count, s.limits.max_speed}, preferred);

  if (context.sketch) {
    allowed.draw(*context.sketch);
    context.sketch->velocity(horizontal(preferred), "preferred");
    context.sketch->velocity(horizontal(choice.point), "chosen");
  }
  return {.velocity = horizontal(choice.point),
          .mode = choice.is_feasible() ? Mode::avoid : Mode::infeasible,
          .astern = true};
}

}  // namespace fairway
