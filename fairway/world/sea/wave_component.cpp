// SPDX-License-Identifier: Apache-2.0
#include "fairway/world/sea/wave_component.hpp"

#include <cmath>

#include "fairway/core/angles.hpp"

namespace fairway {
namespace {

constexpr double wave_gravity = 9.81;  // [m/s2]

}  // namespace

WaveComponent wave_component(double amplitude, double frequency, double direction, double phase) {
  return {.amplitude = amplitude,
          .frequency = frequency,
          .number = frequency * frequency / wave_gravity,
          .phase = phase,
          .direction = unit_at(direction)};
}

WaveComponent wave_component(const WaveSpec& spec) {
  return wave_component(spec.amplitude_m, 2.0 * pi / spec.period_s, spec.direction_rad, spec.phase_rad);
}

}  // namespace fairway
