// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace fairway::lanes {

/// How many of what is compiled for two, four (AVX2) and eight lanes (AVX-512) this processor can run: 1
/// to 3.
inline std::size_t count_of_registers() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") == 0) return 1;
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 ? 3 : 2;
#else
  return 1;
#endif
}

/// Of kernels, the widest last, the narrowest with so many lanes, or else the widest.
template <class Kernel>
const Kernel& narrowest_for(std::size_t count, std::span<const Kernel* const> kernels) noexcept {
  for (const Kernel* kernel : kernels)
    if (kernel->lanes >= count) return *kernel;
  return *kernels.back();
}

}  // namespace fairway::lanes
