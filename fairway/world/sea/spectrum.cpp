// SPDX-License-Identifier: Apache-2.0
#include "fairway/world/sea/spectrum.hpp"

#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

// the bins together, by the peak frequency
constexpr double lowest_frequency = 0.5, highest_frequency = 3.0;

constexpr int strips_per_bin = 32;

double density(const SpectrumSpec& spec, double frequency, double peak_frequency) {
  if (spec.spectrum == SpectrumKind::pierson_moskowitz)
    return pierson_moskowitz(frequency, spec.significant_height_m, peak_frequency);
  return jonswap(frequency, spec.significant_height_m, peak_frequency, spec.peakedness_ratio);
}

/// The part of m_0 between `from` and `from` + `width` [m2], by the midpoint rule.
double energy(const SpectrumSpec& spec, double peak_frequency, double from, double width) {
  const double strip = width / strips_per_bin;
  double sum = 0.0;
  for (int i = 0; i < strips_per_bin; ++i) sum += density(spec, from + (i + 0.5) * strip, peak_frequency);
  return strip * sum;
}

/// The angle to the mean direction, of density ~ cos^2s within a quarter turn: by rejection.
double spread(std::int32_t s, Rng& rng) {
  if (s == 0) return 0.0;
  for (;;) {
    const double angle = rng.uniform(-pi / 2, pi / 2);
    if (rng.uniform(0.0, 1.0) < math::power(math::cos(angle), 2 * s)) return angle;
  }
}

}  // namespace

double pierson_moskowitz(double frequency, double significant_height, double peak_frequency) {
  const double ratio = peak_frequency / frequency, ratio4 = ratio * ratio * ratio * ratio;
  const double height2 = significant_height * significant_height;
  return 5.0 / 16.0 * height2 * ratio4 / frequency * math::exp(-1.25 * ratio4);
}

double dnv_peakedness(double significant_height, double peak_frequency) {
  const double steepness = 2.0 * pi / (peak_frequency * std::sqrt(significant_height));
  if (steepness <= 3.6) return 5.0;
  if (steepness <= 5.0) return math::exp(5.75 - 1.15 * steepness);
  return 1.0;
}

double jonswap(double frequency, double significant_height, double peak_frequency, double peakedness) {
  const double gamma = peakedness == 0.0 ? dnv_peakedness(significant_height, peak_frequency) : peakedness;
  const double sigma = frequency < peak_frequency ? 0.07 : 0.09;
  const double off = (frequency - peak_frequency) / (sigma * peak_frequency);
  return (1.0 - 0.287 * math::log(gamma)) * pierson_moskowitz(frequency, significant_height, peak_frequency) *
         math::exp(math::exp(-0.5 * off * off) * math::log(gamma));
}

std::vector<WaveComponent> sampled_sea(const SpectrumSpec& spec, const Rng& rng) {
  const double peak = 2.0 * pi / spec.peak_period_s;
  const auto count = static_cast<std::size_t>(spec.components_count);
  const double width = (highest_frequency - lowest_frequency) * peak / spec.components_count;

  std::vector<WaveComponent> waves;
  waves.reserve(count);
  double total = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double from = lowest_frequency * peak + static_cast<double>(i) * width;
    const double variance = energy(spec, peak, from, width);
    total += variance;

    Rng own = rng.stream("wave", i);
    const double frequency = from + own.uniform(0.0, width);
    const double phase = own.uniform(0.0, 2.0 * pi);
    const double direction = spec.direction_rad + spread(spec.spreading_count, own);
    waves.push_back(wave_component(std::sqrt(2.0 * variance), frequency, direction, phase));
  }

  // 4 sqrt(m_0) is the significant height
  const double scale = spec.significant_height_m / (4.0 * std::sqrt(total));
  for (WaveComponent& wave : waves) wave.amplitude *= scale;
  return waves;
}

}  // namespace fairway
