// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "fairway/core/vec.hpp"

namespace fairway {

/// The points x with normal . x >= offset.
struct HalfPlane {
  Vec2 normal;    ///< unit, into the allowed side
  double offset;  ///< of the bounding line along `normal`, in the unit of x

  /// How far `x` lies on the forbidden side; negative on the allowed one.
  double violation(const Vec2& x) const { return offset - normal.dot(x); }
};

/// What is asked: half-planes, of which the first `hard_count` are kept whatever the others ask, and a
/// disc round the origin that is kept too.
struct PlaneProgram {
  std::span<const HalfPlane> half_planes;
  std::size_t hard_count = 0;
  double max_length = std::numeric_limits<double>::infinity();  ///< radius of the disc, >= 0
};

/// The answer of a plane program.
struct PlaneChoice {
  Vec2 point;
  double violation;  ///< of the worst half-plane, in the unit of x; 0 if all are kept

  bool is_feasible() const { return violation == 0.0; }
};

/// The point nearest to `wanted` that keeps every half-plane and the disc. If there is none: of the points
/// that keep the disc and the hard half-planes and whose largest violation of the others is least, the
/// nearest to `wanted`. If the hard ones contradict each other, they are all moved back by their least
/// violation, and of what that leaves it is the same. Either way there is one answer, so the order of the
/// soft half-planes changes it by rounding only.
///
/// Incremental, after Seidel, in the order given (de Berg et al., Computational Geometry, chapter 4; the
/// second program is that of van den Berg, Guy, Lin, Manocha 2011, section 5.3, in the plane). O(count) in
/// random order and O(count^2) at worst if feasible; O(count^3) at worst if not. Parallel, opposite and
/// repeated half-planes are fine. Allocates nothing.
PlaneChoice nearest_in_plane(const PlaneProgram& program, const Vec2& wanted) noexcept;

}  // namespace fairway
