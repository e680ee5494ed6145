// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "fairway/record/frame.hpp"

namespace fairway {

/// A word mixed into a hash: two frames that differ in one word always get different hashes, and any two
/// different ones but for a chance of about 2^-64 (the finaliser of SplitMix64: Steele, Lea and Flood 2014).
constexpr std::uint64_t mix_hash(std::uint64_t hash, std::uint64_t word) {
  std::uint64_t z = (hash ^ word) + 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31U);
}

/// The bits of the tick and of everything in every vehicle; not the time and period, which follow from the
/// tick and the stride of recording. -0 and 0 differ. O(vehicles + actuators), no allocation.
std::uint64_t frame_hash(const Frame& frame) noexcept;

/// Likewise of the tick and of every track and echo of every vehicle, which frame_hash() leaves out.
/// O(tracks + echoes), no allocation.
std::uint64_t perception_hash(const Frame& frame) noexcept;

}  // namespace fairway
