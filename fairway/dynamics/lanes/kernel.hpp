// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace fairway::lanes {

struct BodyNumbers;

inline constexpr std::size_t most_bodies = 8;  ///< side by side

/// Several bodies of one kind, and the water round each: columns of as many numbers as there are lanes.
struct Bodies {
  double h{};                   ///< the step [s]
  bool flows{}, accelerates{};  ///< the water, round all of them
  alignas(
      64) double motion[13 * most_bodies];  ///< p, q (w, x, y, z), v, omega as in MotionOf; then a step later
  alignas(64) double push[6 * most_bodies];   ///< force, moment
  alignas(64) double water[7 * most_bodies];  ///< current, its rate, density
};

/// One step of several bodies in the lanes of a processor's registers, compiled for one kind of these. Each
/// comes to the bits that it comes to alone.
struct MotionKernel {
  const char* name;   ///< "AVX2"
  std::size_t lanes;  ///< a power of two, at most `most_bodies`
  void (*step)(const BodyNumbers& body, Bodies& bodies);
};

/// Those that this processor can run, the widest last.
std::span<const MotionKernel* const> motion_kernels() noexcept;

/// The narrowest with so many lanes, or else the widest.
const MotionKernel& motion_kernel_for(std::size_t count) noexcept;

}  // namespace fairway::lanes
