// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/live/live_run.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"

namespace fairway {
namespace {

using namespace std::chrono_literals;

constexpr auto stop_is_seen_within = 50ms;  // a signal handler can set a flag and wake nobody
constexpr auto forgiven_delay = 250ms;
constexpr double farthest_s = 1e8;  // three years: what is due later, at next to no speed, is due then

}  // namespace

LiveRun::LiveRun(const Scenario& scenario, LivePace pace, const FilmLimits& limits, const Catalog* avoiders)
    : pace_{pace}, film_{scenario, limits, avoiders} {}

LiveRun::Clock::time_point LiveRun::due_at(double time) {
  const Clock::time_point now = Clock::now();
  if (pace_.speed <= 0.0) return now;
  const auto due = [&] {
    const double wait = math::fmin((time - from_time_) / pace_.speed, farthest_s);
    return from_clock_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wait));
  };
  if (!timed_ || now - due() > forgiven_delay) {
    timed_ = true;
    from_time_ = time;
    from_clock_ = now;
  }
  return due();
}

bool LiveRun::await_turn(double time, const std::atomic<bool>& stop) {
  std::unique_lock lock{mutex_};
  while (!stop.load(std::memory_order_relaxed)) {
    if (!begun_) return true;
    auto wake = Clock::now() + stop_is_seen_within;
    if (!pace_.paused) {
      const Clock::time_point due = due_at(time);
      if (due <= Clock::now()) return true;
      wake = std::min(wake, due);
    } else if (steps_ > 0) {
      --steps_;
      return true;
    }
    changed_.wait_until(lock, wake);
  }
  return false;
}

void LiveRun::write(const Frame& frame) {
  const std::scoped_lock lock{mutex_};
  film_.write(frame);
  time_ = frame.time;
  begun_ = true;
}

void LiveRun::finish(std::string_view divergence) {
  const std::scoped_lock lock{mutex_};
  film_.finish(divergence);
  done_ = true;
}

void LiveRun::pause() {
  const std::scoped_lock lock{mutex_};
  pace_.paused = true;
}

void LiveRun::resume() {
  {
    const std::scoped_lock lock{mutex_};
    if (!pace_.paused) return;
    pace_.paused = false;
    timed_ = false;
    steps_ = 0;
  }
  changed_.notify_all();
}

bool LiveRun::step() {
  {
    const std::scoped_lock lock{mutex_};
    if (!pace_.paused || done_) return false;
    ++steps_;
  }
  changed_.notify_all();
  return true;
}

nlohmann::json LiveRun::part(std::size_t first, std::size_t generation) const {
  const std::scoped_lock lock{mutex_};
  if (generation != film_.generation() || first > film_.size()) first = 0;
  nlohmann::json part;
  if (first < film_.size()) part = film_.part(first, most_frames, Packing::plain);
  return {{"part", std::move(part)},
          {"state",
           {{"paused", pace_.paused && !done_},
            {"done", done_},
            {"time_s", time_},
            {"speed", pace_.speed},
            {"divergence", film_.divergence()}}}};
}

}  // namespace fairway
