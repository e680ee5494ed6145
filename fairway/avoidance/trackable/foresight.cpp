// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/trackable/foresight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "fairway/avoidance/avoa_improved/capsule.hpp"
#include "fairway/core/math.hpp"

namespace fairway::trackable {
namespace {

constexpr double kept_of_lost = 0.9;   // of what is left of a margin
constexpr double least_lag = 0.02;     // [s]
constexpr double bounding = 1.001;     // beyond what directions of a length of nearly 1 add
constexpr double most_plateau = 0.99;  // more is all
constexpr double most_turn = 0.7;      // in a step, for directions to keep that length [rad]
constexpr double step_of_lag = 0.8;    // a step is no longer than that share of the lag of the turn rate
constexpr double most_sagitta = 0.02;  // of the arc of a step [m]
constexpr double most_graze = 0.1;     // of two hulls between the ends of a step, unseen [m]
constexpr double rounding = 1e-9;      // [m]
constexpr std::size_t kept_tracks = most_hazards - most_hazards / 4;

double squared(double x) { return x * x; }

}  // namespace

Foresight::Foresight(const TurnLaw& law, const Situation& s, const Vec2& ahead,
                     const Outlook& outlook) noexcept
    : law_{law},
      outlook_{outlook},
      own_radius_{s.own.radius},
      response_{.law = law.law(), .drift_north = outlook.drift.x(), .drift_east = outlook.drift.y()},
      room_now_{std::numeric_limits<double>::infinity()} {
  if (const double speed = outlook.drift.norm(); speed > least_drift) {
    response_.standing_north = -outlook.drift.x() / speed;
    response_.standing_east = -outlook.drift.y() / speed;
  }
  divide_window();
  const Envelope& can = law.envelope();
  const double step = response_.step;
  const auto share_of = [&](double lag) { return 1.0 - math::exp(-step / std::max(lag, least_lag)); };
  const bool has_plateau = can.turn_plateau < most_plateau;
  response_.turn_share = share_of(has_plateau ? can.turn_lag : can.turn_lag + can.turn_tail);
  if (has_plateau) {
    response_.plateau = can.turn_plateau;
    response_.tail_share = share_of(can.turn_tail / (1.0 - can.turn_plateau));
  }
  response_.surge_share = share_of(can.surge_lag);
  response_.most_turn = can.turn_acceleration * step;
  response_.most_faster = can.acceleration * step;
  response_.most_slower = can.deceleration * step;
  response_.lost_slower = can.deceleration_lost / can.turn_acceleration;
  response_.slip = can.slip(step);

  velocity_ = s.own.velocity.head<2>() - outlook.frame;
  now_ = {.ahead_north = ahead.x(),
          .ahead_east = ahead.y(),
          .turn_rate = s.own.yaw_rate,
          .speed = ahead.dot(velocity_),
          .sway = starboard_of(ahead).dot(velocity_ - outlook.drift)};
  const double fastest = std::max(std::min(law.envelope().ahead, s.limits.max_speed), std::abs(now_.speed));
  reach_ = fastest_way(fastest, response_.law.top_turn_rate) * outlook_.window;

  const Vec2 own = s.own.position.head<2>();
  const auto passes_over = [&](const Vec3& position, double radius, double climb) {
    const double below = position.z() - s.own.position.z();
    const double kept = radius + own_radius_ + outlook_.margin;
    const double beyond = std::abs(below) - kept;
    if (beyond > 0.0 && (position.head<2>() - own).norm() < kept + fastest * outlook_.hold) {
      const double spare =
          beyond - (unasked_climb * law.envelope().ahead + std::abs(climb)) * outlook_.window;
      double& most = below > 0.0 ? most_sinking_ : most_rising_;
      most = std::min(most, std::max(0.0, spare / (outlook_.window + outlook_.hold)));
    }
    return beyond > (outlook.climb + std::abs(climb)) * outlook_.window;
  };
  // tracks first, so that no number of corners hides a vessel
  for (const Track& track : s.tracks) {
    if (passes_over(track.position, track.radius, track.velocity.z())) continue;
    const Vec2 p = track.position.head<2>() - own;
    add(p, p, track.radius, track.velocity.head<2>());
  }
  places_.keep(kept_tracks);
  for (const Obstacle& obstacle : s.obstacles) {
    if (obstacle.kind == Obstacle::Kind::sphere && passes_over(obstacle.position, obstacle.radius, 0.0))
      continue;
    avoa_improved::for_each_solid(obstacle, [&](const avoa_improved::Capsule& solid) {
      add(solid.from - own, solid.to - own, solid.radius, Vec2::Zero());
    });
  }
}

/// Steps as long as the lag allows and the arcs of turns, and the hold is a whole number of them.
void Foresight::divide_window() noexcept {
  const Envelope& can = law_.envelope();
  const double turn = std::max(response_.law.top_turn_rate, 1e-3);
  const double longest = std::min({step_of_lag * std::max(can.turn_lag, least_lag), most_turn / turn,
                                   std::sqrt(8.0 * most_sagitta / (can.ahead * turn))});
  const double hold = std::min(outlook_.hold, outlook_.window);
  const double least = outlook_.window / static_cast<double>(most_steps);
  response_.step = std::max(hold / std::max(1.0, std::ceil(hold / longest - rounding)), least);
  const auto whole = [&](double time) {
    return static_cast<std::size_t>(std::ceil(time / response_.step - rounding));
  };
  steps_ = std::clamp<std::size_t>(whole(outlook_.window), 1, most_steps);
  hold_steps_ = std::clamp<std::size_t>(whole(hold), 1, steps_);
  outlook_.window = static_cast<double>(steps_) * response_.step;
}

void Foresight::add(const Vec2& from, const Vec2& to, double radius, const Vec2& velocity) noexcept {
  const Vec2 along = to - from;
  const Vec2 relative = velocity - outlook_.frame;
  const Hazard hazard{from.x(),     from.y(),     along.x(),           along.y(), along.squaredNorm(),
                      relative.x(), relative.y(), radius + own_radius_};
  const double distance = std::sqrt(distance2(hazard, 0.0, 0.0, 0.0));
  const double gap = distance - hazard.contact, speed = relative.norm();
  if (gap > reach_ + speed * outlook_.window + outlook_.margin) return;
  const double left = gap > 0.0 ? kept_of_lost * gap : gap;
  room_now_ = std::min(room_now_, left);
  const std::size_t at = places_.place_for(gap);
  if (at == most_hazards) return;
  hazards_[at] = hazard;
  distances_[at] = distance;
  left_[at] = hazard.contact + left;
  speeds_[at] = speed;
}

struct Foresight::Way {
  const Response& can;
  Plan plan;
  Heading<double> heading;
  Motion<double> m;

