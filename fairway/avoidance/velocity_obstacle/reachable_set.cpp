// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/reachable_set.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/avoidance/ability.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::velocity_obstacle {

ReachableSet::ReachableSet(const Ownship& own, const Limits& limits, double interval) noexcept
    : bow_{unit_at(own.yaw)},
      max_speed_{limits.max_speed},
      min_speed_{std::min(limits.min_speed, limits.max_speed)},
      max_change_{limits.max_acceleration * interval},
      turns_freely_{limits.max_turn_rate * interval >= pi},
      only_ahead_{only_goes_ahead(limits)},
      middle_{own.velocity.head<2>()} {
  if (!turns_freely_) {
    turn_cosine_ = math::cos(limits.max_turn_rate * interval);
    turn_sine_ = math::sin(limits.max_turn_rate * interval);
  }

  // off the courses that it may take: the nearer of the outermost two, or no way at all
  if (!is_within_turn(middle_, 0.0)) {
    const Vec2 ray = turned(bow_, turn_cosine_, cross(bow_, middle_) < 0.0 ? -turn_sine_ : turn_sine_);
    middle_ = std::max(middle_.dot(ray), 0.0) * ray;
  }
  const double speed = middle_.norm();
  if (speed > max_speed_) middle_ *= max_speed_ / speed;
  if (!makes_way(middle_, 0.0)) {
    const double ahead = middle_.dot(bow_);
    const bool keeps_course = speed > 0.0 && (!only_ahead_ || ahead >= 0.0);
    middle_ = min_speed_ * (keeps_course ? Vec2{middle_ / speed} : bow_);
  }
}

bool ReachableSet::makes_way(const Vec2& v, double slack) const noexcept {
  return v.norm() >= min_speed_ - slack && (!only_ahead_ || v.dot(bow_) >= -slack);
}

bool ReachableSet::is_within_turn(const Vec2& v, double slack) const noexcept {
  if (turns_freely_) return true;
  const double ahead = v.dot(bow_);
  const double outside = std::fabs(cross(bow_, v)) * turn_cosine_ - ahead * turn_sine_;
  return outside <= slack && (turn_cosine_ < 0.0 || ahead >= -slack);
}

bool ReachableSet::contains(const Vec2& v, double slack) const noexcept {
  return v.norm() <= max_speed_ + slack && (v - middle_).norm() <= max_change_ + slack &&
         is_within_turn(v, slack) && makes_way(v, slack);
}

Stretch ReachableSet::stretch(const Boundary& line, double slack) const noexcept {
  Stretch stretch;
  if (max_speed_ < Limits::none) stretch.keep_disc(line, Vec2::Zero(), max_speed_ + slack);
  if (max_change_ < Limits::none) stretch.keep_disc(line, middle_, max_change_ + slack);
  if (!turns_freely_ && turn_cosine_ >= 0.0) {
    // between the rays of the turn
    const Vec2 to_port = starboard_of(turned(bow_, turn_cosine_, -turn_sine_));
    const Vec2 to_starboard = -starboard_of(turned(bow_, turn_cosine_, turn_sine_));
    stretch.keep_positive(line.point.dot(to_port) + slack, line.direction.dot(to_port));
    stretch.keep_positive(line.point.dot(to_starboard) + slack, line.direction.dot(to_starboard));
  }
  if (only_ahead_) stretch.keep_positive(line.point.dot(bow_) + slack, line.direction.dot(bow_));
  return stretch;
}

std::size_t ReachableSet::boundaries(std::span<Boundary, max_boundaries> out) const noexcept {
  std::size_t count = 0;
  if (max_speed_ < Limits::none) out[count++] = Boundary::circle(Vec2::Zero(), max_speed_);
  if (max_change_ < Limits::none) out[count++] = Boundary::circle(middle_, max_change_);
  if (!turns_freely_) {
    out[count++] = Boundary::line(Vec2::Zero(), turned(bow_, turn_cosine_, -turn_sine_));
    out[count++] = Boundary::line(Vec2::Zero(), turned(bow_, turn_cosine_, turn_sine_));
  }
  if (min_speed_ > 0.0) out[count++] = Boundary::circle(Vec2::Zero(), min_speed_);
  if (only_ahead_) out[count++] = Boundary::line(Vec2::Zero(), starboard_of(bow_));
  return count;
}

}  // namespace fairway::velocity_obstacle
