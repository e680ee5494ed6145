// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/teb/costs.hpp"

#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::teb {
namespace {

/// The difference of two headings in [-pi, pi].
double turn(double from, double to) {
  const double difference = to - from;
  return std::abs(difference) <= pi ? difference : wrap_angle(difference);
}

/// A weighted penalty for `value` outside its limits as row `row`; `slope` is the derivative of `value`.
template <class Output, class Slope>
void penalise(Output& out, int row, double weight, const Excess& over, const Slope& slope) {
  if (over.value == 0.0) {
    out.value[row] = 0.0;
    out.slope.row(row).setZero();
    return;
  }
  const double root = std::sqrt(weight);
  out.value[row] = root * over.value;
  out.slope.row(row) = (root * over.sign) * slope;
}

}  // namespace

Twist motion_between(const double* x) {
  constexpr double steepness = 100.0;
  constexpr double tiny = 1e-12;
  const Vec2 way{x[4] - x[0], x[5] - x[1]};
  const auto [s, c] = math::sin_cos(x[2]);
  const double time = x[3];
  const double length = way.norm();
  const double ahead = c * way.x() + s * way.y();
  const double abeam = c * way.y() - s * way.x();  // derivative of `ahead` by the heading
  const double softened = 1.0 + steepness * std::abs(ahead);
  const double sign = steepness * ahead / softened;
  const double sign_slope = steepness / (softened * softened);

  Twist m;
  m.speed = length * sign / time;
  const Vec2 along = length > tiny ? Vec2{way / length} : Vec2{Vec2::Zero()};
  const Vec2 by_position = (sign * along + length * sign_slope * Vec2{c, s}) / time;
  m.speed_slope << -by_position.x(), -by_position.y(), length * sign_slope * abeam / time, -m.speed / time,
      by_position.x(), by_position.y(), 0.0;
  m.yaw_rate = turn(x[2], x[6]) / time;
  m.yaw_rate_slope << 0.0, 0.0, -1.0 / time, -m.yaw_rate / time, 0.0, 0.0, 1.0 / time;
  return m;
}

Excess excess(double value, double lo, double hi, double margin) {
  if (value < lo + margin) return {lo + margin - value, -1.0};
  if (value <= hi - margin) return {};
  return {value - (hi - margin), 1.0};
}

void VelocityCost::operator()(const double* x, Output& out) const {
  const Twist m = motion_between(x);
  const double margin = params.penalty_epsilon_ratio;
  penalise(out, 0, params.weight_max_vel_x_ratio,
           excess(m.speed, -params.max_vel_x_backwards_mps, params.max_vel_x_mps, margin), m.speed_slope);
  penalise(out, 1, params.weight_max_vel_theta_ratio,
           excess(m.yaw_rate, -params.max_vel_theta_radps, params.max_vel_theta_radps, margin),
           m.yaw_rate_slope);
}

void AccelerationCost::operator()(const double* x, Output& out) const {
  const Twist before = motion_between(x), after = motion_between(x + 4);
  const double time = 0.5 * (x[3] + x[7]);
  const double margin = params.penalty_epsilon_ratio;
  using Slope = Eigen::Matrix<double, 1, 11>;

  // the change over the time from the middle of one interval to that of the next
  const auto rate = [&](double from, double to, const auto& from_slope, const auto& to_slope, Slope& slope) {
    const double value = (to - from) / time;
    slope.setZero();
    slope.template head<7>() -= from_slope / time;
    slope.template tail<7>() += to_slope / time;
    slope[3] -= 0.5 * value / time;
    slope[7] -= 0.5 * value / time;
    return value;
  };
  Slope slope;
  const double ahead = rate(before.speed, after.speed, before.speed_slope, after.speed_slope, slope);
  penalise(out, 0, params.weight_acc_lim_x_ratio,
           excess(ahead, -params.acc_lim_x_mps2, params.acc_lim_x_mps2, margin), slope);
  const double yaw =
      rate(before.yaw_rate, after.yaw_rate, before.yaw_rate_slope, after.yaw_rate_slope, slope);
  penalise(out, 1, params.weight_acc_lim_theta_ratio,
           excess(yaw, -params.acc_lim_theta_radps2, params.acc_lim_theta_radps2, margin), slope);
}

void EndAccelerationCost::operator()(const double* x, Output& out) const {
  const Twist m = motion_between(x);
  const double time = x[3];
  const double margin = params.penalty_epsilon_ratio;
  const double direction = at_end ? -1.0 : 1.0;

  const auto rate = [&](double value, double given, Eigen::Matrix<double, 1, 7>& slope) {
    const double change = direction * (value - given) / time;
    slope *= direction / time;
    slope[3] -= change / time;
    return change;
  };
  Eigen::Matrix<double, 1, 7> slope = m.speed_slope;
  const double ahead = rate(m.speed, speed, slope);
  penalise(out, 0, params.weight_acc_lim_x_ratio,
           excess(ahead, -params.acc_lim_x_mps2, params.acc_lim_x_mps2, margin), slope);
  slope = m.yaw_rate_slope;
  const double yaw = rate(m.yaw_rate, yaw_rate, slope);
  penalise(out, 1, params.weight_acc_lim_theta_ratio,
           excess(yaw, -params.acc_lim_theta_radps2, params.acc_lim_theta_radps2, margin), slope);
}

void KinematicsCost::operator()(const double* x, Output& out) const {
  const Vec2 way{x[4] - x[0], x[5] - x[1]};
  const auto [s1, c1] = math::sin_cos(x[2]);
  const auto [s2, c2] = math::sin_cos(x[6]);

  const double root = std::sqrt(params.weight_kinematics_nh_ratio);
  out.value[0] = root * ((c1 + c2) * way.y() - (s1 + s2) * way.x());
  out.slope.row(0) << s1 + s2, -(c1 + c2), -s1 * way.y() - c1 * way.x(), 0.0, -(s1 + s2), c1 + c2,
      -s2 * way.y() - c2 * way.x();
  out.slope.row(0) *= root;

  const double ahead = c1 * way.x() + s1 * way.y();
  Eigen::Matrix<double, 1, 7> slope;
  slope << -c1, -s1, c1 * way.y() - s1 * way.x(), 0.0, c1, s1, 0.0;
  const Excess astern = ahead < 0.0 ? Excess{-ahead, -1.0} : Excess{};
  penalise(out, 1, params.weight_kinematics_forward_drive_ratio, astern, slope);
}

void TimeCost::operator()(const double* x, Output& out) const {
  const double root = std::sqrt(params.weight_optimaltime_ratio);
  out.value[0] = root * x[0];
  out.slope(0, 0) = root;
}

void BarrierCost::operator()(const double* x, Output& out) const {
  const Separation apart = barrier.from({x[0], x[1]}, time);
  const bool moves = barrier.moves();
  const double inflation = moves ? params.dynamic_obstacle_inflation_dist_m : params.inflation_dist_m;
  const double inflation_weight =
      moves ? params.weight_dynamic_obstacle_inflation_ratio : params.weight_inflation_ratio;

  const auto below = [&](double least) {
    return apart.distance < least ? Excess{least - apart.distance, -1.0} : Excess{};
  };
  const Eigen::RowVector2d slope = apart.outward.transpose();
  penalise(out, 0, weight, below(params.min_obstacle_dist_m + params.penalty_epsilon_ratio), slope);
  penalise(out, 1, inflation_weight, below(inflation), slope);
}

}  // namespace fairway::teb
