// SPDX-License-Identifier: Apache-2.0
#include "fairway/comms/sound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fairway/core/math.hpp"
#include "fairway/core/segments.hpp"

namespace fairway {
namespace {

double log10_of(double x) noexcept { return math::log(x) / std::numbers::ln10; }
double ten_to(double x) noexcept { return math::exp(x * std::numbers::ln10); }

/// Of a substance that relaxes at `relaxation` [kHz].
double relaxing(double frequency, double relaxation) noexcept {
  const double f2 = frequency * frequency;
  return relaxation * f2 / (relaxation * relaxation + f2);
}

/// Francois and Garrison's viscous part [dB/(km kHz^2)]: of pure water, by temperature [C].
double viscosity(double t) noexcept {
  if (t <= 20.0) return 4.937e-4 - 2.59e-5 * t + 9.11e-7 * t * t - 1.50e-8 * t * t * t;
  return 3.964e-4 - 1.146e-5 * t + 1.45e-7 * t * t - 6.5e-10 * t * t * t;
}

}  // namespace

double decibels(double ratio) noexcept { return 10.0 * log10_of(ratio); }

double power_ratio(double decibels) noexcept { return ten_to(decibels / 10.0); }

double francois_garrison_absorption(double frequency_khz, const SeaWater& water) noexcept {
  const double t = water.temperature_degc, s = water.salinity_psu, d = water.depth_m;
  const double kelvin = 273.0 + t;
  const double sound_speed = 1412.0 + 3.21 * t + 1.19 * s + 0.0167 * d;

  const double boric = 8.86 / sound_speed * ten_to(0.78 * water.ph - 5.0);
  const double boric_relaxation = 2.8 * std::sqrt(s / 35.0) * ten_to(4.0 - 1245.0 / kelvin);

  const double magnesium = 21.44 * s / sound_speed * (1.0 + 0.025 * t);
  const double magnesium_pressure = 1.0 - 1.37e-4 * d + 6.2e-9 * d * d;
  const double magnesium_relaxation = 8.17 * ten_to(8.0 - 1990.0 / kelvin) / (1.0 + 0.0018 * (s - 35.0));

  const double water_pressure = 1.0 - 3.83e-5 * d + 4.9e-10 * d * d;
  return boric * relaxing(frequency_khz, boric_relaxation) +
         magnesium * magnesium_pressure * relaxing(frequency_khz, magnesium_relaxation) +
         viscosity(t) * water_pressure * (frequency_khz * frequency_khz);
}

double ambient_noise(double frequency_khz, double shipping, double wind) noexcept {
  const double decades = log10_of(frequency_khz);
  const double turbulence = 17.0 - 30.0 * decades;
  const double ships =
      40.0 + 20.0 * (shipping - 0.5) + 26.0 * decades - 60.0 * log10_of(frequency_khz + 0.03);
  const double waves = 50.0 + 7.5 * std::sqrt(wind) + 20.0 * decades - 40.0 * log10_of(frequency_khz + 0.4);
  const double heat = -15.0 + 20.0 * decades;
  return decibels(power_ratio(turbulence) + power_ratio(ships) + power_ratio(waves) + power_ratio(heat));
}

bool is_in_shadow(const Obstacle& obstacle, const Vec3& a, const Vec3& b) noexcept {
  constexpr double touching = 0.01;
  const double free = nearest_point(obstacle, 0.5 * (a + b)).distance;  // half way
  if (free < touching) return true;
  if (free >= 0.5 * (b - a).norm() + touching) return false;
  switch (obstacle.kind) {
    case Obstacle::Kind::sphere:
      return distance_to_segment(a, b, obstacle.position) - obstacle.radius < touching;
    case Obstacle::Kind::segment:
      return distance_between(a, b, obstacle.from, obstacle.to) < touching;
    case Obstacle::Kind::polygon:
      break;
  }
  // seen from above, and half way it is outside: whoever is inside at an end crosses an edge
  const std::span<const Vec3> vertices = obstacle.vertices;
  const Vec2 from = a.head<2>(), to = b.head<2>();
  for (std::size_t i = 0, j = vertices.size() - 1; i < vertices.size(); j = i++) {
    const Vec2 here = vertices[j].head<2>(), next = vertices[i].head<2>();
    if (distance_between(from, to, here, next) < touching) return true;
  }
  return false;
}

double transmission_loss(double distance, double spreading, double absorption_db_per_km) noexcept {
  const double d = std::max(distance, 1.0);
  return spreading * decibels(d) + absorption_db_per_km * 1e-3 * (d - 1.0);
}

double packet_error_ratio(double bit_energy_to_noise_db, int bits) noexcept {
  const double bit_error = 0.5 * math::exp(-0.5 * power_ratio(bit_energy_to_noise_db));
  // 1 - (1 - p)^n, where p may be far below the last place of 1
  const double log_of_right = bit_error < 1e-8 ? -bit_error : math::log(1.0 - bit_error);
  return -math::expm1(static_cast<double>(bits) * log_of_right);
}

}  // namespace fairway
