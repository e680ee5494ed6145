// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/avoidance/velocity_obstacle/reachable_set.hpp"
#include "fairway/avoidance/velocity_obstacle/velocity_obstacle.hpp"

namespace fairway::velocity_obstacle {

/// As many velocity obstacles enter one choice at most, so that the work space is bounded.
inline constexpr std::size_t max_obstacles = 128;

/// What is wanted, and what it costs to do otherwise.
struct Wish {
  Vec2 velocity;              ///< v_d [m/s]
  Vec2 ahead;                 ///< unit, along v_d, or the heading if v_d is zero
  double starboard_bias{};    ///< a deviation to port of `ahead` costs so much more of itself
  double collision_weight{};  ///< w of w / t_c [m]

  /// |v - v_d|, a little more to port [m/s].
  double cost(const Vec2& v) const;
};

struct ChosenVelocity {
  Vec2 velocity;     ///< [m/s]
  bool is_feasible;  ///< in RV and in no velocity obstacle
};

/// The velocity of least cost in RAV, which is RV without the velocity obstacles (cao2022, eq. 4, and the
/// choice after eq. 6). It is v_d, or on one boundary where that is nearest to v_d, or where two boundaries
/// meet (Guy et al. 2009, ClearPath): all of these are tried that are not shown to be worse, so the answer is
/// exact to rounding. Where RAV is empty: the reachable velocity of least w / t_c + cost, t_c the time to the
/// first contact (van den Berg, Lin, Manocha 2008, section V-B), among samples of RV and of the boundaries.
/// O(n) for a free v_d, O(n^2) typically, O(n^3) at worst. Does not allocate.
ChosenVelocity choose(std::span<const VelocityObstacle> obstacles, const ReachableSet& reachable,
                      const Wish& wish) noexcept;

}  // namespace fairway::velocity_obstacle
