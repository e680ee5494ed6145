// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/distance_transform.hpp"

#include <algorithm>
#include <cstddef>

namespace fairway::avoa {
namespace {

/// Of a column without a mark: its square is more than that of any distance in a picture.
constexpr std::int16_t none = 2000;

/// One more than the neighbour's, where that is less.
void follow(const std::int16_t* neighbours, std::int16_t* row, std::size_t length) {
  for (std::size_t i = 0; i < length; ++i)
    row[i] = std::min(row[i], static_cast<std::int16_t>(neighbours[i] + 1));
}

}  // namespace

void DistanceTransform::compute(std::span<const std::uint8_t> marked, int side) {
  side_ = side;
  const auto length = static_cast<std::size_t>(side);
  along_column_.resize(length * length);
  std::int16_t* const cells = along_column_.data();
  for (std::size_t i = 0; i < length * length; ++i) cells[i] = marked[i] != 0 ? std::int16_t{0} : none;
  for (std::size_t row = 1; row < length; ++row)
    follow(cells + (row - 1) * length, cells + row * length, length);
  for (std::size_t row = length - 1; row-- > 0;)
    follow(cells + (row + 1) * length, cells + row * length, length);
}

std::int32_t DistanceTransform::squared(int cell, std::int32_t enough) const {
  const std::int16_t* const here = along_column_.data() + cell;
  const std::int32_t column = cell % side_;
  std::int32_t nearest = *here * *here;
  for (std::int32_t k = 1; k * k < std::min(nearest, enough); ++k) {
    if (k <= column) nearest = std::min(nearest, k * k + here[-k] * here[-k]);
    if (k < side_ - column) nearest = std::min(nearest, k * k + here[k] * here[k]);
    if (k > column && k >= side_ - column) break;
  }
  return nearest < none * none ? nearest : infinite;
}

}  // namespace fairway::avoa
