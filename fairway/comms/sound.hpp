// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/shapes.hpp"

namespace fairway {

// How loud a modem is heard, and what of a packet is left then: the passive sonar equation. Levels are in dB
// re 1 uPa (at 1 m for sources), densities in dB re 1 uPa^2/Hz.

/// Of a ratio of powers [dB], and the other way round.
double decibels(double ratio) noexcept;
double power_ratio(double decibels) noexcept;

/// Sea water, for Francois and Garrison.
struct SeaWater {
  double temperature_degc{10.0};
  double salinity_psu{35.0};
  double depth_m{10.0};
  double ph{8.0};
};

/// What sound loses to sea water by Francois and Garrison, "Sound absorption based on ocean measurements" II,
/// J. Acoust. Soc. Am. 72 (1982), equations 2 to 10: within 5 % for 0.4 to 1000 kHz. [dB/km]
double francois_garrison_absorption(double frequency_khz, const SeaWater& water) noexcept;

/// Noise of turbulence, ships, wind and heat by Coates (1990), as in Stojanovic, "On the relationship between
/// capacity and distance" (2007), equation 7. `shipping` is 0 to 1, `wind` [m/s].
/// [dB re 1 uPa^2/Hz]
double ambient_noise(double frequency_khz, double shipping, double wind) noexcept;

/// What sound loses on `distance` [m]: 10 `spreading` log10(distance / 1 m) + absorption. `spreading` is 2 in
/// the open, 1 between surface and bottom, 1.5 in practice; nearer than 1 m nothing is lost. [dB]
double transmission_loss(double distance, double spreading, double absorption_db_per_km) noexcept;

/// True if the straight way from `a` to `b` comes within a centimetre of what is solid [m, NED].
bool is_in_shadow(const Obstacle& obstacle, const Vec3& a, const Vec3& b) noexcept;

/// Share of packets of so many bits that arrive with an error somewhere, with nothing to correct it: bits
/// keyed by frequency and detected without phase err with exp(-(Eb/N0) / 2) / 2 (Proakis, Digital
/// Communications, equation 5.4-47), each by itself.
double packet_error_ratio(double bit_energy_to_noise_db, int bits) noexcept;

}  // namespace fairway
