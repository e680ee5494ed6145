// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "fairway/avoidance/avoa/velocity_space.hpp"
#include "fairway/avoidance/sketch.hpp"

namespace fairway::avoa {

/// Draws `space` as campos2019 does (Figs. 3 to 6), with own bow at `yaw` [rad]:
///   "protective zones"  hue is the heading, saturation the speed; black is not feasible
///   "cost of danger"    from white, none, to dark grey, most; black is in an obstacle's zone
///   "metric"            the lighter the better, from the best to the worst feasible; black is not feasible
/// `pixels` is scratch. O(cells)
void draw(const VelocitySpace& space, const VelocityMetric& metric, double yaw,
          std::vector<std::uint32_t>& pixels, Sketch& sketch);

}  // namespace fairway::avoa
