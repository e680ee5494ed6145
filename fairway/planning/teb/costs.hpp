// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/planning/teb/band_obstacle.hpp"
#include "fairway/planning/teb/teb_params.hpp"

namespace fairway::teb {

/// The weighted residuals of one cost, so that its square is what it adds to the sum.
template <int Rows>
struct Values {
  static constexpr bool has_slope = false;
  Eigen::Matrix<double, Rows, 1> value;
};

/// The same with their derivatives by a window of consecutive variables of the band: (x, y, heading, time) of
/// one knot after the other.
template <int Rows, int Width>
struct Residual {
  static constexpr bool has_slope = true;
  Eigen::Matrix<double, Rows, 1> value;
  Eigen::Matrix<double, Rows, Width> slope;
};

/// Velocity along the heading and yaw rate from one pose to the next. The sign of the velocity is that of the
/// way along the first heading, smoothed: |way| / time * sigmoid(100 way . heading1), sigmoid(a) = a / (1 +
/// |a|). Derivatives are by the window (x1, y1, heading1, time, x2, y2, heading2).
struct Twist {
  using Slope = Eigen::Matrix<double, 1, 7>;

  double speed{};     ///< [m/s]
  double yaw_rate{};  ///< [rad/s]
  Vec2 way = Vec2::Zero();
  Vec2 ahead = Vec2::Zero();  ///< the first heading
  double length{};            ///< of the way [m]
  double time{};              ///< [s]
  double sign{};              ///< of the velocity, smoothed
  double softened{1.0};

  Slope speed_slope() const;
  Slope yaw_rate_slope() const;
};
/// `heading` has sine and cosine of x[2], the first heading.
Twist motion_between(const double* x, const math::SinCos& heading);
inline Twist motion_between(const double* x) { return motion_between(x, math::sin_cos(x[2])); }

/// How far `value` is outside [lo + margin, hi - margin], positive, and the sign of its derivative.
struct Excess {
  double value{};
  double sign{};
};
Excess excess(double value, double lo, double hi, double margin);

/// A weighted penalty for what is outside its limits as row `row`; `slope_of()` is the derivative of that.
template <class Output, class SlopeOf>
void penalise(Output& out, int row, double weight, const Excess& over, const SlopeOf& slope_of) {
  if (over.value == 0.0) {
    out.value[row] = 0.0;
    if constexpr (Output::has_slope) out.slope.row(row).setZero();
    return;
  }
  const double root = std::sqrt(weight);
  out.value[row] = root * over.value;
  if constexpr (Output::has_slope) out.slope.row(row) = (root * over.sign) * slope_of();
}

// Each cost has what it is about, and is called for its values, or for values and derivatives by its window.
// Roesmann et al. 2012, eqs. (9) to (13), and 2013.

/// Speed ahead and astern, and yaw rate, beyond their limits. On two poses.
struct VelocityCost {
  static constexpr int rows = 2, width = 7;
  const TebParams& params;
  const Twist& motion;

  template <class Output>
  void operator()(Output& out) const {
    const double margin = params.penalty_epsilon_ratio;
    penalise(out, 0, params.weight_max_vel_x_ratio,
             excess(motion.speed, -params.max_vel_x_backwards_mps, params.max_vel_x_mps, margin),
             [&] { return motion.speed_slope(); });
    penalise(out, 1, params.weight_max_vel_theta_ratio,
             excess(motion.yaw_rate, -params.max_vel_theta_radps, params.max_vel_theta_radps, margin),
             [&] { return motion.yaw_rate_slope(); });
  }
};

/// Acceleration along the heading and about the vertical beyond their limits. On three poses.
struct AccelerationCost {
  static constexpr int rows = 2, width = 11;
  const TebParams& params;
  const Twist& before;
  const Twist& after;

  template <class Output>
  void operator()(Output& out) const {
    // the change over the time from the middle of one interval to that of the next
    const double time = 0.5 * (before.time + after.time);
    const double margin = params.penalty_epsilon_ratio;
    const auto slope_of = [&](double rate, const Twist::Slope& from, const Twist::Slope& to) {
      Eigen::Matrix<double, 1, 11> slope = Eigen::Matrix<double, 1, 11>::Zero();
      slope.head<7>() -= from / time;
      slope.tail<7>() += to / time;
      slope[3] -= 0.5 * rate / time;
      slope[7] -= 0.5 * rate / time;
      return slope;
    };
    const double ahead = (after.speed - before.speed) / time;
    penalise(out, 0, params.weight_acc_lim_x_ratio,
             excess(ahead, -params.acc_lim_x_mps2, params.acc_lim_x_mps2, margin),
             [&] { return slope_of(ahead, before.speed_slope(), after.speed_slope()); });
    const double yaw = (after.yaw_rate - before.yaw_rate) / time;
    penalise(out, 1, params.weight_acc_lim_theta_ratio,
             excess(yaw, -params.acc_lim_theta_radps2, params.acc_lim_theta_radps2, margin),
             [&] { return slope_of(yaw, before.yaw_rate_slope(), after.yaw_rate_slope()); });
  }
};

/// Likewise from the present velocity into the first interval, or out of the last to a standstill. On two
/// poses.
struct EndAccelerationCost {
  static constexpr int rows = 2, width = 7;
  const TebParams& params;
  const Twist& motion;
  double speed{};     ///< before the first interval, or after the last [m/s]
  double yaw_rate{};  ///< [rad/s]
  bool at_end{};

