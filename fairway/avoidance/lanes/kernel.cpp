// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/lanes/kernel.hpp"

#include <array>

#include "fairway/avoidance/lanes/cone_text.hpp"
#include "fairway/avoidance/lanes/fan_text.hpp"
#include "fairway/avoidance/lanes/kernel_text.hpp"
#include "fairway/core/lanes/registers.hpp"

namespace fairway::lanes {

#if defined(__x86_64__)
extern const Kernel avx2_kernel, avx512_kernel;  // kernel_avx2.cpp, kernel_avx512.cpp
#endif

namespace {

constexpr Kernel two_lanes{"two lanes",
                           2,
                           half_spaces_in_lanes<2>,
                           decide_in_lanes<2>,
                           choose_in_lanes<2>,
                           within_in_lanes<2>,
                           order_in_lanes<2>,
                           roll_in_lanes<2>,
                           cones_in_lanes<2>,
                           outside_in_lanes<2>};

// addresses are known before anything runs: a decision waits for no initialisation
#if defined(__x86_64__)
constexpr std::array all{&two_lanes, &avx2_kernel, &avx512_kernel};
#else
constexpr std::array all{&two_lanes};
#endif

}  // namespace

std::span<const Kernel* const> kernels() noexcept { return std::span{all}.first(count_of_registers()); }

const Kernel& kernel_for(std::size_t count) noexcept { return narrowest_for(count, kernels()); }

}  // namespace fairway::lanes
