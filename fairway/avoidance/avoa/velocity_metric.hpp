// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "fairway/avoidance/avoa/velocity_grid.hpp"
#include "fairway/core/math.hpp"

namespace fairway::avoa {

/// The multicriteria metric h (campos2019, eqs. 6-8): how bad a velocity is, in [0, 1]. The paper names the
/// three errors and says that they are normalised; that they are so by v_max and by pi is ours. Where
/// somebody foresees what the vehicle makes of a velocity, one that leads away from the desired one, by more
/// than a right angle, differs in speed by as much as it leads away besides, and may cost more than 1.
class VelocityMetric {
 public:
  /// Weights psi are >= 0 and scaled to the sum 1; all zero, every velocity is as good as any. `max_speed` >
  /// 0.
  VelocityMetric(const PolarVelocity& desired, double max_speed, double speed_weight, double heading_weight,
                 double danger_weight, bool is_foreseen = false)
      : desired_{desired}, is_foreseen_{is_foreseen} {
    const double sum = speed_weight + heading_weight + danger_weight;
    const double scale = sum > 0.0 ? 1.0 / sum : 0.0;
    per_speed_ = scale * speed_weight / max_speed;
    per_heading_ = scale * heading_weight / pi;
    per_danger_ = scale * danger_weight;
  }

  /// psi_v |v_d - v| / v_max + psi_theta |theta_d - theta| / pi + psi_danger nabla.
  double operator()(const PolarVelocity& v, double danger) const {
    const double turn = std::abs(wrapped(desired_.heading - v.heading));
    double slower = std::abs(desired_.speed - v.speed);
    if (is_foreseen_ && turn > 0.5 * pi) slower -= v.speed * math::cos(turn);
    return per_speed_ * slower + per_heading_ * turn + per_danger_ * danger;
  }

  const PolarVelocity& desired() const { return desired_; }

 private:
  PolarVelocity desired_;
  bool is_foreseen_;
  double per_speed_;
  double per_heading_;
  double per_danger_;
};

/// nabla, the cost of danger: 1 in a protective zone, falling with the distance to the nearest one, to 0 at
/// `threshold`. Both in m/s; the threshold may be 0.
inline double cost_of_danger(double distance, double threshold) {
  return distance < threshold ? 1.0 - distance / threshold : 0.0;
}

}  // namespace fairway::avoa
