// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/core/rng.hpp"
#include "fairway/world/sea/wave_component.hpp"

namespace fairway {

/// Spectral density S [m2 s] of the elevation at `frequency` [rad/s] > 0, by Hs = `significant_height` [m]
/// and omega_0 = `peak_frequency` [rad/s]. Pierson and Moskowitz's, written by height and peak (Fossen 2021,
/// section 10.2):
///
///     S = 5/16 Hs^2 omega_0^4 omega^-5 exp(-5/4 (omega_0 / omega)^4)
double pierson_moskowitz(double frequency, double significant_height, double peak_frequency);

/// The same for a growing sea (Hasselmann et al. 1973, normalised as DNV-RP-C205):
///
///     S = (1 - 0.287 ln gamma) S_PM gamma^exp(-(omega - omega_0)^2 / (2 sigma^2 omega_0^2))
///
/// with sigma = 0.07 below omega_0 and 0.09 from there on. `peakedness` gamma is in [1, 7], or 0 to take it
/// from height and peak: dnv_peakedness().
double jonswap(double frequency, double significant_height, double peak_frequency, double peakedness);

/// gamma that goes with a height [m] and a peak [rad/s], 1 to 5 (DNV-RP-C205, section 3.5.5).
double dnv_peakedness(double significant_height, double peak_frequency);

/// The waves of a sea with the spectrum of `spec`, one for each of as many bins of equal width between 1/2
/// and 3 times the peak frequency. A wave has the energy of its bin, a frequency anywhere in it, so that the
/// sea does not repeat itself after 2 pi / width, a phase in [0, 2 pi), and a direction drawn from the
/// spreading. The energy beyond, 1.5 % with Pierson and Moskowitz's spectrum, is shared out, so that 4
/// sqrt(m_0) of the waves is the significant height.
///
/// Wave i draws from the stream `i` of `rng`. O(bins).
std::vector<WaveComponent> sampled_sea(const SpectrumSpec& spec, const Rng& rng);

}  // namespace fairway
