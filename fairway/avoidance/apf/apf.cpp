// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/apf/apf.hpp"

#include <algorithm>

#include "fairway/avoidance/parting.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

/// Repulsion of one neighbour `distance` away, in direction `away` (Algorithm 1, lines 5-10).
Vec3 repulsion(double crit_dist, double distance, const Vec3& away) {
  return (crit_dist - distance) / crit_dist * away;
}

/// Lines 27-41 without the steering, which is the autopilot's.
Vec3 velocity_of(ApfSpeedLaw law, const Vec3& v_f, double cruise_speed) {
  const double horizontal = horizontal_norm(v_f);
  const bool full_speed = law == ApfSpeedLaw::bang_bang;

  const double speed = full_speed ? cruise_speed : math::fmin(horizontal, cruise_speed);
  const double scale = horizontal > 0.0 ? speed / horizontal : 0.0;

  const double limit = v_f.z() == 0.0 ? 0.0 : cruise_speed;
  const double w = full_speed ? std::copysign(limit, v_f.z()) : std::clamp(v_f.z(), -limit, limit);
  return {scale * v_f.x(), scale * v_f.y(), w};
}

}  // namespace

Command Apf::decide(const Situation& s, Memory&, Context& context) const noexcept {
  const double crit_dist = params.crit_dist_m;
  Vec3 v_obs = Vec3::Zero();
  bool is_alone = true;

  // vehicles push from centre to centre
  for (const Track& track : s.tracks) {
    const Vec3 out = s.own.position - track.position;
    const double distance = out.norm();
    if (distance > crit_dist) continue;
    is_alone = false;
    const Vec3 away = distance > 0.0 ? Vec3{out / distance} : parting_direction(s.own.id, track.id);
    v_obs += repulsion(crit_dist, distance, away);
  }

  // what does not move pushes from its nearest surface point; from inside, out through that point
  for (const Obstacle& obstacle : s.obstacles) {
    const SurfacePoint surface = nearest_point(obstacle, s.own.position);
    if (surface.distance > crit_dist) continue;
    is_alone = false;
    const Vec3 out =
        surface.distance < 0.0 ? Vec3{surface.point - s.own.position} : Vec3{s.own.position - surface.point};
    const double length = out.norm();
    const Vec3 away =
        length > 0.0 ? Vec3{out / length} : parting_direction(s.own.id, TrackId{number(s.own.id)});
    v_obs += repulsion(crit_dist, math::fmax(surface.distance, 0.0), away);
  }

  const Vec3 preferred = s.preferred_velocity();
  if (is_alone) return {.velocity = preferred, .mode = Mode::cruise};

  // eq. 1 and line 13
  const Vec3 v_obj = unit(preferred);
  const Vec3 v_f = params.w1_ratio * v_obj + params.w2_ratio * v_obs;

  if (context.sketch) {
    context.sketch->velocity(params.w1_ratio * v_obj, "attraction");
    context.sketch->velocity(params.w2_ratio * v_obs, "repulsion");
    context.sketch->velocity(v_f, "force");
  }
  return {.velocity = velocity_of(params.speed_law, v_f, s.goal.cruise_speed),
          .mode = Mode::avoid,
          .astern = true};
}

}  // namespace fairway
