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
constexpr double bounding = 1.001;      // beyond what directions of a length of nearly 1 add
constexpr double most_half_turn = 0.5;  // in a step, for directions to keep that length [rad]

double squared(double x) { return x * x; }

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
      response_{.law = law.law(),
                .step = outlook.window / steps,
                .pivot = law.envelope().pivot,
                .drift_north = outlook.drift.x(),
                .drift_east = outlook.drift.y()},
      hold_steps_{std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(outlook.hold / response_.step)),
                                          1, steps)},
      room_now_{std::numeric_limits<double>::infinity()} {
  const Envelope& can = law.envelope();
  const double step = response_.step;
  response_.turn_share = 1.0 - math::exp(-step / std::max(can.turn_lag, least_lag));
  response_.surge_share = 1.0 - math::exp(-step / std::max(can.surge_lag, least_lag));
  response_.sway_share = 1.0 - math::exp(-step / std::max(can.sway_lag, least_lag));
  response_.most_turn = can.turn_acceleration * step;
  response_.most_faster = can.acceleration * step;
  response_.most_slower = can.deceleration * step;

  const Vec2 ahead{math::cos(s.own.yaw), math::sin(s.own.yaw)}, velocity = s.own.velocity.head<2>();
  now_ = {.ahead_north = ahead.x(),
          .ahead_east = ahead.y(),
          .turn_rate = s.own.yaw_rate,
          .speed = ahead.dot(velocity),
          .sway = starboard_of(ahead).dot(velocity - outlook.drift)};
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
  const Vec2 along = to - from;
  const Hazard hazard{from.x(),     from.y(),     along.x(),           along.y(), along.squaredNorm(),
                      velocity.x(), velocity.y(), radius + own_radius_};
  const double distance = std::sqrt(distance2(hazard, 0.0, 0.0, 0.0));
  const double gap = distance - hazard.contact, speed = velocity.norm();
  if (gap > reach_ + speed * outlook_.window + outlook_.margin) return;
  const double left = gap > 0.0 ? kept_of_lost * gap : gap;
  room_now_ = std::min(room_now_, left);
  hazards_[count_] = hazard;
  keep2_[count_] = squared(std::max(0.0, hazard.contact + std::min(outlook_.margin, left) - 1e-9));
  spare_[count_] = gap - outlook_.margin;
  speeds_[count_++] = speed;
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
  return law_.order(plan.speed, start_of(heading_for(plan)).error, now_.speed);
}

Motion<double> Foresight::start_of(const Vec2& heading) const noexcept {
  Motion<double> m = now_;
  m.error = error_of({m.ahead_north, m.ahead_east}, heading);
  return m;
}

[[gnu::always_inline]] inline void Foresight::follow(Motion<double>& m, const Plan& plan,
                                                     const Vec2& heading) const noexcept {
  if (plan.turn_rate)
    advance(response_, plan.speed, *plan.turn_rate, m);
  else
    trackable::follow(response_, heading.x(), heading.y(), plan.speed, m);
}

/// Speed and turn rate stay between what they are and what is ordered, and the sway between what it is and
/// what they come to.
double Foresight::fastest_way(double speed, double turn_rate) const noexcept {
  const Law& law = response_.law;
  const double turn = std::max({std::abs(now_.turn_rate), law.top_turn_rate, turn_rate});
  if (!(0.5 * response_.step * turn < most_half_turn)) return std::numeric_limits<double>::infinity();
  const double along = std::max({std::abs(now_.speed), law.least, speed});
  const double slip = law.ahead > 0.0 ? std::abs(response_.pivot) * turn * along / law.ahead : 0.0;
  return bounding * (along + outlook_.drift.norm() + std::max(std::abs(now_.sway), slip));
}

std::size_t Foresight::first_step(std::size_t hazard, double fastest) const noexcept {
  const double whole = spare_[hazard] / (bounding * (fastest + speeds_[hazard]) * response_.step);
  return whole > 0.0 ? static_cast<std::size_t>(std::min(whole, static_cast<double>(steps))) : 0;
}

