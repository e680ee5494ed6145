// SPDX-License-Identifier: Apache-2.0
// Compiled for processors with AVX-512 (CMakeLists.txt), and for nothing elsewhere.
#if defined(__AVX512DQ__)
#include "fairway/dynamics/lanes/kernel_text.hpp"

namespace fairway::lanes {

extern const MotionKernel avx512_motion;
constexpr MotionKernel avx512_motion{"AVX-512", 8, step_in_lanes<8>, step_level_in_lanes<8>};

}  // namespace fairway::lanes
#endif
