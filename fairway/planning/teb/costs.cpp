// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/teb/costs.hpp"

#include "fairway/core/angles.hpp"

namespace fairway::teb {
namespace {

constexpr double steepness = 100.0;  // of the sign of a velocity

/// The difference of two headings in [-pi, pi].
double turn(double from, double to) {
  const double difference = to - from;
  return std::abs(difference) <= pi ? difference : wrap_angle(difference);
}

}  // namespace

Twist motion_between(const double* x, const math::SinCos& heading) {
  const auto [s, c] = heading;
  Twist m{.way = {x[4] - x[0], x[5] - x[1]}, .ahead = {c, s}, .time = x[3]};
  m.length = m.way.norm();
  const double along = c * m.way.x() + s * m.way.y();
  m.softened = 1.0 + steepness * std::abs(along);
  m.sign = steepness * along / m.softened;
  m.speed = m.length * m.sign / m.time;
  m.yaw_rate = turn(x[2], x[6]) / m.time;
  return m;
}

Twist::Slope Twist::speed_slope() const {
  constexpr double tiny = 1e-12;
  const double sign_slope = steepness / (softened * softened);
  const double abeam =
      ahead.x() * way.y() - ahead.y() * way.x();  // derivative of the way ahead by the heading
  const Vec2 along = length > tiny ? Vec2{way / length} : Vec2{Vec2::Zero()};
  const Vec2 by_position = (sign * along + length * sign_slope * ahead) / time;
  return Slope{{-by_position.x(), -by_position.y(), length * sign_slope * abeam / time, -speed / time,
                by_position.x(), by_position.y(), 0.0}};
}

Twist::Slope Twist::yaw_rate_slope() const {
  return Slope{{0.0, 0.0, -1.0 / time, -yaw_rate / time, 0.0, 0.0, 1.0 / time}};
}

Excess excess(double value, double lo, double hi, double margin) {
  if (value < lo + margin) return {lo + margin - value, -1.0};
  if (value <= hi - margin) return {};
  return {value - (hi - margin), 1.0};
}

}  // namespace fairway::teb
