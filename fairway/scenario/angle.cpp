// SPDX-License-Identifier: Apache-2.0
#include "fairway/scenario/angle.hpp"

#include <array>
#include <cmath>

namespace fairway::yaml {

std::optional<double> exact_degrees(double angle) {
  const double near = degrees(angle);
  const double above = std::nextafter(near, HUGE_VAL);
  const double below = std::nextafter(near, -HUGE_VAL);
  for (const double candidate : std::array{near, above, below}) {
    if (radians(candidate) == angle && std::signbit(candidate) == std::signbit(angle)) return candidate;
  }
  return {};
}

}  // namespace fairway::yaml
