// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/orca3d/orca3d.hpp"

#include <array>

#include "fairway/avoidance/label.hpp"
#include "fairway/avoidance/orca3d/half_space.hpp"
#include "fairway/avoidance/parting.hpp"

namespace fairway {
namespace {

/// Stands in for a speed limit that is not set [m/s]: the velocity program needs a bounded space.
constexpr double fastest = 1000.0;

/// The half-spaces of one decision, on the stack; those of tracks come first.
class HalfSpaces {
 public:
  bool is_full() const { return count_ == half_spaces_.size(); }
  void add(const HalfSpace& h) { half_spaces_[count_++] = h; }
  void add(const HalfSpace& h, TrackId whose) {
    ids_[track_count_++] = whose;
    add(h);
  }
  std::span<const HalfSpace> view() const { return {half_spaces_.data(), count_}; }

  void draw(Sketch& sketch) const {
    for (std::size_t i = 0; i < count_; ++i) {
      const HalfSpace& h = half_spaces_[i];
      const Vec3 point = h.offset * h.normal;
      if (i < track_count_) {
        sketch.half_space(point, h.normal, Label{"allowed by", ids_[i]});
      } else {
        sketch.half_space(point, h.normal, "allowed by an obstacle");
      }
    }
  }

 private:
  std::array<HalfSpace, max_half_spaces> half_spaces_;
  std::array<TrackId, max_half_spaces> ids_;  // of the tracks
  std::size_t count_ = 0;
  std::size_t track_count_ = 0;
};

/// An obstacle as a neighbour that does not move: a sphere as it is, anything else as the point of its
/// surface that is nearest; from inside, the push is out through that point.
orca::Change change_for(const Obstacle& obstacle, const SurfacePoint& surface, const Situation& s,
                        double tau) {
  const Vec3& v = s.own.velocity;
  const Vec3 parting = parting_direction(s.own.id, TrackId{number(s.own.id)});
  if (obstacle.kind == Obstacle::Kind::sphere) {
    return orca::least_change(
        {obstacle.position - s.own.position, v, s.own.radius + obstacle.radius, parting}, tau, s.period);
  }
  const Vec3 p = surface.point - s.own.position;
  if (surface.distance >= 0.0) return orca::least_change({p, v, s.own.radius, parting}, tau, s.period);

  const Vec3 outward = p / -surface.distance;
  return {outward, (s.own.radius - surface.distance) / s.period - outward.dot(v)};
}

}  // namespace

Command Orca3d::decide(const Situation& s, Memory&, Context& context) const noexcept {
  const double range = params.crit_dist_m;
  const Vec3& v_opt = s.own.velocity;
  HalfSpaces half_spaces;

  // vehicles share the work of avoiding each other; what does not react leaves all of it to us
  int neighbours = 0;
  for (const Track& track : s.tracks) {
    const Vec3 p = track.position - s.own.position;
    if (p.squaredNorm() > range * range) continue;
    if (++neighbours > params.max_neighbours_count) break;
    const orca::RelativeNeighbour encounter{p, v_opt - track.velocity, s.own.radius + track.radius,
                                            parting_direction(s.own.id, track.id)};
    const orca::Change change = orca::least_change(encounter, params.time_horizon_s, s.period);
    half_spaces.add(orca::half_space(change, v_opt, track.reacts ? params.responsibility_ratio : 1.0),
                    track.id);
  }

  // and so does what does not move
  for (const Obstacle& obstacle : s.obstacles) {
    const SurfacePoint surface = nearest_point(obstacle, s.own.position);
    if (surface.distance > range) continue;
    if (half_spaces.is_full()) break;
    const orca::Change change = change_for(obstacle, surface, s, params.obstacle_time_horizon_s);
    half_spaces.add(orca::half_space(change, v_opt, 1.0));
  }

  const Vec3 preferred = preferred_velocity(s, params.symmetry, context, range);
  if (half_spaces.view().empty()) return {.velocity = preferred, .mode = Mode::cruise};

  const double max_speed = std::fmin(s.limits.max_speed, fastest);
  const VelocityChoice choice = nearest_velocity(half_spaces.view(), preferred, max_speed);

  if (context.sketch) {
    half_spaces.draw(*context.sketch);
    context.sketch->velocity(preferred, "preferred");
    context.sketch->velocity(choice.velocity, "chosen");
  }
  return {.velocity = choice.velocity,
          .mode = choice.is_feasible() ? Mode::avoid : Mode::infeasible,
          .astern = true};
}

}  // namespace fairway