  template <class Output>
  void operator()(Output& out) const {
    const double time = motion.time;
    const double margin = params.penalty_epsilon_ratio;
    const double direction = at_end ? -1.0 : 1.0;
    const auto slope_of = [&](double change, Twist::Slope slope) {
      slope *= direction / time;
      slope[3] -= change / time;
      return slope;
    };
    const double ahead = direction * (motion.speed - speed) / time;
    penalise(out, 0, params.weight_acc_lim_x_ratio,
             excess(ahead, -params.acc_lim_x_mps2, params.acc_lim_x_mps2, margin),
             [&] { return slope_of(ahead, motion.speed_slope()); });
    const double yaw = direction * (motion.yaw_rate - yaw_rate) / time;
    penalise(out, 1, params.weight_acc_lim_theta_ratio,
             excess(yaw, -params.acc_lim_theta_radps2, params.acc_lim_theta_radps2, margin),
             [&] { return slope_of(yaw, motion.yaw_rate_slope()); });
  }
};

/// Both poses on one circle, and ahead. On two poses.
struct KinematicsCost {
  static constexpr int rows = 2, width = 7;
  const TebParams& params;
  Vec2 way = Vec2::Zero();
  math::SinCos first{};  ///< of the headings
  math::SinCos second{};

  template <class Output>
  void operator()(Output& out) const {
    const auto [s1, c1] = first;
    const auto [s2, c2] = second;
    const double root = std::sqrt(params.weight_kinematics_nh_ratio);
    out.value[0] = root * ((c1 + c2) * way.y() - (s1 + s2) * way.x());
    if constexpr (Output::has_slope) {
      out.slope.row(0) << s1 + s2, -(c1 + c2), -s1 * way.y() - c1 * way.x(), 0.0, -(s1 + s2), c1 + c2,
          -s2 * way.y() - c2 * way.x();
      out.slope.row(0) *= root;
    }
    const double ahead = c1 * way.x() + s1 * way.y();
    const Excess astern = ahead < 0.0 ? Excess{-ahead, -1.0} : Excess{};
    penalise(out, 1, params.weight_kinematics_forward_drive_ratio, astern, [&] {
      return Twist::Slope{{-c1, -s1, c1 * way.y() - s1 * way.x(), 0.0, c1, s1, 0.0}};
    });
  }
};

/// The time to the next knot. On that alone.
struct TimeCost {
  static constexpr int rows = 1, width = 1;
  const TebParams& params;
  double time{};  ///< [s]

  template <class Output>
  void operator()(Output& out) const {
    const double root = std::sqrt(params.weight_optimaltime_ratio);
    out.value[0] = root * time;
    if constexpr (Output::has_slope) out.slope(0, 0) = root;
  }
};

/// Too near a barrier: the least distance, and the inflation around it. On a position.
struct BarrierCost {
  static constexpr int rows = 2, width = 2;
  const TebParams& params;
  const BandObstacle& barrier;
  Vec2 position = Vec2::Zero();
  double time{};    ///< of the pose from now, for what moves [s]
  double weight{};  ///< of the least distance

  template <class Output>
  void operator()(Output& out) const {
    const Separation apart = barrier.from(position, time);
    const bool moves = barrier.moves();
    const double inflation = moves ? params.dynamic_obstacle_inflation_dist_m : params.inflation_dist_m;
    const double inflation_weight =
        moves ? params.weight_dynamic_obstacle_inflation_ratio : params.weight_inflation_ratio;
    const auto below = [&](double least) {
      return apart.distance < least ? Excess{least - apart.distance, -1.0} : Excess{};
    };
    const auto slope_of = [&] { return Eigen::RowVector2d{apart.outward.transpose()}; };
    penalise(out, 0, weight, below(params.min_obstacle_dist_m + params.penalty_epsilon_ratio), slope_of);
    penalise(out, 1, inflation_weight, below(inflation), slope_of);
  }
};

}  // namespace fairway::teb
