// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

namespace fairway::ros1 {

/// A thread that notices when the node's loop no longer comes round. It goes by wall time and by the loop
/// alone: a simulation that stands still does not stop the loop, so it is no alarm.
class AvoiderWatchdog {
 public:
  /// `alarm` is called with how long the loop has stood still [s] once that is more than `period` [s], and
  /// then once a period until it comes round again; in the thread of the watchdog.
  AvoiderWatchdog(double period, std::function<void(double)> alarm);
  AvoiderWatchdog(const AvoiderWatchdog&) = delete;
  AvoiderWatchdog& operator=(const AvoiderWatchdog&) = delete;
  ~AvoiderWatchdog();

  /// The loop comes round. Does not lock.
  void come_round() { rounds_.fetch_add(1, std::memory_order_relaxed); }

  /// How often it has raised the alarm.
  std::int64_t alarms() const { return alarms_.load(std::memory_order_relaxed); }

 private:
  void watch();

  std::chrono::duration<double> period_;
  std::function<void(double)> alarm_;
  std::atomic<std::int64_t> rounds_{0};
  std::atomic<std::int64_t> alarms_{0};
  std::mutex mutex_;  // of stopping_ alone
  std::condition_variable stop_;
  bool stopping_{false};
  std::thread thread_;
};

}  // namespace fairway::ros1
