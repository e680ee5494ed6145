// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "fairway/avoidance/velocity_program/incremental.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// The velocities v with normal . v >= offset, `normal` a unit vector and `offset` in m/s.
using HalfSpace = lanes::HalfSpaceOf<double>;

/// The answer of a velocity program.
struct VelocityChoice {
  Vec3 velocity;
  double violation;  ///< of the worst half-space [m/s]; 0 if all are kept

  bool is_feasible() const { return violation == 0.0; }
};

/// Half-spaces beyond this many are not looked at, so that the work space is bounded: 32 kB twice, on
/// the stack.
inline constexpr std::size_t max_half_spaces = 1024;

/// The velocity nearest to `preferred` that is in every half-space and no faster than `max_speed`. If
/// there is none: of the velocities no faster than `max_speed` that keep the largest violation
/// least, the one nearest to `preferred`. Either way there is exactly one answer, so the order of the
/// half-spaces changes it by rounding only.
///
/// Incremental programs on a line, on a plane and in space, and a fourth one over (velocity,
/// violation) (van den Berg, Guy, Lin, Manocha 2011, sections 5.2 and 5.3). Expected O(count) for
/// half-spaces in random order, O(count^3) at worst, O(count^4) if infeasible. Any frame;
/// 0 <= `max_speed` < infinity; parallel, opposite and repeated half-spaces are fine. Does not
/// allocate.
VelocityChoice nearest_velocity(std::span<const HalfSpace> half_spaces, const Vec3& preferred,
                                double max_speed) noexcept;

}  // namespace fairway
