// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/rrt_star/pursuit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

constexpr double least = 1e-3;        // of a rate or an acceleration that is divided by
constexpr double authority = 0.9;     // of the greatest turn rate; the rest is left to the autopilot
constexpr int points_looked_at = 16;  // of the way ahead

/// What the vehicle can do at the speed of the plan.
struct Ability {
  double speed;         ///< [m/s]
  double turn_rate;     ///< [rad/s]
  double deceleration;  ///< [m/s2]
  double lag;           ///< of the turn rate [s]

  Ability(const Situation& s, double at_speed)
      : speed{at_speed},
        turn_rate{
            std::max(least, authority * std::min(s.envelope->turn_rate(speed), s.limits.max_turn_rate))},
        deceleration{std::max(least, s.envelope->deceleration)},
        lag{s.envelope->turn_lag} {}

  double time_to_turn(double angle) const { return lag + angle / turn_rate + speed / deceleration; }
  double look_ahead() const { return speed * time_to_turn(0.5 * pi); }
  double turning_radius() const { return speed / turn_rate; }
};

double angle_between(const Vec2& a, const Vec2& b) { return std::abs(math::atan2(cross(a, b), a.dot(b))); }

/// The point that is `along` [m] from the beginning of `path`; its end beyond that.
Vec2 point_at(std::span<const Vec2> path, double along) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 leg = path[i] - path[i - 1];
    const double length = leg.norm();
    if (along < length) return path[i - 1] + along / length * leg;
    along -= length;
  }
  return path.back();
}

/// The place between `from` and `to` [m] along `path` that is nearest to `own`.
double nearest_place(std::span<const Vec2> path, double from, double to, const Vec2& own) {
  double best = from, nearest = std::numeric_limits<double>::infinity(), begin = 0.0;
  for (std::size_t i = 1; i < path.size() && begin <= to; ++i) {
    const Vec2 leg = path[i] - path[i - 1];
    const double length = leg.norm();
    if (begin + length >= from && length > 0.0) {
      const double last = std::min(length, to - begin);
      const double first = std::clamp(from - begin, 0.0, last);
      const double t = std::clamp((own - path[i - 1]).dot(leg) / length, first, last);
      const double distance = (path[i - 1] + t / length * leg - own).norm();
      if (distance < nearest) {
        nearest = distance;
        best = begin + t;
      }
    }
    begin += length;
  }
  return best;
}

/// By how much `path` turns within `length` [m] of its corner `first`, to either side.
double turned_within(std::span<const Vec2> path, std::size_t first, double length) {
  double turned = 0.0;
  for (std::size_t i = first; i + 1 < path.size() && length >= 0.0; ++i) {
    turned += angle_between(path[i] - path[i - 1], path[i + 1] - path[i]);
    length -= (path[i + 1] - path[i]).norm();
  }
  return turned;
}

/// The speed at which the corners ahead can be rounded, with the way there to slow down on.
double pace(const Ability& can, std::span<const Vec2> path, double along) {
  double speed = can.speed, begin = 0.0;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    begin += (path[i] - path[i - 1]).norm();
    const double ahead = begin - along;
    if (ahead < 0.0) continue;
    if (ahead > can.look_ahead()) break;
    const double rounding = can.speed / std::max(1.0, turned_within(path, i, can.turning_radius()));
    speed = std::min(speed, std::sqrt(rounding * rounding + 2.0 * can.deceleration * ahead));
  }
  return speed;
}

/// The farthest point ahead that can be gone to straight.
std::optional<Vec2> in_sight(const Ability& can, const Plan& plan, double along, const Vec2& own) {
  for (int k = points_looked_at; k > 0; --k) {
    const Vec2 point = point_at(plan.path, along + can.look_ahead() * k / points_looked_at);
    if (plan.task.map.is_free(own, point)) return point;
  }
  return {};
}

}  // namespace

double strays_by(const Situation& s, double speed) noexcept {
  const Ability can{s, speed};
  return can.speed * can.lag * math::sin(pi / 6) + can.turning_radius() * (1.0 / math::cos(pi / 12) - 1.0);
}

Vec3 Pursuit::follow(const Situation& s, const Plan& plan) noexcept {
  const Ability can{s, plan.task.limits.max_speed_mps};
  const Vec2 own = seen_from_above(s.own.position);
  along = nearest_place(plan.path, along, along + can.look_ahead(), own);
  if (along > gained + s.own.radius) {
    gained = along;
    gained_s = s.time;
  }
  const std::optional<Vec2> seen = in_sight(can, plan, along, own);
  sees = seen.has_value();
  const Vec2 back = point_at(plan.path, along + can.look_ahead() / points_looked_at);
  const Vec2 aim = seen.value_or(back);
  const double distance = (aim - own).norm();
  if (!(distance > 0.0)) return Vec3::Zero();
  const double speed = std::min(pace(can, plan.path, along), distance / s.period);
  const Vec2 velocity = speed / distance * (aim - own);
  return {velocity.x(), velocity.y(), 0.0};
}

bool Pursuit::is_stuck(const Situation& s, const Plan& plan) const noexcept {
  return !sees || s.time - gained_s > Ability{s, plan.task.limits.max_speed_mps}.time_to_turn(pi);
}

bool Pursuit::is_blocked(const Plan& plan, const PlanarMap& map) const noexcept {
  Vec2 from = point_at(plan.path, along);
  double begin = 0.0;
  for (std::size_t i = 1; i < plan.path.size(); ++i) {
    begin += (plan.path[i] - plan.path[i - 1]).norm();
    if (begin <= along) continue;
    if (!map.is_free(from, plan.path[i])) return true;
    from = plan.path[i];
  }
  return false;
}

}  // namespace fairway
