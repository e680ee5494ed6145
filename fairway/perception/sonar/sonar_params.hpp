// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>

#include "fairway/core/params.hpp"

namespace fairway {

/// A forward-looking multibeam sonar, and how its echoes are read. The defaults of reach, rate and range
/// noise are those of a forward-looking sonar of an AUV (130 deg, 1-100 m, 15 Hz, 0.027 m).
struct SonarParams {
  double field_of_view_deg = 130.0;
  double vertical_aperture_deg = 20.0;
  int beams_count = 256;
  double rate_hz = 15.0;
  double min_range_m = 1.0;
  double max_range_m = 100.0;
  double echo_range_sigma_m = 0.027;
  double echo_bearing_sigma_deg = 0.5;
  double missed_ratio = 0.05;
  double false_echoes_count = 1.0;
  double heading_sigma_deg = 0.5;
  double cluster_gap_m = 2.5;
  double max_extent_m = 12.0;
  double chart_tolerance_m = 2.0;

  static consteval auto fields() {
    return std::tuple{
        field<&SonarParams::field_of_view_deg>({1, 180}, "from port to starboard, centred ahead"),
        field<&SonarParams::vertical_aperture_deg>(
            {1, 90}, "of each beam: whatever lies within echoes, and at which elevation is not known"),
        field<&SonarParams::beams_count>({1, 1024}, "side by side over the field of view"),
        field<&SonarParams::rate_hz>({0.01, 1000}, "pings; at most one a step"),
        field<&SonarParams::min_range_m>({0, 1000},
                                         "what is nearer hides what is behind it and is not heard"),
        field<&SonarParams::max_range_m>({0.1, 10000}, "what is farther is not heard"),
        field<&SonarParams::echo_range_sigma_m>({0, 100}, "standard deviation of an echo's range"),
        field<&SonarParams::echo_bearing_sigma_deg>({0, 45}, "standard deviation of an echo's bearing"),
        field<&SonarParams::missed_ratio>({0, 1}, "of the echoes that there should be"),
        field<&SonarParams::false_echoes_count>(
            {0, 100}, "mean a ping, Poisson; uniform in range and bearing over the fan"),
        field<&SonarParams::heading_sigma_deg>({0, 45},
                                               "what the own heading is trusted to when contacts are placed"),
        field<&SonarParams::cluster_gap_m>({0.01, 1000},
                                           "neighbouring echoes of one thing differ by less in range"),
        field<&SonarParams::max_extent_m>({0.1, 10000}, "what looks wider is cut into pieces, as a wall is"),
        field<&SonarParams::chart_tolerance_m>({0, 1000},
                                               "an echo this near to where the chart has one is dismissed"),
    };
  }
};

/// As many echoes as one ping may have, but for false ones beyond ten standard deviations.
inline std::size_t echo_capacity(const SonarParams& params) {
  const double most_false = params.false_echoes_count + 10.0 * std::sqrt(params.false_echoes_count);
  return static_cast<std::size_t>(params.beams_count) + static_cast<std::size_t>(std::ceil(most_false));
}

/// Throws InputError where one parameter contradicts another.
inline void check(const SonarParams& params) {
  if (params.min_range_m >= params.max_range_m)
    throw InputError({}, "min_range_m", "is not below max_range_m");
}

}  // namespace fairway
