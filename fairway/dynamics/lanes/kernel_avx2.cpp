// SPDX-License-Identifier: Apache-2.0
// Compiled for processors with AVX2 (CMakeLists.txt), and for nothing elsewhere.
#if defined(__AVX2__)
#include "fairway/dynamics/lanes/kernel_text.hpp"

namespace fairway::lanes {

extern const MotionKernel avx2_motion;
constexpr MotionKernel avx2_motion{"AVX2", 4, step_in_lanes<4>, step_level_in_lanes<4>};

}  // namespace fairway::lanes
#endif
