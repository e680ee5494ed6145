// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "fairway/planning/teb/band_obstacle.hpp"
#include "fairway/planning/teb/teb_params.hpp"

namespace fairway::teb {

/// The weighted residuals of one cost, so that its square is what it adds to the sum, and their derivatives
/// by a window of consecutive variables of the band: (x, y, heading, time) of one knot after the other.
template <int Rows, int Width>
struct Residual {
  static constexpr int rows = Rows, width = Width;
  Eigen::Matrix<double, Rows, 1> value;
  Eigen::Matrix<double, Rows, Width> slope;
};

/// Velocity along the heading and yaw rate from one pose to the next, and their derivatives by the two poses
/// and the time between, of which the window (x1, y1, heading1, time, x2, y2, heading2) consists. The sign of
/// the velocity is that of the way along the first heading, smoothed: |way| / time * sigmoid(100 way .
/// heading1), sigmoid(a) = a / (1 + |a|).
struct Twist {
  double speed{};     ///< [m/s]
  double yaw_rate{};  ///< [rad/s]
  Eigen::Matrix<double, 1, 7> speed_slope, yaw_rate_slope;
};
Twist motion_between(const double* x);

/// How far `value` is outside [lo + margin, hi - margin], positive, and the sign of its derivative.
struct Excess {
  double value{};
  double sign{};
};
Excess excess(double value, double lo, double hi, double margin);

// Every cost is called with the first variable of its window. Roesmann et al. 2012, eqs. (9) to (13), and
// 2013.

/// Speed ahead and astern, and yaw rate, beyond their limits. On two poses.
struct VelocityCost {
  using Output = Residual<2, 7>;
  const TebParams& params;
  void operator()(const double* x, Output& out) const;
};

/// Acceleration along the heading and about the vertical beyond their limits. On three poses.
struct AccelerationCost {
  using Output = Residual<2, 11>;
  const TebParams& params;
  void operator()(const double* x, Output& out) const;
};

/// Likewise from the present velocity into the first interval, or out of the last to a standstill. On two
/// poses.
struct EndAccelerationCost {
  using Output = Residual<2, 7>;
  const TebParams& params;
  double speed{};     ///< before the first interval, or after the last [m/s]
  double yaw_rate{};  ///< [rad/s]
  bool at_end{};
  void operator()(const double* x, Output& out) const;
};

/// Both poses on one circle, and ahead. On two poses.
struct KinematicsCost {
  using Output = Residual<2, 7>;
  const TebParams& params;
  void operator()(const double* x, Output& out) const;
};

/// The time to the next knot. On that alone.
struct TimeCost {
  using Output = Residual<1, 1>;
  const TebParams& params;
  void operator()(const double* x, Output& out) const;
};

/// Too near a barrier: the least distance, and the inflation around it. On a position.
struct BarrierCost {
  using Output = Residual<2, 2>;
  const TebParams& params;
  const BandObstacle& barrier;
  double time{};    ///< of the pose from now, for what moves [s]
  double weight{};  ///< of the least distance
  void operator()(const double* x, Output& out) const;
};

}  // namespace fairway::teb
