// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/trackable/foresight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/avoidance/avoa_improved/capsule.hpp"
#include "fairway/core/math.hpp"

namespace fairway::trackable {
namespace {

constexpr double kept_of_lost = 0.9;    // of what is left of a margin
constexpr double most_crab_sine = 0.7;  // of the angle that is headed up into the drift
constexpr double least_lag = 0.02;      // [s]
constexpr double least_drift = 0.03;    // slower is none [m/s]
constexpr double least_rounding = 1.0 + 1e-12;

double squared(double x) { return x * x; }

/// Squared distance from the segment `a` to `b`.
double distance2(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 along = b - a;
  const double share = std::clamp(along.dot(p - a) / along.squaredNorm(), 0.0, 1.0);
  return (p - a - share * along).squaredNorm();
}

double towards(double from, double to, double share, double least, double most) {
  return from + std::clamp(share * (to - from), least, most);
}

double error_of(const Vec2& ahead, const Vec2& heading) {
  return math::atan2(cross(ahead, heading), ahead.dot(heading));
}

}  // namespace

Plan standing_still(const Vec2& ahead, const Vec2& drift) noexcept {
  const double speed = drift.norm();
  return {.direction = speed > least_drift ? Vec2{-drift / speed} : ahead};
}

Foresight::Foresight(const TurnLaw& law, const Situation& s, const Outlook& outlook) noexcept
    : law_{law},
      outlook_{outlook},
      own_radius_{s.own.radius},
      step_{outlook.window / steps},
      turn_share_{1.0 - math::exp(-step_ / std::max(law.envelope().turn_lag, least_lag))},
      surge_share_{1.0 - math::exp(-step_ / std::max(law.envelope().surge_lag, least_lag))},
      sway_share_{1.0 - math::exp(-step_ / std::max(law.envelope().sway_lag, least_lag))},
      most_turn_{law.envelope().turn_acceleration * step_},
      most_faster_{law.envelope().acceleration * step_},
      most_slower_{law.envelope().deceleration * step_},
      hold_steps_{
          std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(outlook.hold / step_)), 1, steps)},
      room_now_{std::numeric_limits<double>::infinity()} {
  now_.ahead = {math::cos(s.own.yaw), math::sin(s.own.yaw)};
  now_.turn_rate = s.own.yaw_rate;
  now_.speed = now_.ahead.dot(s.own.velocity.head<2>());
  now_.sway = starboard_of(now_.ahead).dot(s.own.velocity.head<2>() - outlook.drift);
  const double fastest = std::max(std::min(law.envelope().ahead, s.limits.max_speed), std::abs(now_.speed));
  reach_ = (fastest + outlook.drift.norm()) * outlook.window;

  const Vec2 own = s.own.position.head<2>();
  const auto passes_over = [&](const Vec3& position, double radius, double climb) {
    const double below = position.z() - s.own.position.z();
    const double kept = radius + own_radius_ + outlook.margin;
    const double beyond = std::abs(below) - kept;
    if (beyond > 0.0 && (position.head<2>() - own).norm() < kept + fastest * outlook.hold) {
      const double spare = beyond - (unasked_climb * law.envelope().ahead + std::abs(climb)) * outlook.window;
      double& most = below > 0.0 ? most_sinking_ : most_rising_;
      most = std::min(most, std::max(0.0, spare / (outlook.window + outlook.hold)));
    }
    return beyond > (outlook.climb + std::abs(climb)) * outlook.window;
  };
  for (const Obstacle& obstacle : s.obstacles) {
    if (obstacle.kind == Obstacle::Kind::sphere && passes_over(obstacle.position, obstacle.radius, 0.0))
      continue;
    avoa_improved::for_each_solid(obstacle, [&](const avoa_improved::Capsule& solid) {
      add(solid.from - own, solid.to - own, solid.radius, Vec2::Zero());
    });
  }
  for (const Track& track : s.tracks) {
    if (passes_over(track.position, track.radius, track.velocity.z())) continue;
    const Vec2 p = track.position.head<2>() - own;
    add(p, p, track.radius, track.velocity.head<2>());
  }
}

void Foresight::add(const Vec2& from, const Vec2& to, double radius, const Vec2& velocity) noexcept {
  if (count_ == most_hazards) return;
  Hazard hazard{from, to, velocity, radius + own_radius_, 0.0, from == to};
  const double distance = std::sqrt(hazard.is_disc ? from.squaredNorm() : distance2(from, to, Vec2::Zero()));
  const double gap = distance - hazard.contact;
  if (gap > reach_ + velocity.norm() * outlook_.window + outlook_.margin) return;
  const double left = gap > 0.0 ? kept_of_lost * gap : gap;
  hazard.keep = squared(std::max(0.0, hazard.contact + std::min(outlook_.margin, left) - 1e-9));
  room_now_ = std::min(room_now_, left);
  hazards_[count_++] = hazard;
}

bool Foresight::is_kept(const Vec2& position, double time) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    const Hazard& hazard = hazards_[i];
    const Vec2 p = position - time * hazard.velocity;
    const double d2 = hazard.is_disc ? (p - hazard.from).squaredNorm() : distance2(hazard.from, hazard.to, p);
    if (d2 < hazard.keep) return false;
  }
  return true;
}

