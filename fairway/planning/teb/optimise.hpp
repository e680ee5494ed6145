// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/planning/teb/band.hpp"
#include "fairway/planning/teb/band_obstacle.hpp"
#include "fairway/planning/teb/costs.hpp"

namespace fairway::teb {

/// A pose to which a barrier matters.
struct Closeness {
  std::size_t knot{};
  const BandObstacle* barrier{};
  double time{};    ///< of the pose from now; fixed while the band is optimised, and 0 for what stands still
  double weight{};  ///< of the least distance
};

/// The least squares problem of a band: both end poses are given, all else is free.
struct Problem {
  const TebParams& params;
  double speed{};     ///< at the start, along the heading [m/s]
  double yaw_rate{};  ///< at the start [rad/s]
  std::vector<Closeness> close;
};

/// The barriers that count for each pose but the first and the last: all within force_inclusion_factor times
/// the least distance and the nearest to port and to starboard within cutoff_factor times it; what moves
/// counts for every pose. O(poses x barriers).
void associate(std::span<const BandObstacle> barriers, const Band& band, double obstacle_weight,
               Problem& problem);

/// Calls `visit(variable, cost)` for every cost of a band that is not about barriers; `variable` is the first
/// of its window.
template <class Visit>
void for_each_motion_cost(const Problem& problem, const Band& band, Visit&& visit) {
  const TebParams& params = problem.params;
  const double* x = band.knots.front().data();
  const std::size_t last = band.size() - 2;  // interval
  math::SinCos heading = math::sin_cos(x[heading_of]);
  Twist motion = motion_between(x, heading);
  visit(0, EndAccelerationCost{params, motion, problem.speed, problem.yaw_rate, false});
  for (std::size_t i = 0; i <= last; ++i, x += 4) {
    const math::SinCos next_heading = math::sin_cos(x[4 + heading_of]);
    visit(4 * i, VelocityCost{params, motion});
    visit(4 * i, KinematicsCost{params, motion.way, heading, next_heading});
    visit(4 * i + time_of, TimeCost{params, x[time_of]});
    if (i == last) break;
    const Twist next = motion_between(x + 4, next_heading);
    visit(4 * i, AccelerationCost{params, motion, next});
    motion = next;
    heading = next_heading;
  }
  visit(4 * last, EndAccelerationCost{params, motion, 0.0, 0.0, true});
}

/// Calls `visit(variable, cost)` for every cost of a barrier.
template <class Visit>
void for_each_barrier_cost(const Problem& problem, const Band& band, Visit&& visit) {
  for (const Closeness& c : problem.close) {
    visit(4 * c.knot, BarrierCost{problem.params, *c.barrier, band.position(c.knot), c.time, c.weight});
  }
}

/// The sum of squares: of what the motion costs, and of nearness to barriers.
struct Cost {
  double motion{};
  double barriers{};
  double sum() const { return motion + barriers; }
};
Cost cost_of(const Problem& problem, const Band& band);

/// At most `iterations` accepted steps of Levenberg and Marquardt's method, damped as g2o does it (Nielsen):
/// at first 1e-5 of the largest diagonal element, ten attempts a step. The normal equations are a band of ten
/// diagonals below the main one: O(poses) an attempt.
void improve(const Problem& problem, int iterations, Band& band);

/// The cycle of a decision: adapts the number of poses, associates the barriers, improves, again with
/// weight_adapt_factor times the weight of barriers. The cost is of the last of these problems.
Cost optimise(const TebParams& params, std::span<const BandObstacle> barriers, double speed, double yaw_rate,
              Band& band);

/// True if every number is finite and the first time positive: the original asks for no more.
bool is_sound(const Band& band);

}  // namespace fairway::teb
