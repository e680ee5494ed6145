// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

namespace fairway::lanes {

/// `count` columns of as many numbers as a kernel has lanes, of which one each belongs to a vehicle.
template <std::size_t count, std::size_t most>
struct Columns {
  alignas(64) double numbers[count * most];  // an array that has no functions: see kernel_text.hpp

  /// The values of the vehicle in a lane, one for each column.
  template <class... Values>
  void write(std::size_t width, std::size_t lane, const Values&... values) {
    static_assert(sizeof...(values) == count);
    double* at = numbers + lane;
    ((*at = values, at += width), ...);
  }

  /// Column `column` of the vehicle in a lane.
  double of(std::size_t width, std::size_t lane, std::size_t column) const {
    return numbers[column * width + lane];
  }

  /// In the lanes from `from` on, where nobody is, the first vehicle is once more.
  void repeat_first(std::size_t width, std::size_t from) {
    for (double* column = numbers; column < numbers + count * width; column += width)
      std::fill(column + from, column + width, column[0]);
  }
};

}  // namespace fairway::lanes
