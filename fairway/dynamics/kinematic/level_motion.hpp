// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "fairway/core/lanes/number.hpp"
#include "fairway/dynamics/runge_kutta.hpp"

/// The equations of Kinematic (kinematic.hpp) without what is zero of one that is level in still water, of
/// one vehicle or of several of one kind side by side (core/lanes/number.hpp).
namespace fairway::lanes {

/// What does not change.
struct LevelNumbers {
  double rate;  ///< 1 / time constant [1/s]
  double max_acceleration;
  double max_turn_acceleration;
};

/// What changes; an even number of one vehicle, so that the compiler takes two at a time.
enum Level : std::size_t { north, east, down, surge, sway, heave, q_w, q_z, turn, level_size };
template <class Real>
struct LevelOf {
  static constexpr std::size_t size = level_size + (sizeof(Real) == sizeof(double) ? 1 : 0);

  Real all[size];

  Real& operator[](std::size_t i) { return all[i]; }
  const Real& operator[](std::size_t i) const { return all[i]; }
};

template <class Real>
struct SetpointOf {
  VecOf<Real> velocity;
  Real turn_rate;
};

template <class Real>
[[gnu::always_inline]] inline LevelOf<Real> moved(const LevelOf<Real>& x, const LevelOf<Real>& rate,
                                                  double h) {
  LevelOf<Real> y;
  for (std::size_t i = 0; i < y.size; ++i) y[i] = x[i] + h * rate[i];
  return y;
}

template <class Real>
[[gnu::always_inline]] inline LevelOf<Real> mean_of(const LevelOf<Real>& k1, const LevelOf<Real>& k2,
                                                    const LevelOf<Real>& k3, const LevelOf<Real>& k4) {
  LevelOf<Real> mean;
  for (std::size_t i = 0; i < mean.size; ++i)
    mean[i] = (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]) / Real{6.0};
  return mean;
}

template <class Real>
[[gnu::always_inline]] inline LevelOf<Real> rate_of(const LevelNumbers& numbers, const LevelOf<Real>& x,
                                                    const SetpointOf<Real>& setpoint) {
  const Real two_z = 2.0 * x[q_z], sine = two_z * x[q_w], cosine = 1.0 - two_z * x[q_z];
  VecOf<Real> a = Real{numbers.rate} * (setpoint.velocity - VecOf<Real>{x[surge], x[sway], x[heave]});
  const Real a2 = dot(a, a);
  const auto limited = a2 > numbers.max_acceleration * numbers.max_acceleration;
  if (any(limited)) a = select(limited, numbers.max_acceleration / square_root(a2), Real{1.0}) * a;
  const Real half_turn = 0.5 * x[turn];
  const Real alpha = numbers.rate * (setpoint.turn_rate - x[turn]);
  const Real most{numbers.max_turn_acceleration};
  return {{cosine * x[surge] - sine * x[sway], sine * x[surge] + cosine * x[sway], x[heave], a.x(), a.y(),
           a.z(), -(x[q_z] * half_turn), x[q_w] * half_turn, smaller(larger(alpha, -most), most)}};
}

/// One step of length `h` [s] later.
template <class Real>
[[gnu::always_inline]] inline LevelOf<Real> stepped(const LevelNumbers& numbers, const LevelOf<Real>& x,
                                                    const SetpointOf<Real>& setpoint, double h) {
  LevelOf<Real> y = runge_kutta(
      x, h, [&](const LevelOf<Real>& at) __attribute__((always_inline)) {
        return rate_of(numbers, at, setpoint);
      });
  const Real length = square_root(y[q_z] * y[q_z] + y[q_w] * y[q_w]);
  y[q_w] = y[q_w] / length;
  y[q_z] = y[q_z] / length;
  return y;
}

}  // namespace fairway::lanes
