// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "fairway/core/params.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// The most components of a sea, and the most points of a profile.
inline constexpr std::size_t max_wave_components = 1000;
inline constexpr std::size_t max_profile_points = 1000;

/// A regular wave on deep water. Directions of waves and currents are those that they run towards: 0 north,
/// pi/2 east.
struct WaveSpec {
  double amplitude_m{};
  double period_s{1.0};
  double direction_rad{};
  double phase_rad{};  ///< of the elevation's cosine at the origin at the start
};

enum class SpectrumKind { jonswap, pierson_moskowitz };

template <>
struct EnumNames<SpectrumKind> {
  static constexpr std::array names{"jonswap", "pierson_moskowitz"};
};

/// A sea whose waves are drawn from a spectrum.
struct SpectrumSpec {
  SpectrumKind spectrum{};
  double significant_height_m{};
  double peak_period_s{1.0};
  double peakedness_ratio{3.3};       ///< gamma of JONSWAP, 1 to 7; 0 = by the rule of DNV
  double direction_rad{};             ///< mean
  std::int32_t spreading_count{};     ///< s of cos^2s about the mean; 0 = all in the one direction
  std::int32_t components_count{50};  ///< drawn
};

/// Either waves one by one or a spectrum; calm with neither.
struct WavesSpec {
  std::vector<WaveSpec> components;
  std::optional<SpectrumSpec> spectrum;

  bool calm() const { return components.empty() && !spectrum; }
};

/// Speed of a current at a depth.
struct ProfilePoint {
  double depth_m{};
  double speed_mps{};
};

/// A current whose speed is linear in depth between points, and as at the first and the last beyond them.
struct ShearedCurrentSpec {
  double direction_rad{};
  std::vector<ProfilePoint> profile;  ///< at least two, downwards
};

/// A current whose speed and direction are Gauss-Markov processes, alike at all depths.
struct GaussMarkovCurrentSpec {
  double mean_speed_mps{};
  double deviation_mps{};  ///< standard deviation of the speed
  double correlation_time_s{100.0};
  double min_speed_mps{0.0};
  double max_speed_mps{std::numeric_limits<double>::infinity()};
  double direction_rad{};            ///< mean
  double direction_deviation_rad{};  ///< standard deviation of the direction
  double direction_correlation_time_s{1000.0};
};

/// Those that are given add.
struct CurrentSpec {
  std::optional<ShearedCurrentSpec> sheared;
  std::optional<GaussMarkovCurrentSpec> gauss_markov;

  bool none() const { return !sheared && !gauss_markov; }
};

/// The water of a scenario.
struct WaterSpec {
  double density_kgpm3{1000.0};
  Vec3 current_n = Vec3::Zero();  ///< uniform [m/s, NED]; zero if there is a `current`
  CurrentSpec current;
  WavesSpec waves;

  bool still() const { return current_n.isZero(0.0) && current.none() && waves.calm(); }
};

}  // namespace fairway
