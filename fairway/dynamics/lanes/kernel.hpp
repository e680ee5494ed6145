// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "fairway/dynamics/lanes/columns.hpp"

namespace fairway::lanes {

struct BodyNumbers;
struct LevelNumbers;

inline constexpr std::size_t most_bodies = 8;  ///< side by side

/// Several bodies of one kind, and the water round each.
struct Bodies {
  double h{};                       ///< the step [s]
  bool flows{}, accelerates{};      ///< the water, round all of them
  Columns<13, most_bodies> motion;  ///< p, q (w, x, y, z), v, omega of MotionOf; then a step later
  Columns<6, most_bodies> push;     ///< force, moment
  Columns<7, most_bodies> water;    ///< current, its rate, density
};

/// Several kinematic vehicles of one kind that are level in still water.
struct LevelBodies {
  double h{};                        ///< [s]
  Columns<9, most_bodies> motion;    ///< as LevelOf; then a step later
  Columns<4, most_bodies> setpoint;  ///< velocity, turn rate
};

/// One step of several vehicles in the lanes of a processor's registers, compiled for one kind of these. Each
/// comes to the bits that it comes to alone.
struct MotionKernel {
  const char* name;   ///< "AVX2"
  std::size_t lanes;  ///< a power of two, at most `most_bodies`
  void (*step)(const BodyNumbers& body, Bodies& bodies);
  void (*step_level)(const LevelNumbers& numbers, LevelBodies& bodies);
};

/// Those that this processor can run, the widest last.
std::span<const MotionKernel* const> motion_kernels() noexcept;

/// The narrowest with so many lanes, or else the widest.
const MotionKernel& motion_kernel_for(std::size_t count) noexcept;

}  // namespace fairway::lanes
