// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/lanes/kernel.hpp"

#include <array>

#include "fairway/avoidance/lanes/fan_text.hpp"
#include "fairway/avoidance/lanes/kernel_text.hpp"

namespace fairway::lanes {

#if defined(__x86_64__)
extern const Kernel avx2_kernel, avx512_kernel;  // kernel_avx2.cpp, kernel_avx512.cpp
#endif

namespace {

constexpr Kernel two_lanes{
    "two lanes",     2, half_spaces_in_lanes<2>, decide_in_lanes<2>, within_in_lanes<2>, order_in_lanes<2>,
    roll_in_lanes<2>};

// addresses are known before anything runs: a decision waits for no initialisation
#if defined(__x86_64__)
constexpr std::array all{&two_lanes, &avx2_kernel, &avx512_kernel};
#else
constexpr std::array all{&two_lanes};
#endif

std::size_t count_of_kernels() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") == 0) return 1;
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 ? 3 : 2;
#else
  return 1;
#endif
}

}  // namespace

std::span<const Kernel* const> kernels() noexcept { return std::span{all}.first(count_of_kernels()); }

const Kernel& kernel_for(std::size_t count) noexcept {
  const std::span<const Kernel* const> ours = kernels();
  for (const Kernel* kernel : ours)
    if (kernel->lanes >= count) return *kernel;
  return *ours.back();
}

}  // namespace fairway::lanes
