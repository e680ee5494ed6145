// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/wall_following/corrected.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/avoidance/nearest_few.hpp"
#include "fairway/avoidance/safety_filter/hazards.hpp"
#include "fairway/avoidance/wall_following/printed.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::wall {
namespace {

using Round = WallFollowing::Round;

/// Directions this near to the edge of what is allowed are allowed [rad].
constexpr double edge = 1e-9;

/// Closing speed allowed per metre beyond the standoff [1/s]. Who is led past what stands leaves the way only
/// for what is close by, and what foresees the vehicle brakes for it; who is not comes slowly, to have turned
/// in time.
double approach_gain(const WallFollowing::Params& params, const Situation& s) {
  constexpr double led = 1.0;
  constexpr double alone = 0.3;
  if (params.approach_gain_hz > 0.0) return params.approach_gain_hz;
  return s.is_led && s.envelope ? led : alone;
}

/// The half-planes of one decision, on the stack.
class HalfPlanes {
 public:
  HalfPlanes(const WallFollowing::Params& params, const Situation& s, const Vec3& preferred)
      : gain_{approach_gain(params, s)} {
    find_hazards_near(s, params.sensor_range_m, hazards_);
    for (const Hazard& hazard : hazards_.view()) add(params, s, hazard, preferred);
  }
  std::span<const HalfPlane> view() const { return {all_.data(), count_}; }
  bool left_out() const { return hazards_.left_out; }

  /// Speed of what moves fastest [m/s].
  double fastest() const {
    double fastest = 0.0;
    for (std::size_t i = 0; i < count_; ++i)
      fastest = std::max(fastest, horizontal_norm(hazards_.all[i].velocity));
    return fastest;
  }

  /// The half-planes, and the way to the surface whose half-plane leaves `chosen` the least room.
  void draw(const Vec3& own, const Vec3& chosen, bool following, Sketch& sketch) const {
    for (const HalfPlane& h : view()) {
      const Vec3 normal{h.normal.x(), h.normal.y(), 0.0};
      sketch.half_space(h.offset * normal, normal, "allowed by a surface");
    }
    if (!following || count_ == 0) return;
    const auto room = [&](const HalfPlane& h) { return -h.violation(chosen.head<2>()); };
    const auto wall = static_cast<std::size_t>(std::ranges::min_element(view(), {}, room) - view().begin());
    const Hazard& hazard = hazards_.all[wall];
    const Vec3 surface = hazard.centre + hazard.radius * unit(Vec3{own - hazard.centre});
    sketch.path(std::array{own, surface}, "followed");
  }

 private:
  /// The closing speed is at most in proportion to what is left beyond the standoff; within it, the other
  /// way round. What the vertical speeds do to the range is taken as given.
  void add(const WallFollowing::Params& params, const Situation& s, const Hazard& hazard,
           const Vec3& preferred) {
    const Vec3 from = s.own.position - hazard.centre;
    const double level = horizontal_norm(from);
    const double opening = gain_ * (params.standoff_m - hazard.gap(s.own));
    if (level <= 0.0) {
      all_[count_++] = {hazard.parting.head<2>(), opening};
      return;
    }
    const double opening_by_others = (from.dot(hazard.velocity) - from.z() * preferred.z()) / level;
    all_[count_++] = {from.head<2>() / level, opening * from.norm() / level + opening_by_others};
  }

  double gain_;
  Hazards hazards_;
  std::array<HalfPlane, max_hazards> all_;
  std::size_t count_ = 0;
};

/// The one that `v` violates most, if any.
const HalfPlane* blocking(std::span<const HalfPlane> half_planes, const Vec2& v) {
  const HalfPlane* worst = nullptr;
  double violation = 0.0;
  for (const HalfPlane& h : half_planes) {
    if (h.violation(v) <= violation) continue;
    violation = h.violation(v);
    worst = &h;
  }
  return worst;
}

/// The speed of following: that of the mission, without the slowing down for the goal.
double following_speed(const Situation& s, const Vec2& preferred) {
  return s.goal.velocity ? preferred.norm() : std::min(s.goal.cruise_speed, s.limits.max_speed);
}

/// What drifts away from the goal is never left by who waits to be nearer to it than where following began.
/// So that place is taken to move away as fast as the fastest that is near.
void carry_along(Round& round, double fastest, double period) {
  if (round.following) round.hit_distance += fastest * period;
}

/// Another goal may lie so far away that nobody who follows is ever nearer to it than to the one before where
/// following began. So that distance grows with the way between both.
void turn_to(Round& round, const Vec2& goal) {
  constexpr double another = 2.0;  // a goal that moves farther from one decision to the next is another [m]
  const double moved = (goal - round.goal).norm();
  if (round.following && moved > another) round.hit_distance += moved;
  round.goal = goal;
}

/// Following begins where the wanted velocity is blocked, and ends where it no longer is, nearer to the goal
/// than it began.
void begin_or_end(Round& round, const HalfPlane* in_the_way, const Vec2& preferred, double to_goal) {
  if (round.following && in_the_way == nullptr && to_goal < round.hit_distance) round = {};
  if (round.following || in_the_way == nullptr || preferred.isZero(0.0)) return;
  const double turn = turn_along(in_the_way->normal, preferred);
  round = {.following = true,
           .turn = turn,
           .along = turn * clockwise(in_the_way->normal),
           .hit_distance = to_goal,
           .goal = round.goal};
}

/// The directions that half-planes allow at a speed, as arcs. Angles of turning are positive.
class Bearings {
 public:
  Bearings(std::span<const HalfPlane> allowed, double turn, double speed)
      : allowed_{allowed}, turn_{turn}, speed_{speed} {}

