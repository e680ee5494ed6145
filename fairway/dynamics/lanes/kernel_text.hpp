// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/lanes/pack.hpp"
#include "fairway/dynamics/kinematic/level_motion.hpp"
#include "fairway/dynamics/lanes/kernel.hpp"
#include "fairway/dynamics/submerged_motion.hpp"

/// What each kernel is compiled from, with the flags of its registers. So nothing in here may be a function
/// that a file with other flags has too: all are templates of `Pack<N>`, and no two files have the same N.
namespace fairway::lanes {

template <std::size_t N>
void step_in_lanes(const BodyNumbers& body, Bodies& bodies) {
  using Real = Pack<N>;
  double* at = bodies.motion.numbers;
  const double *push = bodies.push.numbers, *water = bodies.water.numbers;
  MotionOf<Real> x{vector_at<N>(at), {}, vector_at<N>(at + 7 * N), vector_at<N>(at + 10 * N)};
  for (std::size_t i = 0; i < 4; ++i) x.q[i] = Real::from(at + (3 + i) * N);
  const MotionOf<Real> y = stepped<Real>(body, x, {vector_at<N>(push), vector_at<N>(push + 3 * N)},
                                         {vector_at<N>(water), vector_at<N>(water + 3 * N),
                                          Real::from(water + 6 * N), bodies.flows, bodies.accelerates},
                                         bodies.h);
  write_vector<N>(y.p, at);
  for (std::size_t i = 0; i < 4; ++i) y.q[i].to(at + (3 + i) * N);
  write_vector<N>(y.v, at + 7 * N);
  write_vector<N>(y.omega, at + 10 * N);
}

template <std::size_t N>
void step_level_in_lanes(const LevelNumbers& numbers, LevelBodies& bodies) {
  using Real = Pack<N>;
  double* at = bodies.motion.numbers;
  const double* setpoint = bodies.setpoint.numbers;
  LevelOf<Real> x;
  for (std::size_t i = 0; i < level_size; ++i) x[i] = Real::from(at + i * N);
  const LevelOf<Real> y =
      stepped<Real>(numbers, x, {vector_at<N>(setpoint), Real::from(setpoint + 3 * N)}, bodies.h);
  for (std::size_t i = 0; i < level_size; ++i) y[i].to(at + i * N);
}

}  // namespace fairway::lanes
