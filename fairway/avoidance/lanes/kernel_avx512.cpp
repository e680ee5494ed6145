// SPDX-License-Identifier: Apache-2.0
// Compiled for processors with AVX-512 (CMakeLists.txt), and for nothing
// elsewhere.
#if defined(__AVX512DQ__)
#include "fairway/avoidance/lanes/cone_text.hpp"
#include "fairway/avoidance/lanes/fan_text.hpp"
#include "fairway/avoidance/lanes/kernel_text.hpp"

namespace fairway::lanes {

extern const Kernel avx512_kernel;
constexpr Kernel avx512_kernel{"AVX-512",
                               8,
                               half_spaces_in_lanes<8>,
                               decide_in_lanes<8>,
                               choose_in_lanes<8>,
                               within_in_lanes<8>,
                               order_in_lanes<8>,
                               roll_in_lanes<8>,
                               cones_in_lanes<8>,
                               outside_in_lanes<8>};

}  // namespace fairway::lanes
#endif
