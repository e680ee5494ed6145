// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "fairway/core/params.hpp"

namespace fairway {

/// The stages of a step of the simulation, in their order.
enum class Stage : std::uint8_t { locate, deliver, perceive, decide, control, record, move };

template <>
struct EnumNames<Stage> {
  static constexpr std::array names{"locate", "deliver", "perceive", "decide", "control", "record", "move"};
};

inline constexpr std::size_t stage_count = EnumNames<Stage>::names.size();

/// How long each stage has taken on this machine: never among the results of a run.
class StageTimes {
 public:
  /// Begins to count; what follows belongs to the first stage that is finished.
  void begin() { last_ = Clock::now(); }
  /// All since the last call was spent in `stage`.
  void finish(Stage stage) {
    const Clock::time_point now = Clock::now();
    seconds_[static_cast<std::size_t>(stage)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }
  /// What another has measured besides.
  void add(const StageTimes& other) {
    for (std::size_t i = 0; i < stage_count; ++i) seconds_[i] += other.seconds_[i];
  }

  /// By stage [s].
  const std::array<double, stage_count>& seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point last_;
  std::array<double, stage_count> seconds_{};
};

}  // namespace fairway