bool Foresight::is_clear(const Plan& plan) const noexcept {
  const double fastest = fastest_way(std::abs(plan.speed), std::abs(plan.turn_rate.value_or(0.0)));
  std::array<std::size_t, most_hazards> first_steps;
  for (std::size_t i = 0; i < count_; ++i) first_steps[i] = first_step(i, fastest);
  const Vec2 heading = heading_for(plan);
  Motion<double> m = start_of(heading);
  for (std::size_t k = 0; k < steps; ++k) {
    follow(m, plan, heading);
    const double time = static_cast<double>(k + 1) * response_.step;
    for (std::size_t i = 0; i < count_; ++i)
      if (k >= first_steps[i] && distance2(hazards_[i], time, m.north, m.east) < keep2_[i]) return false;
  }
  return true;
}

double Foresight::room_of(const Plan& plan) const noexcept {
  const Vec2 heading = heading_for(plan);
  Motion<double> m = start_of(heading);
  std::array<double, most_hazards> least2;
  least2.fill(std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < steps; ++k) {
    follow(m, plan, heading);
    const double time = static_cast<double>(k + 1) * response_.step;
    for (std::size_t i = 0; i < count_; ++i)
      least2[i] = std::min(least2[i], distance2(hazards_[i], time, m.north, m.east));
  }
  double room = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count_; ++i) room = std::min(room, std::sqrt(least2[i]) - hazards_[i].contact);
  return room;
}

std::array<Vec2, Foresight::steps> Foresight::path(const Plan& plan) const noexcept {
  std::array<Vec2, steps> points;
  const Vec2 heading = heading_for(plan);
  Motion<double> m = start_of(heading);
  for (Vec2& point : points) {
    follow(m, plan, heading);
    point = {m.north, m.east};
  }
  return points;
}

/// Lanes that there is no plan for repeat the last one.
struct Foresight::Search {
  struct Held {  // where a backup begins
    Motion<double> motion;
    std::size_t plan;
  };
  const Foresight& in;
  const lanes::Kernel& kernel;
  std::array<std::size_t, most_hazards> first_steps;
  std::array<double, most_plans> heading_north, heading_east, speed, error;
  std::array<Held, most_plans> held;
  std::size_t held_count = 0;

  explicit Search(const Foresight& foresight) : in{foresight}, kernel{lanes::kernel_for(lanes::most_lanes)} {}

  Fan fan_of(const double* near2) const {
    Fan fan;
    fan.response = &in.response_;
    fan.hazards = in.hazards_.data();
    fan.near2 = near2;
    fan.first_steps = first_steps.data();
    fan.hazard_count = in.count_;
    fan.hold_steps = in.hold_steps_;
    return fan;
  }

  static void put(Fan& fan, std::size_t lane, const Motion<double>& m) {
    std::size_t column = 0;
    for (const double value :
         {m.north, m.east, m.ahead_north, m.ahead_east, m.turn_rate, m.speed, m.sway, m.error})
      fan.motion[column++][lane] = value;
  }
  static Motion<double> held_at(const Fan& fan, std::size_t lane) {
    const auto of = [&](std::size_t column) { return fan.held[column][lane]; };
    return {of(0), of(1), of(2), of(3), of(4), of(5), of(6), of(7)};
  }

  /// The plans from `begin` on, as many as there are lanes.
  void start(Fan& fan, std::size_t begin, std::size_t count) const {
    for (std::size_t lane = 0; lane < kernel.lanes; ++lane) {
      const std::size_t i = std::min(begin + lane, count - 1);
      Motion<double> m = in.now_;
      m.error = error[i];
      put(fan, lane, m);
      fan.heading_north[lane] = heading_north[i];
      fan.heading_east[lane] = heading_east[i];
      fan.speed[lane] = speed[i];
    }
  }

  void take(std::size_t i, const Plan& plan) {
    const Vec2 heading = in.heading_for(plan);
    heading_north[i] = heading.x();
    heading_east[i] = heading.y();
    speed[i] = plan.speed;
    error[i] = error_of({in.now_.ahead_north, in.now_.ahead_east}, heading);
  }

