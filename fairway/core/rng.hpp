// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

#include "fairway/core/math.hpp"

namespace fairway {

/// The only source of randomness. Copying it copies the future: two equal generators give equal
/// draws. There is no global generator and no default seed.
class Rng {
 public:
  explicit constexpr Rng(std::uint64_t seed) : state_{seed} {}

  /// An independent stream, named so that adding one user never shifts another's draws:
  /// `Rng{run_seed}.stream("sonar", vehicle)`.
  constexpr Rng stream(std::string_view user, std::uint64_t index = 0) const {
    std::uint64_t h = 14695981039346656037ULL ^ state_;  // FNV-1a
    for (const char c : user) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    return Rng{mix(h ^ mix(index + 0x9E3779B97F4A7C15ULL))};
  }

  constexpr std::uint64_t next() { return mix(state_ += 0x9E3779B97F4A7C15ULL); }  // SplitMix64

  /// Uniform in [lo, hi).
  constexpr double uniform(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(next() >> 11U) * 0x1p-53);
  }

  /// Uniform in 0 .. count - 1; 0 < `count` <= 2^53. The bias is below count * 2^-53.
  constexpr std::uint64_t index(std::uint64_t count) {
    return static_cast<std::uint64_t>(uniform(0.0, static_cast<double>(count)));
  }

  /// Gaussian with mean 0 and standard deviation 1 (Box and Muller, one of the pair).
  double normal() {
    const double u = 1.0 - uniform(0.0, 1.0);
    return std::sqrt(-2.0 * math::log(u)) * math::cos(2.0 * std::numbers::pi * uniform(0.0, 1.0));
  }

  friend constexpr bool operator==(const Rng&, const Rng&) = default;

 private:
  static constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
  }

  std::uint64_t state_;
};

}  // namespace fairway
