// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/bvc/bvc.hpp"

#include <array>

#include "fairway/avoidance/label.hpp"
#include "fairway/avoidance/nearest_few.hpp"
#include "fairway/avoidance/parting.hpp"
#include "fairway/avoidance/velocity_program/velocity_program.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

constexpr double fastest_known = 1e6;  // of what counts as a speed [m/s]

/// The faces of a cell, as half-spaces of velocities, on the stack.
struct VoronoiCell {
  std::array<HalfSpace, max_half_spaces> faces;
  NearestFew<max_half_spaces> places;

  /// Towards `direction`, a unit vector, own ship may go so far within a time. Of too many the nearest count.
  void add(const Vec3& direction, double distance, double time) {
    const std::size_t place = places.place_for(distance);
    if (place < max_half_spaces) faces[place] = {-direction, -distance / time};
  }
};

Vec3 direction_of(const Vec3& v, const Vec3& otherwise) {
  const double length = v.norm();
  return length > 1e-9 ? Vec3{v / length} : otherwise;
}

/// Half of the gap to who keeps to its own half of it, all of it to who does not know.
void add_faces_of_tracks(const Situation& s, const Bvc::Params& params, Sketch* sketch, VoronoiCell& cell) {
  for (const Track& track : s.tracks) {
    const Vec3 apart = track.position - s.own.position;
    const double distance = apart.norm();
    if (distance > params.crit_dist_m) continue;
    const Vec3 towards = direction_of(apart, -parting_direction(s.own.id, track.id));
    const double gap = distance - s.own.radius - track.radius;
    const double share = track.reacts ? 0.5 * gap : gap;
    cell.add(towards, share, params.time_horizon_s);
    if (sketch != nullptr)
      sketch->half_space(s.own.position + share * towards, -towards, Label{"cell, beside", track.id});
  }
}

/// The tangent plane at the nearest point.
void add_faces_of_obstacles(const Situation& s, const Bvc::Params& params, VoronoiCell& cell) {
  for (const Obstacle& obstacle : s.obstacles) {
    const SurfacePoint surface = nearest_point(obstacle, s.own.position);
    if (surface.distance > params.crit_dist_m) continue;
    const Vec3 towards = (surface.distance < 0.0 ? -1.0 : 1.0) * (surface.point - s.own.position);
    cell.add(direction_of(towards, Vec3::UnitX()), surface.distance - s.own.radius, params.time_horizon_s);
  }
}

/// At a right angle to starboard of a velocity; of one that is vertical, of the bow.
Vec3 to_starboard(const Vec3& v, double yaw) {
  const double level = horizontal_norm(v);
  const Vec2 ahead = level > 1e-9 ? Vec2{v.head<2>() / level} : unit_at(yaw);
  const Vec2 abeam = v.norm() * starboard_of(ahead);
  return {abeam.x(), abeam.y(), 0.0};
}

}  // namespace

Command Bvc::decide(const Situation& s, Memory&, Context& context) const noexcept {
  VoronoiCell cell;
  add_faces_of_tracks(s, params, context.sketch, cell);
  add_faces_of_obstacles(s, params, cell);
  const Vec3 preferred = s.preferred_velocity();
  if (cell.places.count() == 0) return {.velocity = preferred, .mode = Mode::cruise};

  const double max_speed = math::fmin(s.limits.max_speed, fastest_known);
  const std::span<const HalfSpace> faces = std::span{cell.faces}.first(cell.places.count());
  VelocityChoice choice = nearest_velocity(faces, preferred, max_speed);
  const bool is_stuck =
      choice.is_feasible() && choice.velocity.norm() < params.deadlock_ratio * preferred.norm();
  if (is_stuck) choice = nearest_velocity(faces, to_starboard(preferred, s.own.yaw), max_speed);

  if (context.sketch != nullptr) {
    context.sketch->velocity(preferred, "preferred");
    context.sketch->velocity(choice.velocity, "chosen");
  }
  if (!choice.is_feasible())
    return {
        .velocity = choice.velocity, .mode = Mode::infeasible, .astern = true, .note = "is outside its cell"};
  return {.velocity = choice.velocity,
          .mode = Mode::avoid,
          .astern = true,
          .note = is_stuck                 ? "goes along the edge of its cell"
                  : cell.places.left_out() ? words_of_left_out
                                           : ""};
}

}  // namespace fairway
