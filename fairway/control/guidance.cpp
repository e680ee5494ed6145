// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/guidance.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

constexpr double hold_gain = 0.3;     // [1/s], position: slower than any vehicle's velocity loop
constexpr double hold_speed = 0.3;    // [m/s]
constexpr double abeam_most = 2.0;    // [m], beyond it the bow is turned to the place held
constexpr double heading_gain = 0.3;  // [1/s]
constexpr double heading_rate = 0.2;  // [rad/s]

double limited(double value, double limit) { return std::clamp(value, -limit, limit); }

}  // namespace

Command go_to(const Leg& leg, const Ownship& own, double period) noexcept {
  const Vec3 error = leg.position - own.position;
  return {.velocity = math::fmin(leg.speed_mps, error.norm() / period) * unit(error)};
}

Command follow_section(const Leg& leg, const Ownship& own, double lookahead) noexcept {
  const Vec3 line = leg.position - leg.from;
  const double length = line.norm();
  const Vec3 along = unit(line);

  const double place = (own.position - leg.from).dot(along);
  const double done = std::clamp(place, 0.0, length);
  const Vec3 aim = leg.from + math::fmin(done + lookahead, length) * along;
  const double to_end = place < 0.0      ? (own.position - leg.from).norm()
                        : place > length ? (own.position - leg.position).norm()
                                         : math::fmin(done, length - done);
  const double speed = leg.speed_mps * std::clamp(to_end / lookahead, 0.2, 1.0);
  return {.velocity = speed * unit(aim - own.position)};
}

BodyRequest keep_position(const HoldPoint& hold, const Ownship& own) noexcept {
  const Vec3 error = hold.position - own.position;
  const double ahead = unit_at(own.yaw).dot(error.head<2>());
  return {.surge_mps = limited(hold_gain * ahead, hold_speed),
          .heave_mps = limited(hold_gain * error.z(), hold_speed),
          .yaw_rate_radps = limited(heading_gain * wrap_angle(hold.yaw - own.yaw), heading_rate)};
}

double holding_yaw(const HoldPoint& hold, const Ownship& own, const Vec3& current_n) noexcept {
  if (current_n.isZero(0.0)) return hold.yaw;
  const Vec2 error = (hold.position - own.position).head<2>();
  const double abeam = std::abs(cross(unit_at(own.yaw), error));
  return abeam > abeam_most + own.position_error() ? math::atan2(error.y(), error.x()) : hold.yaw;
}

Command circle(const HoldPoint& hold, double radius, double speed, const Ownship& own) noexcept {
  const Vec3 from = own.position - hold.position;
  const double outside = (horizontal_norm(from) - radius) / radius;
  const double course = math::atan2(from.y(), from.x()) + pi / 2 + math::atan(2.0 * outside);
  const Vec2 ahead = speed * unit_at(course);
  return {.velocity = {ahead.x(), ahead.y(), limited(-hold_gain * from.z(), hold_speed)}, .mode = Mode::hold};
}

}  // namespace fairway
