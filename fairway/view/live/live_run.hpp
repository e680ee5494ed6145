// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string_view>

#include "fairway/record/frame.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/view/film.hpp"

namespace fairway {

/// How a run that is watched begins.
struct LivePace {
  double speed{1.0};   ///< seconds of the run per second of the clock; 0: as fast as it can
  bool paused{false};  ///< once its first frame is there
};

/// A run between two threads: one makes it, at a pace, and the other shows what there is of it. The one that
/// makes it holds the lock once before each step and once for each frame, and while a part is cut out, it
/// waits. Nothing here reaches the run itself: it is only told when to go on.
class LiveRun final : public FrameSink {
 public:
  /// The scenario must outlive it, and `avoiders` as a Film has them.
  LiveRun(const Scenario& scenario, LivePace pace, const FilmLimits& limits = {},
          const Catalog* avoiders = nullptr);

  // For the thread that makes the run.

  /// Waits until the step at `time` [s] of the run is due. False, within 50 ms, once `stop` is set.
  bool await_turn(double time, const std::atomic<bool>& stop);
  void write(const Frame& frame) override;
  /// The run is over; what there is of it can still be seen. `divergence` is how it broke, in a line; empty
  /// if it is whole.
  void finish(std::string_view divergence = {});

  // For everyone, at any time.

  void pause();
  void resume();
  /// One more step of a run that is paused. False, and nothing happens, if it is not or is over.
  bool step();

  /// {"part", "state"}: at most `most_frames` frames from `first` on, or null where there are none yet, and
  /// how the run stands. Where `first` is not of this film as it is now, by its generation, from the
  /// beginning. O(part).
  nlohmann::json part(std::size_t first, std::size_t generation) const;

  static constexpr std::size_t most_frames = 500;

 private:
  using Clock = std::chrono::steady_clock;

  /// When the step at `time` is due. A machine that cannot keep up owes nothing later.
  Clock::time_point due_at(double time);

  LivePace pace_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Film film_;
  bool begun_{false};
  bool done_{false};
  bool timed_{false};     // whether the two below say when it goes at its speed
  std::size_t steps_{0};  // asked for and not yet made
  double time_{0.0};      // of the newest frame
  double from_time_{0.0};
  Clock::time_point from_clock_;
};

}  // namespace fairway
