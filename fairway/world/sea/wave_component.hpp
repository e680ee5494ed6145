// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/vec.hpp"
#include "fairway/scenario/water_spec.hpp"

namespace fairway {

/// A regular wave of small amplitude on deep water (Airy; Fossen 2021, section 10.2). At n north, e east:
///
///     elevation = A cos(k d.(n, e) - omega t + phase),    k = omega^2 / g
struct WaveComponent {
  double amplitude{};             ///< A [m]
  double frequency{};             ///< omega [rad/s]
  double number{};                ///< k [rad/m]
  double phase{};                 ///< [rad]
  Vec2 direction{Vec2::UnitX()};  ///< d, where it runs to: unit, [n, e]
};

/// `frequency` [rad/s] > 0; `direction` [rad], 0 north, pi/2 east.
WaveComponent wave_component(double amplitude, double frequency, double direction, double phase);

WaveComponent wave_component(const WaveSpec& spec);

}  // namespace fairway
