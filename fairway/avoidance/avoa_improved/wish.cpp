// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/wish.hpp"

#include <array>
#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::avoa_improved {
namespace {

/// Where the goal is only a velocity, the way is planned to what it leads to in this time [s].
constexpr double leg_ahead = 20.0;

/// What the way is to go round.
class InTheWay {
 public:
  void add(Capsule solid, double widened) {
    solid.radius += widened;
    all_[count_++] = solid;
  }
  std::span<const Capsule> view() const { return {all_.data(), count_}; }

 private:
  std::array<Capsule, 2 * Capsules::capacity> all_;
  std::size_t count_ = 0;
};

Vec2 target_of(const Situation& s) {
  if (!s.goal.velocity) return s.goal.position.head<2>();
  return (s.own.position + leg_ahead * s.preferred_velocity()).head<2>();
}

void draw_way(const WayRound& way, double depth, Sketch& sketch) {
  std::array<Vec3, WayRound::most_points> points;
  for (std::size_t i = 0; i < way.point_count; ++i) points[i] = {way.points[i].x(), way.points[i].y(), depth};
  sketch.path({points.data(), way.point_count}, "way round");
}

/// The way from where the vessel will be when it has answered its helm.
std::optional<WayRound> look(const AvoaImproved::Params& params, const Situation& s,
                             std::span<const Capsule> fixed, std::span<const Capsule> met, double kept,
                             const std::optional<Vec2>& committed) {
  InTheWay in_the_way;
  for (const Capsule& solid : fixed) in_the_way.add(solid, s.own.radius + kept);
  for (const Capsule& solid : met) in_the_way.add(solid, s.own.radius + kept);
  const Preference preference{.committed = committed,
                              .commitment = params.commitment_m,
                              .heading = unit_at(s.own.yaw),
                              .bend = params.bend_m};
  const Vec2 soon = s.own.position.head<2>() + params.anticipation_s * s.own.velocity.head<2>();
  return way_round(in_the_way.view(), soon, target_of(s), preference);
}

/// Leaves the wish as it is if nothing is in the way to the goal, or everything.
void go_round(const AvoaImproved::Params& params, const Situation& s, std::span<const Capsule> moving,
              AvoaImproved::Memory& memory, Wish& wish, Sketch* sketch) {
  Capsules met;
  for (const Capsule& mover : moving) {
    const auto there = meeting(mover, s.own.position.head<2>(), wish.speed, params.meeting_s, params.bow_s);
    if (there) met.add_near(*there, s.own.position.head<2>());
  }

  const std::span<const Capsule> fixed = memory.chart.view();
  const double kept = params.margin_m + params.way_margin_m;
  std::optional<WayRound> way = look(params, s, fixed, met.view(), kept, memory.committed);
  if (!way) way = look(params, s, fixed, {}, kept, memory.committed);
  if (!way) {
    way = look(params, s, fixed, {}, 0.5 * params.margin_m, memory.committed);
    if (way) wish.margin = 0.5 * params.margin_m;
  }

  memory.committed.reset();
  if (!way || way->is_straight) return;
  memory.committed = way->direction;
  wish.heading = math::atan2(way->direction.y(), way->direction.x());
  if (params.turn_aware) wish.heading += crab_angle(way->direction, memory.drift.velocity(), wish.speed);
  wish.is_preferred = false;
  if (sketch != nullptr) draw_way(*way, s.own.position.z(), *sketch);
}

/// At full speed up to a quarter of `turn_first` off the heading, from there on standing, or as slow as it
/// can go.
void turn_first(double turn_first, const Situation& s, Wish& wish) {
  const double off = std::abs(wrap_angle(wish.heading - s.own.yaw)) / turn_first;
  if (off <= 0.25) return;
  const double slower = wish.speed * (math::fmax(0.0, 1.0 - off) / 0.75);
  wish.speed = math::fmax(slower, math::fmin(s.limits.min_speed, wish.speed));
  wish.is_preferred = false;
}

}  // namespace

std::optional<Capsule> meeting(const Capsule& mover, const Vec2& own, double speed, double soon,
                               double bow) noexcept {
  // |q + w t| = speed t, the smaller positive root
  const Vec2 q = mover.from - own;
  const double closing = -q.dot(mover.velocity);
  const double root = closing * closing + (speed * speed - mover.velocity.squaredNorm()) * q.squaredNorm();
  if (root < 0.0) return {};
  const double divisor = std::sqrt(root) + closing;
  if (divisor <= 0.0 || q.squaredNorm() > soon * divisor) return {};
  const Vec2 there = mover.from + (q.squaredNorm() / divisor) * mover.velocity;
  return Capsule{there, there + bow * mover.velocity, mover.radius};
}

Wish wish_of(const AvoaImproved::Params& params, const Situation& s, std::span<const Capsule> moving,
             AvoaImproved::Memory& memory, Sketch* sketch) noexcept {
  const Vec2 preferred = s.preferred_velocity().head<2>();
  const double speed = preferred.norm();
  Wish wish{.speed = speed, .speed_after = speed, .heading = s.own.yaw, .margin = params.margin_m};
  if (wish.speed <= 0.0) return wish;
  wish.heading = math::atan2(preferred.y(), preferred.x());

  if (params.memory) go_round(params, s, moving, memory, wish, sketch);
  if (params.turn_aware) turn_first(params.turn_first_rad, s, wish);
  return wish;
}

}  // namespace fairway::avoa_improved
