// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace fairway::avoa {

/// The exact Euclidean distances of a square picture to what is marked in it: down every column at once, and
/// along the row for the cells that are asked for, which are few, and no farther than matters. Keeps its
/// scratch, so it allocates only when the picture grows.
class DistanceTransform {
 public:
  /// Where nothing is marked at all.
  static constexpr std::int32_t infinite = std::numeric_limits<std::int32_t>::max();

  /// `marked` has side * side numbers, row by row, 0 where not marked; 1 <= side <= 1000. O(side^2)
  void compute(std::span<const std::uint8_t> marked, int side);

  /// The squared distance of a cell to the nearest marked one, in cells; or, where that is at least `enough`,
  /// any number that is. O(distance)
  std::int32_t squared(int cell, std::int32_t enough = infinite) const;

 private:
  int side_ = 0;
  std::vector<std::int16_t> along_column_;  // to the nearest marked cell of the same column
};

}  // namespace fairway::avoa
