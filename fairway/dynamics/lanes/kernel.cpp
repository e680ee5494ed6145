// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/lanes/kernel.hpp"

#include <array>

#include "fairway/core/lanes/registers.hpp"
#include "fairway/dynamics/lanes/kernel_text.hpp"

namespace fairway::lanes {

#if defined(__x86_64__)
extern const MotionKernel avx2_motion, avx512_motion;  // kernel_avx2.cpp, kernel_avx512.cpp
#endif

namespace {

constexpr MotionKernel two_lanes{"two lanes", 2, step_in_lanes<2>, step_level_in_lanes<2>};

#if defined(__x86_64__)
constexpr std::array all{&two_lanes, &avx2_motion, &avx512_motion};
#else
constexpr std::array all{&two_lanes};
#endif

}  // namespace

std::span<const MotionKernel* const> motion_kernels() noexcept {
  return std::span{all}.first(count_of_registers());
}

const MotionKernel& motion_kernel_for(std::size_t count) noexcept {
  return narrowest_for(count, motion_kernels());
}

}  // namespace fairway::lanes