  Way(const Foresight& in, const Plan& p) : can{in.response_}, m{in.now_} { follow_from_here(p); }
  void follow_from_here(const Plan& p) {
    plan = p;
    heading = heading_for(can, p.direction.x(), p.direction.y(), p.speed);
    m.error = heading.error(m);
  }
  void advance() {
    if (plan.turn_rate)
      trackable::advance(can, plan.speed, *plan.turn_rate, m);
    else
      follow(can, heading, plan.speed, m);
  }
};

Plan Foresight::standing(const Vec2& ahead) const noexcept {
  const Vec2 up{response_.standing_north, response_.standing_east};
  return {.direction = up == Vec2::Zero() ? ahead : up};
}

Vec2 Foresight::bow(const Plan& plan) const noexcept {
  const Heading<double> heading = Way{*this, plan}.heading;
  return {heading.north, heading.east};
}

TurnOrder Foresight::order(const Plan& plan) const noexcept {
  if (plan.turn_rate) return {plan.speed, *plan.turn_rate};
  const Way way{*this, plan};
  const double along = now_.ahead_north * way.heading.north + now_.ahead_east * way.heading.east;
  const double surge = surge_order(response_.law, plan.speed, along);
  return {surge, turn_order_after(surge, response_.law, way.m)};
}

/// Speed and turn rate stay between what they are and what is ordered, and the sway between what it is and
/// what they come to.
double Foresight::fastest_way(double speed, double turn_rate) const noexcept {
  const Law& law = response_.law;
  const double along = std::max({std::abs(now_.speed), law.least, speed});
  const double slip = std::abs(law_.envelope().steady_sway(along, turn_rate));
  return bounding * (along + outlook_.drift.norm() + std::max(std::abs(now_.sway), slip));
}

/// Of two points that move by `way` against each other, straight and evenly, the nearest approach is nearer
/// than at the ends by no more than d'^2 = d^2 - (way / 2)^2; the arcs add their sagitta. Where that
/// is more than what is left now, and a step may lead farther into the other than a graze, the way within the
/// step is looked at: where the margin is there still and the step goes farther than that and both hulls, by
/// the margin, and else by what it would hit.
Foresight::Bounds Foresight::bounds(double speed, double turn_rate) const noexcept {
  const double step = response_.step;
  const double turn = std::max({std::abs(now_.turn_rate), response_.law.top_turn_rate, turn_rate});
  const bool is_bounded = step * turn < 2.0 * most_turn;
  const double fastest = is_bounded ? fastest_way(speed, turn) : std::numeric_limits<double>::infinity();
  const double sagitta = 0.125 * fastest * turn * squared(step);
  const double kept = outlook_.margin + sagitta;
  Bounds all;
  for (std::size_t i = 0; i < places_.count(); ++i) {
    const double way = step * (fastest + speeds_[i]);
    const double left = std::max(0.0, left_[i] - rounding);
    const double contact = hazards_[i].contact;
    all.near2[i] = std::min(squared(contact + kept) + squared(0.5 * way), squared(left));
    all.within2[i] = 0.0;
    const double gap = distances_[i] - contact;
    const auto leads_deep = [&] {
      return squared(0.5 * way) > squared(contact) - squared(std::max(0.0, contact - most_graze));
    };
    if (all.near2[i] == squared(left) && gap > 0.0 && leads_deep()) {
      const bool goes_past = gap > kept && way > contact + kept;
      const double least = contact + std::min(goes_past ? kept : sagitta, kept_of_lost * gap);
      if (squared(left) < squared(least) + squared(0.5 * way)) {
        all.within2[i] = squared(least);
        all.any_within = true;
      }
    }
    const double whole = (distances_[i] - std::sqrt(all.near2[i])) / (bounding * way);
    all.first_steps[i] =
        whole > 0.0 ? static_cast<std::size_t>(std::min(whole, static_cast<double>(most_steps))) : 0;
  }
  return all;
}

bool Foresight::goes_along(std::size_t hazard) const noexcept {
  const Vec2 of_hazard{hazards_[hazard].velocity_north, hazards_[hazard].velocity_east};
  const double speed = speeds_[hazard];
  return speed > outlook_.drift.norm() && (of_hazard - velocity_).norm() < speed;
}

bool Foresight::all_stand() const noexcept {
  return std::ranges::all_of(std::span{speeds_}.first(places_.count()),
                             [](double speed) { return speed <= least_drift; });
}

Foresight::Bounds Foresight::without_what_goes_along(Bounds all) const noexcept {
  for (std::size_t i = 0; i < places_.count(); ++i)
    if (goes_along(i)) all.first_steps[i] = most_steps;
  return all;
}

bool Foresight::needs_backup() const noexcept {
  if (!outlook_.is_set_aside) return false;
  for (std::size_t i = 0; i < places_.count(); ++i)
    if (!goes_along(i)) return true;
  return false;
}

bool Foresight::is_clear(const Plan& plan, double quickest, std::size_t stops_after) const noexcept {
  return clear_steps(plan, bounds(quickest, std::abs(plan.turn_rate.value_or(0.0))), stops_after) == steps_;
}

std::size_t Foresight::clear_steps(const Plan& plan, double quickest) const noexcept {
  return clear_steps(plan, bounds(quickest, std::abs(plan.turn_rate.value_or(0.0))), most_steps);
}

bool Foresight::is_safe(const Plan& plan) const noexcept {
  const Bounds of = bounds(std::abs(plan.speed), std::abs(plan.turn_rate.value_or(0.0)));
  if (clear_steps(plan, of, most_steps) < steps_) return false;
  return !needs_backup() || clear_steps(plan, without_what_goes_along(of), hold_steps_) == steps_;
}

std::size_t Foresight::clear_steps(const Plan& plan, const Bounds& of,
                                   std::size_t stops_after) const noexcept {
  Way way{*this, plan};
  const std::size_t count = places_.count();
  for (std::size_t k = 0; k < steps_; ++k) {
    if (k == stops_after) way.follow_from_here(standing({way.m.ahead_north, way.m.ahead_east}));
    const double before_north = way.m.north, before_east = way.m.east;
    way.advance();
    const double before = static_cast<double>(k) * response_.step;
    const double time = static_cast<double>(k + 1) * response_.step;
    for (std::size_t i = 0; i < count; ++i) {
      if (k < of.first_steps[i]) continue;
      if (distance2(hazards_[i], time, way.m.north, way.m.east) < of.near2[i]) return k;
      if (of.within2[i] > 0.0 && distance2_within(hazards_[i], before, before_north, before_east, time,
                                                  way.m.north, way.m.east) < of.within2[i])
        return k;
    }
  }
  return steps_;
}

Foresight::Room Foresight::room_of(const Plan& plan) const noexcept {
  const Bounds of = bounds(std::abs(plan.speed), std::abs(plan.turn_rate.value_or(0.0)));
  const std::size_t count = places_.count();
  Way way{*this, plan};
  std::array<double, most_hazards> least2;
  least2.fill(std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < steps_; ++k) {
    const double before_north = way.m.north, before_east = way.m.east;
    way.advance();
    const double before = static_cast<double>(k) * response_.step;
    const double time = static_cast<double>(k + 1) * response_.step;
    for (std::size_t i = 0; i < count; ++i) {
      least2[i] = std::min(least2[i], distance2(hazards_[i], time, way.m.north, way.m.east));
      if (!(of.within2[i] > 0.0)) continue;
      const double within2 =
          distance2_within(hazards_[i], before, before_north, before_east, time, way.m.north, way.m.east);
      if (within2 < of.within2[i]) least2[i] = std::min(least2[i], within2);
    }
  }
  const double end = static_cast<double>(steps_) * response_.step;
  Room room{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < count; ++i) {
    const double last = std::sqrt(distance2(hazards_[i], end, way.m.north, way.m.east));
    room.least = std::min(room.least, std::sqrt(least2[i]) - hazards_[i].contact);
    room.last = std::min(room.last, last - hazards_[i].contact);
  }
  return room;
}

Foresight::Path Foresight::path(const Plan& plan) const noexcept {
  Path path;
  path.count = steps_;
  Way way{*this, plan};
  for (std::size_t k = 0; k < steps_; ++k) {
    way.advance();
    const double time = static_cast<double>(k + 1) * response_.step;
    path.points[k] = Vec2{way.m.north, way.m.east} + time * outlook_.frame;
  }
  return path;
}

}  // namespace fairway::trackable
