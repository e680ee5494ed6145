// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "fairway/core/envelope.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/vec.hpp"

namespace fairway::trackable {

/// What is asked of a vehicle's autopilot.
struct TurnOrder {
  double surge;      ///< along the heading [m/s]
  double turn_rate;  ///< positive to starboard [rad/s]
};

/// The one law by which a velocity is followed, by any vehicle that turns in order to go elsewhere:
///
///     r = clamp(k theta, +-r_max(u)),  k = 0.4 / T_r       theta: from the heading to the course
///     u = |v| max(0, cos theta)^2, no less than the least speed
///
/// With the first-order lag T_r of the turn rate the gain makes theta'' + theta' / T_r + 0.4 theta / T_r^2 =
/// 0, a damping of 0.79. A share of the greatest turn rate is left to the autopilot.
class TurnLaw {
 public:
  /// `max_turn_rate` [rad/s] is that of the mission, or infinite.
  TurnLaw(const Envelope& envelope, double max_turn_rate) noexcept;

  /// Where a course needs `error` [rad] more to starboard, at `speed` [m/s] through the water.
  double turn_rate(double error, double speed) const noexcept {
    const double most = greatest_turn_rate(speed);
    return std::clamp(gain_ * error, -most, most);
  }

  /// Speed ahead [m/s], of the `wanted` one; `along` is the cosine of the angle by which the heading is off.
  double surge(double wanted, double along) const noexcept {
    const double share = std::max(0.0, along);
    return std::max(wanted * share * share, envelope_->least);
  }

  TurnOrder order(double wanted, double error, double speed) const noexcept {
    return {surge(wanted, math::cos(error)), turn_rate(error, speed)};
  }

  const Envelope& envelope() const noexcept { return *envelope_; }
  double greatest_turn_rate(double speed) const noexcept {
    return std::min(turn_share * envelope_->turn_rate(speed), max_turn_rate_);
  }

 private:
  static constexpr double turn_share = 0.9;  // of the greatest turn rate

  const Envelope* envelope_;
  double max_turn_rate_;
  double gain_;
};

}  // namespace fairway::trackable
