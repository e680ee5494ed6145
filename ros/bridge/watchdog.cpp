// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/watchdog.hpp"

#include <utility>

namespace fairway::bridge {

Watchdog::Watchdog(double period, std::function<void(double)> alarm)
    : period_{period}, alarm_{std::move(alarm)}, thread_{[this] { watch(); }} {}

Watchdog::~Watchdog() {
  {
    const std::lock_guard lock{mutex_};
    stopping_ = true;
  }
  stop_.notify_all();
  thread_.join();
}

void Watchdog::watch() {
  using Clock = std::chrono::steady_clock;
  std::int64_t seen = -1;
  Clock::time_point moved = Clock::now();
  Clock::time_point alarmed = moved;
  std::unique_lock lock{mutex_};
  while (!stop_.wait_for(lock, period_ / 8, [this] { return stopping_; })) {
    const Clock::time_point now = Clock::now();
    if (const std::int64_t rounds = rounds_.load(std::memory_order_relaxed); rounds != seen) {
      seen = rounds;
      moved = alarmed = now;
    }
    if (now - alarmed < period_) continue;
    alarmed = now;
    lock.unlock();
    alarm_(std::chrono::duration<double>(now - moved).count());
    lock.lock();
  }
}

}  // namespace fairway::bridge
