// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace fairway::trackable {

/// What is kept to every surface beyond own sphere, each part declared by itself.
struct Margins {
  double tracking{};    ///< bound on the distance from where the vehicle is foreseen to be [m]
  double perception{};  ///< bound on the error of where the others are [m]
  double navigation{};  ///< bound on the error of where own ship is, against what is charted or told [m]
  double current{};     ///< bound on how wrong the water's motion is taken [m/s]
  double extra{};       ///< beyond all of these [m]

  struct Part {
    std::string_view meaning;
    double size;  ///< [m]
  };
  /// Each part over a foresight of `window` [s]. O(1).
  std::array<Part, 5> parts(double window) const noexcept {
    return {Part{"margin of tracking", tracking}, Part{"margin of perception", perception},
            Part{"margin of navigation", navigation}, Part{"margin of the current", current * window},
            Part{"extra margin", extra}};
  }
  /// All parts together: each may be at its bound at once. [m]
  double total(double window) const noexcept {
    double sum = 0.0;
    for (const Part& part : parts(window)) sum += part.size;
    return sum;
  }
};

}  // namespace fairway::trackable
