// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

namespace fairway::bridge {

/// A thread that notices when a node's loop no longer comes round. It goes by wall time and by the loop
/// alone: a simulation that stands still does not stop the loop, so it is no alarm.
class Watchdog {
 public:
  /// `alarm` is called, in the watchdog's thread, with how long the loop has stood still [s], once that is
  /// more than `period` [s], and then once a period until it comes round again.
  Watchdog(double period, std::function<void(double)> alarm);
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;
  ~Watchdog();

  /// The loop comes round. Does not lock.
  void come_round() { rounds_.fetch_add(1, std::memory_order_relaxed); }

 private:
  void watch();

  std::chrono::duration<double> period_;
  std::function<void(double)> alarm_;
  std::atomic<std::int64_t> rounds_{0};
  std::mutex mutex_;  // of stopping_ alone
  std::condition_variable stop_;
  bool stopping_{false};
  std::thread thread_;
};

}  // namespace fairway::bridge
