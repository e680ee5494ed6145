// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "fairway/core/vec.hpp"

namespace fairway {

/// The area that the vertices go round, seen from above [m2]: positive if they run counter-clockwise
/// with n as x and e as y, as a polygon's must. Zero for fewer than three. O(vertices).
inline double signed_area(std::span<const Vec3> vertices) {
  double doubled = 0.0;
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i) {
    const Vec3 a = vertices[i] - vertices[0];
    const Vec3 b = vertices[i + 1] - vertices[0];
    doubled += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * doubled;
}

/// The first two edges that cross or touch beside their common ends, by the vertices that they begin at; none
/// if the vertices go round one area, once. O(n log n) where few edges share an interval of n.
std::optional<std::pair<std::size_t, std::size_t>> crossing_edges(std::span<const Vec3> vertices);

}  // namespace fairway
