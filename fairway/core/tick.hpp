// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace fairway {

/// Simulation time as a count of base steps. Seconds are always `tick * h`, never summed.
enum class Tick : std::int64_t {};

constexpr std::int64_t count(Tick tick) { return static_cast<std::int64_t>(tick); }
constexpr Tick next(Tick tick) { return Tick{count(tick) + 1}; }
constexpr double seconds(Tick tick, double h) { return static_cast<double>(count(tick)) * h; }

}  // namespace fairway