  bool any_allowed() const {
    return std::ranges::all_of(allowed_, [&](const HalfPlane& h) { return h.offset <= speed_; });
  }

  /// How far to turn away from the wall until nothing forbids it; nothing if that is never.
  std::optional<double> away_from_wall(double bearing) const {
    double turned = 0.0;
    std::size_t kept = 0;
    for (std::size_t i = 0; kept < allowed_.size() && turned < 2.0 * pi; ++i) {
      ++kept;
      const HalfPlane& h = allowed_[i % allowed_.size()];
      const double now = bearing + turn_ * turned;
      if (h.offset <= -speed_ || std::abs(wrap_angle(now - middle(h))) <= half(h) + edge) continue;
      turned += positive(turn_ * (begin(h) - now));
      kept = 0;  // the others once more
    }
    return turned < 2.0 * pi ? std::optional{turned} : std::nullopt;
  }

  /// How far to turn towards the wall until something forbids going on, from an allowed direction.
  double towards_wall(double bearing) const {
    double least = 2.0 * pi;
    for (const HalfPlane& h : allowed_) {
      if (h.offset <= -speed_) continue;
      const double turned = positive(turn_ * (bearing - begin(h)));
      least = math::fmin(least, turned < 2.0 * pi - 2.0 * edge ? turned : 0.0);
    }
    return least;
  }

 private:
  static double middle(const HalfPlane& h) { return math::atan2(h.normal.y(), h.normal.x()); }
  double half(const HalfPlane& h) const { return math::acos(h.offset / speed_); }

  /// Where the arc begins for who turns away from the wall.
  double begin(const HalfPlane& h) const { return middle(h) - turn_ * half(h); }

  static double positive(double angle) {
    const double wrapped = wrap_angle(angle);
    return wrapped < 0.0 ? wrapped + 2.0 * pi : wrapped;
  }

  std::span<const HalfPlane> allowed_;
  double turn_;
  double speed_;
};

/// The velocity along the wall, or `preferred` where the wall has gone. Faster than the mission wants where
/// that is too slow to get out of the way.
Vec2 way_round(Round& round, std::span<const HalfPlane> half_planes, const Situation& s,
               const Vec2& preferred) {
  double speed = following_speed(s, preferred);
  if (speed <= 0.0) return Vec2::Zero();
  std::optional<Way> way = way_along(half_planes, round.along, round.turn, speed);
  if (!way && s.limits.max_speed < Limits::none) {
    speed = s.limits.max_speed;
    way = way_along(half_planes, round.along, round.turn, speed);
  }
  if (!way) return Vec2::Zero();
  if (!way->has_wall) {
    round = {};
    return preferred;
  }
  round.along = way->direction;
  return speed * way->direction;
}

}  // namespace

std::optional<Way> way_along(std::span<const HalfPlane> allowed, const Vec2& along, double turn,
                             double speed) noexcept {
  const Bearings bearings{allowed, turn, speed};
  const double before = math::atan2(along.y(), along.x());
  if (!bearings.any_allowed()) return {};
  const std::optional<double> out = bearings.away_from_wall(before);
  if (!out) return {};
  if (*out > 0.0) return Way{unit_at(before + turn * *out), true};
  const double back = bearings.towards_wall(before);
  return back > pi / 2 ? Way{along, false} : Way{unit_at(before - turn * back), true};
}

Command decide_corrected(const WallFollowing::Params& params, const Situation& s, Round& round,
                         Context& context) noexcept {
  const Vec3 preferred = s.preferred_velocity();
  const Vec2 wanted = preferred.head<2>();
  const HalfPlanes half_planes{params, s, preferred};
  const HalfPlane* const in_the_way = blocking(half_planes.view(), wanted);
  if (half_planes.view().empty()) round = {};
  turn_to(round, s.goal.position.head<2>());
  carry_along(round, half_planes.fastest(), s.period);
  begin_or_end(round, in_the_way, wanted, horizontal_norm(s.goal.position - s.own.position));
  const std::string_view left_out = half_planes.left_out() ? words_of_left_out : "";
  if (!round.following && in_the_way == nullptr)
    return {.velocity = preferred, .mode = Mode::cruise, .note = left_out};

  const Vec2 wish = round.following ? way_round(round, half_planes.view(), s, wanted) : wanted;
  const PlaneChoice choice =
      nearest_in_plane({.half_planes = half_planes.view(), .max_length = s.limits.max_speed}, wish);
  const Vec3 velocity{choice.point.x(), choice.point.y(), preferred.z()};
  if (context.sketch) {
    half_planes.draw(s.own.position, velocity, round.following, *context.sketch);
    context.sketch->velocity(preferred, "preferred");
    if (round.following) context.sketch->velocity({wish.x(), wish.y(), 0.0}, "along the wall");
    context.sketch->velocity(velocity, "chosen");
  }
  return {.velocity = velocity,
          .mode = choice.is_feasible() ? Mode::avoid : Mode::infeasible,
          .note = choice.is_feasible() ? left_out : "within the standoff, and too slow to leave it"};
}

}  // namespace fairway::wall
