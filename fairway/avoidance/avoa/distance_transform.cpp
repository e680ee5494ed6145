// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/distance_transform.hpp"

#include <algorithm>
#include <cstddef>

namespace fairway::avoa {

void DistanceTransform::compute(std::span<const std::uint8_t> marked, int side) {
  const auto length = static_cast<std::size_t>(side);
  if (side_ != side) {
    side_ = side;
    squared_.resize(length * length);
    foot_.resize(length);
    height_.resize(length);
    from_.resize(length + 1);
    half_inverse_.resize(length);
    for (std::size_t k = 1; k < length; ++k) half_inverse_[k] = 0.5 / static_cast<double>(k);
  }
  down_the_columns(marked);
  for (std::size_t row = 0; row < length; ++row) along_the_row(squared_.data() + row * length);
}

void DistanceTransform::down_the_columns(std::span<const std::uint8_t> marked) {
  const auto side = static_cast<std::size_t>(side_);
  const std::int32_t far = 2 * side_;  // more than any distance along a column

  for (std::size_t i = 0; i < side; ++i) squared_[i] = marked[i] != 0 ? 0 : far;
  for (std::size_t i = side; i < side * side; ++i) {
    squared_[i] = marked[i] != 0 ? 0 : std::min(squared_[i - side] + 1, far);
  }
  for (std::size_t i = side * side - side; i-- > 0;) {
    squared_[i] = std::min(squared_[i], squared_[i + side] + 1);
  }
  for (std::int32_t& distance : squared_) distance = distance < side_ ? distance * distance : infinite;
}

void DistanceTransform::along_the_row(std::int32_t* row) {
  // where parabola `foot`, `height` falls below the last of the envelope; comparing whole numbers' quotients,
  // rounding can only decide between equals
  std::ptrdiff_t last = -1;
  for (std::int32_t column = 0; column < side_; ++column) {
    const std::int32_t height = row[column];
    if (height == infinite) continue;
    double from = -1.0;
    while (last >= 0) {
      const auto k = static_cast<std::size_t>(last);
      const std::int32_t difference = height + column * column - height_[k] - foot_[k] * foot_[k];
      from = difference * half_inverse_[static_cast<std::size_t>(column - foot_[k])];
      if (from > from_[k]) break;
      --last;
      from = -1.0;
    }
    const auto k = static_cast<std::size_t>(++last);
    foot_[k] = column;
    height_[k] = height;
    from_[k] = from;
  }
  if (last < 0) return;

  std::size_t k = 0;
  for (std::int32_t column = 0; column < side_; ++column) {
    while (k < static_cast<std::size_t>(last) && from_[k + 1] < column) ++k;
    const std::int32_t across = column - foot_[k];
    row[column] = height_[k] + across * across;
  }
}

}  // namespace fairway::avoa
