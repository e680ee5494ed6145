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

/// How long each stage has taken on this machine: never among the results of a run. Does nothing unless on.
class StageTimes {
 public:
  void turn_on() { on_ = true; }
  bool is_on() const { return on_; }

  /// Begins to count; what follows belongs to the first stage that is finished.
  void begin() {
    if (on_) last_ = Clock::now();
  }
  /// All since the last call was spent in `stage`.
  void finish(Stage stage) {
    if (!on_) return;
    const Clock::time_point now = Clock::now();
    seconds_[static_cast<std::size_t>(stage)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

  /// By stage [s].
  const std::array<double, 7>& seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;

  bool on_{false};
  Clock::time_point last_;
  std::array<double, 7> seconds_{};
};

}  // namespace fairway
