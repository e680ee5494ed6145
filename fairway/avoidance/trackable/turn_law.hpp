// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/trackable/roll.hpp"
#include "fairway/core/envelope.hpp"
#include "fairway/core/math.hpp"

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

  /// Of the `wanted` speed [m/s] on a course that needs `error` [rad] more to starboard, at `speed` [m/s]
  /// through the water. O(1).
  TurnOrder order(double wanted, double error, double speed) const noexcept {
    return {surge_order(law_, wanted, math::cos(error)), turn_order(law_, error, speed)};
  }

  const Envelope& envelope() const noexcept { return *envelope_; }
  const Law& law() const noexcept { return law_; }
  double greatest_turn_rate(double speed) const noexcept {
    return trackable::greatest_turn_rate(law_, speed);
  }

 private:
  const Envelope* envelope_;
  Law law_;
};

}  // namespace fairway::trackable
