// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace fairway::avoa {

/// The exact Euclidean distance transform of a square picture in linear time (Felzenszwalb and Huttenlocher
/// 2012; campos2019's reference [13]): first down every column, then the lower envelope of the parabolas of
/// every row. Keeps its scratch, so it allocates only when the picture grows.
class DistanceTransform {
 public:
  /// Where nothing is marked at all.
  static constexpr std::int32_t infinite = std::numeric_limits<std::int32_t>::max();

  /// `marked` has side * side numbers, row by row, 0 where not marked; 1 <= side <= 1000. O(side^2)
  void compute(std::span<const std::uint8_t> marked, int side);

  /// The squared distance of each cell to the nearest marked one, in cells.
  std::span<const std::int32_t> squared() const { return squared_; }

 private:
  void down_the_columns(std::span<const std::uint8_t> marked);
  void along_the_row(std::int32_t* row);

  int side_ = 0;
  std::vector<std::int32_t> squared_;
  std::vector<double> half_inverse_;  // 1 / (2 k)
  std::vector<std::int32_t> foot_;    // of the envelope's parabolas: column,
  std::vector<std::int32_t> height_;  // value there
  std::vector<double> from_;          // and where it becomes the lowest
};

}  // namespace fairway::avoa