Vec2 Foresight::heading_for(const Plan& plan) const noexcept {
  if (!(plan.speed > 0.0)) return plan.direction;
  const double across = cross(plan.direction, outlook_.drift) / plan.speed;
  const double sine = -std::clamp(across, -most_crab_sine, most_crab_sine);
  const double cosine = std::sqrt(1.0 - sine * sine);
  const Vec2& d = plan.direction;
  return {cosine * d.x() - sine * d.y(), sine * d.x() + cosine * d.y()};
}

TurnOrder Foresight::order(const Plan& plan) const noexcept {
  if (plan.turn_rate) return {plan.speed, *plan.turn_rate};
  return law_.order(plan.speed, error_of(now_.ahead, heading_for(plan)), now_.speed);
}

void Foresight::advance(Motion& m, const TurnOrder& order) const noexcept {
  const Envelope& can = law_.envelope();
  const double rate = m.turn_rate, speed = m.speed;
  m.turn_rate = towards(rate, order.turn_rate, turn_share_, -most_turn_, most_turn_);
  m.speed = towards(speed, order.surge, surge_share_, -most_slower_, most_faster_);

  // half the turn, the way, the other half
  const double half = 0.25 * step_ * (rate + m.turn_rate);
  const double sine = half * (1.0 - half * half / 6.0), cosine = 1.0 - 0.5 * half * half;
  const auto turn = [&] {
    m.ahead = Vec2{cosine * m.ahead.x() - sine * m.ahead.y(), sine * m.ahead.x() + cosine * m.ahead.y()};
    m.ahead *= 1.5 - 0.5 * m.ahead.squaredNorm();
  };
  turn();
  m.sway += sway_share_ * (can.steady_sway(m.speed, m.turn_rate) - m.sway);
  const Vec2 starboard = starboard_of(m.ahead);
  m.position +=
      step_ * (0.5 * (speed + m.speed) * m.ahead + (outlook_.drift.dot(starboard) + m.sway) * starboard);
  turn();
}

void Foresight::follow(Motion& m, const Plan& plan, const Vec2& heading) const noexcept {
  if (plan.turn_rate) return advance(m, {plan.speed, *plan.turn_rate});
  const double before = m.turn_rate;
  advance(m, {law_.surge(plan.speed, m.ahead.dot(heading)), law_.turn_rate(m.error, m.speed)});
  m.error -= 0.5 * step_ * (before + m.turn_rate);
}

bool Foresight::stops(Motion m) const noexcept {
  const Plan backup = standing_still(m.ahead, outlook_.drift);
  m.error = error_of(m.ahead, backup.direction);
  for (std::size_t k = hold_steps_; k < steps; ++k) {
    follow(m, backup, backup.direction);
    if (!is_kept(m.position, static_cast<double>(k + 1) * step_)) return false;
  }
  return true;
}

bool Foresight::circles(Motion m, double turn_rate) const noexcept {
  for (std::size_t k = hold_steps_; k < steps; ++k) {
    advance(m, {m.speed, turn_rate});
    if (!is_kept(m.position, static_cast<double>(k + 1) * step_)) return false;
  }
  return true;
}

Prospect Foresight::of(const Plan& plan, bool seeks_backup) const noexcept {
  const Vec2 heading = heading_for(plan);
  Motion m = now_, held = now_;
  m.error = error_of(m.ahead, heading);
  std::size_t k = 0;
  for (; k < steps; ++k) {
    if (k == hold_steps_) held = m;
    follow(m, plan, heading);
    if (!is_kept(m.position, static_cast<double>(k + 1) * step_)) break;
  }
  if (k == steps) return Prospect::clear;
  if (k < hold_steps_ || !seeks_backup) return Prospect::lost;
  const double hard_over = law_.greatest_turn_rate(held.speed);
  const bool has_backup =
      law_.envelope().least <= 0.0 ? stops(held) : circles(held, hard_over) || circles(held, -hard_over);
  return has_backup ? Prospect::backed_up : Prospect::lost;
}

double Foresight::room_of(const Plan& plan, double too_little) const noexcept {
  const Vec2 heading = heading_for(plan);
  Motion m = now_;
  m.error = error_of(m.ahead, heading);
  double room = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < steps && !(room <= too_little); ++k) {
    follow(m, plan, heading);
    for (std::size_t i = 0; i < count_; ++i) {
      const Hazard& hazard = hazards_[i];
      const Vec2 p = m.position - static_cast<double>(k + 1) * step_ * hazard.velocity;
      const double d2 =
          hazard.is_disc ? (p - hazard.from).squaredNorm() : distance2(hazard.from, hazard.to, p);
      if (d2 > least_rounding * squared(std::max(0.0, room + hazard.contact))) continue;
      room = std::min(room, std::sqrt(d2) - hazard.contact);
    }
  }
  return room;
}

std::array<Vec2, Foresight::steps> Foresight::path(const Plan& plan) const noexcept {
  std::array<Vec2, steps> points;
  const Vec2 heading = heading_for(plan);
  Motion m = now_;
  m.error = error_of(m.ahead, heading);
  for (Vec2& point : points) {
    follow(m, plan, heading);
    point = m.position;
  }
  return points;
}

}  // namespace fairway::trackable
