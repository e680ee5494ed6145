// SPDX-License-Identifier: Apache-2.0
// Compiled for processors with AVX2 (CMakeLists.txt), and for nothing
// elsewhere.
#if defined(__AVX2__)
#include "fairway/avoidance/lanes/cone_text.hpp"
#include "fairway/avoidance/lanes/fan_text.hpp"
#include "fairway/avoidance/lanes/kernel_text.hpp"

namespace fairway::lanes {

extern const Kernel avx2_kernel;
constexpr Kernel avx2_kernel{"AVX2",
                             4,
                             half_spaces_in_lanes<4>,
                             decide_in_lanes<4>,
                             choose_in_lanes<4>,
                             within_in_lanes<4>,
                             order_in_lanes<4>,
                             roll_in_lanes<4>,
                             cones_in_lanes<4>,
                             outside_in_lanes<4>};

}  // namespace fairway::lanes
#endif