  /// The first plan that is clear, or their number. Keeps in mind who may have a backup.
  std::size_t first_clear(std::span<const Plan> plans) {
    Fan fan = fan_of(in.keep2_.data());
    for (std::size_t begin = 0; begin < plans.size(); begin += kernel.lanes) {
      const std::size_t end = std::min(begin + kernel.lanes, plans.size());
      for (std::size_t i = begin; i < end; ++i) take(i, plans[i]);
      start(fan, begin, plans.size());
      kernel.roll(fan);
      for (std::size_t i = begin; i < end; ++i) {
        const auto clear = static_cast<std::size_t>(fan.clear_steps[i - begin]);
        if (clear == steps) return i;
        if (clear < in.hold_steps_) continue;
        held[held_count++] = {held_at(fan, i - begin), i};
      }
    }
    return plans.size();
  }

  /// To stop, the bow up into the drift, or to circle to the side of `side`.
  void start_backup(Fan& fan, std::size_t lane, Motion<double> m, double side) const {
    if (fan.circles) {
      fan.heading_north[lane] = side * in.law_.greatest_turn_rate(m.speed);
    } else {
      const Vec2 ahead{m.ahead_north, m.ahead_east};
      const Vec2 heading = standing_still(ahead, in.outlook_.drift).direction;
      m.error = error_of(ahead, heading);
      fan.heading_north[lane] = heading.x();
      fan.heading_east[lane] = heading.y();
      fan.speed[lane] = 0.0;
    }
    put(fan, lane, m);
  }

  /// The first plan that has a backup, or `none`.
  std::size_t first_backed_up(std::size_t none) const {
    Fan fan = fan_of(in.keep2_.data());
    fan.begin = in.hold_steps_;
    fan.circles = in.response_.law.least > 0.0;
    const std::size_t sides = fan.circles ? 2 : 1;
    for (std::size_t begin = 0; begin < sides * held_count; begin += kernel.lanes) {
      const std::size_t end = std::min(begin + kernel.lanes, sides * held_count);
      for (std::size_t lane = 0; lane < kernel.lanes; ++lane) {
        const std::size_t i = std::min(begin + lane, end - 1);
        start_backup(fan, lane, held[i / sides].motion, i % sides == 0 ? 1.0 : -1.0);
      }
      kernel.roll(fan);
      for (std::size_t i = begin; i < end; ++i)
        if (fan.clear_steps[i - begin] == static_cast<double>(steps)) return held[i / sides].plan;
    }
    return none;
  }

  /// The first plan that leaves most room, or their number if none leaves more than `most`.
  std::size_t roomiest(std::size_t count, double most) const {
    std::size_t best = count;
    std::array<double, most_hazards> near2;
    Fan fan = fan_of(near2.data());
    fan.asks_room = true;
    for (std::size_t begin = 0; begin < count; begin += kernel.lanes) {
      // who comes so near leaves no more, whatever is rounded
      for (std::size_t i = 0; i < in.count_; ++i) {
        const double contact = in.hazards_[i].contact;
        near2[i] = squared(std::max(0.0, most + contact - 1e-12 * (1.0 + contact + std::abs(most))));
      }
      start(fan, begin, count);
      kernel.roll(fan);
      for (std::size_t i = begin; i < std::min(begin + kernel.lanes, count); ++i) {
        if (fan.clear_steps[i - begin] < static_cast<double>(steps) || !(fan.room[i - begin] > most))
          continue;
        best = i;
        most = fan.room[i - begin];
      }
    }
    return best;
  }
};

Foresight::Pick Foresight::best_of(const Plan& asked, std::span<const Plan> plans) const noexcept {
  Search search{*this};
  double quickest = 0.0;
  for (const Plan& plan : plans) quickest = std::max(quickest, plan.speed);
  const double fastest = fastest_way(quickest, 0.0);
  for (std::size_t i = 0; i < count_; ++i) search.first_steps[i] = first_step(i, fastest);

  if (const std::size_t at = search.first_clear(plans); at < plans.size()) return {at, Prospect::clear};
  if (const std::size_t at = search.first_backed_up(plans.size()); at < plans.size())
    return {at, Prospect::backed_up};
  return {search.roomiest(plans.size(), room_of(asked)), Prospect::lost};
}

}  // namespace fairway::trackable
