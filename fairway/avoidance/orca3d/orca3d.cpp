// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/orca3d/orca3d.hpp"

#include <algorithm>
#include <array>

#include "fairway/avoidance/label.hpp"
#include "fairway/avoidance/nearest_few.hpp"
#include "fairway/avoidance/orca3d/columns.hpp"
#include "fairway/avoidance/orca3d/half_space.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

/// The half-spaces of one decision, on the stack; those of tracks come first.
struct HalfSpaces {
  std::array<HalfSpace, max_half_spaces> all;
  std::array<const Track*, max_half_spaces> tracks;
  NearestFew<max_half_spaces> places;
};

void add_neighbours(const Situation& s, const OrcaParams& params, std::size_t count,
                    HalfSpaces& half_spaces) {
  if (count == 0) return;
  const lanes::Kernel& kernel = lanes::kernel_for(count);
  const std::size_t width = kernel.lanes;
  alignas(64) std::array<double, lanes::columns> own;
  alignas(64) std::array<double, lanes::columns * lanes::most_lanes> others;
  alignas(64) std::array<double, 4 * lanes::most_lanes> answer;
  orca::write_columns(s.own.position, s.own.velocity, s.own.radius, 0.0, 1, own.data());
  for (std::size_t first = 0; first < count; first += width) {
    const std::size_t here = std::min(width, count - first);
    for (std::size_t i = 0; i < here; ++i)
      orca::write_neighbour(s, params, *half_spaces.tracks[first + i], width, others.data() + i);
    for (std::size_t i = here; i < width; ++i) orca::write_nobody(width, others.data() + i);
    kernel.half_spaces(params.time_horizon_s, params.interval(s), own.data(), others.data(), answer.data());
    for (std::size_t i = 0; i < here; ++i)
      half_spaces.all[first + i] = {{answer[i], answer[width + i], answer[2 * width + i]},
                                    answer[3 * width + i]};
  }
}

/// An obstacle as a neighbour that does not move: a sphere as it is, anything else as the point of its
/// surface that is nearest; from inside, the push is out through that point.
orca::Change change_for(const Obstacle& obstacle, const SurfacePoint& surface, const Situation& s, double tau,
                        double interval) {
  const Vec3& v = s.own.velocity;
  const Vec3 parting = parting_direction(s.own.id, TrackId{number(s.own.id)});
  if (obstacle.kind == Obstacle::Kind::sphere) {
    return orca::least_change(
        {obstacle.position - s.own.position, v, s.own.radius + obstacle.radius, parting}, tau, interval);
  }
  const Vec3 p = surface.point - s.own.position;
  if (surface.distance >= 0.0) return orca::least_change({p, v, s.own.radius, parting}, tau, interval);

  const Vec3 outward = p / -surface.distance;
  return {outward, (s.own.radius - surface.distance) / interval - outward.dot(v)};
}

/// And so does what does not move, of too much of it the nearest.
std::size_t add_obstacles(const Situation& s, const OrcaParams& params, HalfSpaces& half_spaces,
                          std::size_t tracks) {
  if (s.obstacles.empty()) return tracks;
  half_spaces.places.take(tracks);
  for (const Obstacle& obstacle : s.obstacles) {
    const SurfacePoint surface = nearest_point(obstacle, s.own.position);
    if (surface.distance > params.crit_dist_m) continue;
    const std::size_t at = half_spaces.places.place_for(surface.distance);
    if (at == max_half_spaces) continue;
    const orca::Change change =
        change_for(obstacle, surface, s, params.obstacle_time_horizon_s, params.interval(s));
    half_spaces.all[at] = orca::half_space(change, s.own.velocity, 1.0);
  }
  return half_spaces.places.count();
}

void draw(const HalfSpaces& half_spaces, std::size_t tracks, std::size_t count, Sketch& sketch) {
  for (std::size_t i = 0; i < count; ++i) {
    const HalfSpace& h = half_spaces.all[i];
    const Vec3 point = h.offset * h.normal;
    if (i < tracks) {
      sketch.half_space(point, h.normal, Label{"allowed by", half_spaces.tracks[i]->id});
    } else {
      sketch.half_space(point, h.normal, "allowed by an obstacle");
    }
  }
}

}  // namespace

Command Orca3d::decide(const Situation& s, Memory&, Context& context) const noexcept {
  HalfSpaces half_spaces;
  const std::size_t tracks = orca::find_neighbours(s, params, half_spaces.tracks);
  add_neighbours(s, params, tracks, half_spaces);
  const std::size_t count = add_obstacles(s, params, half_spaces, tracks);

  const Vec3 preferred = preferred_velocity(s, params.symmetry, context, params.crit_dist_m);
  if (count == 0) return {.velocity = preferred, .mode = Mode::cruise};

  const double max_speed = math::fmin(s.limits.max_speed, orca::fastest);
  const VelocityChoice choice = nearest_velocity({half_spaces.all.data(), count}, preferred, max_speed);

  if (context.sketch) {
    draw(half_spaces, tracks, count, *context.sketch);
    context.sketch->velocity(preferred, "preferred");
    context.sketch->velocity(choice.velocity, "chosen");
  }
  Command command = orca::command_of(choice);
  if (half_spaces.places.left_out()) command.note = words_of_left_out;
  return command;
}

}  // namespace fairway
