// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/situation.hpp"
#include "fairway/planning/rrt_star/plan.hpp"

namespace fairway {

/// How a vehicle that must turn (trackable::must_turn()) follows the path of a plan: by looking ahead (line
/// of sight, Fossen 2011, section 10.3; pure pursuit, Coulter 1992). There is no clock: its place on the path
/// is the point nearest to the vehicle, which never goes back. It heads for the farthest point that is in
/// sight within the way that it takes to turn aside and to stop; where the path turns by more than a radian
/// within a turning radius it is slower in proportion, and begins in time to slow down.
struct Pursuit {
  double along{};     ///< its place, from the beginning of the path [m]
  double gained{};    ///< the place that counts as its last gain [m]
  double gained_s{};  ///< time of the situation in which it gained that
  bool sees{true};    ///< whether some of the path ahead was in sight

  /// Beside a new plan.
  static Pursuit begun(const Situation& s) { return {.gained_s = s.time}; }

  /// Moves the place on, and says what velocity is wanted, level. The plan must be ready. O(points of the
  /// path + obstacles); neither allocates nor throws.
  Vec3 follow(const Situation& s, const Plan& plan) noexcept;

  /// Whether the plan has come to nothing: no point of it ahead was in sight, or the vehicle has not gained
  /// its own radius in the time that it takes to turn round and to stop. O(1).
  bool is_stuck(const Situation& s, const Plan& plan) const noexcept;

  /// Whether what is left of the path leads through `map`. O(points of the path x obstacles).
  bool is_blocked(const Plan& plan, const PlanarMap& map) const noexcept;
};

/// Between one plan and the next of a vehicle that must turn, at the least [s].
inline constexpr double between_plans_s = 2.0;

/// How far a vehicle strays at `speed` [m/s] where its path turns by 30 degrees: it goes on for the lag of
/// its turn rate, and then round on its turning radius R, which leaves the corner by R (1 / cos 15 degrees -
/// 1). [m]
double strays_by(const Situation& s, double speed) noexcept;

}  // namespace fairway
