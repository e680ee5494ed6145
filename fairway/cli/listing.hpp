// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "fairway/experiment/executor.hpp"
#include "fairway/experiment/progress.hpp"

namespace fairway::cli {

/// Watches the listing of many runs (WatchListing): draws how far it is where it takes longer than a moment,
/// and throws RunAbandoned once the program is to stop.
class Listing {
 public:
  Listing(const std::string& name, const std::atomic<bool>* stop)
      : name_{"listing " + name}, stop_{stop}, began_{Clock::now()} {}
  ~Listing() {
    if (progress_) progress_->end(count_);
  }
  Listing(const Listing&) = delete;
  Listing& operator=(const Listing&) = delete;

  void operator()(std::size_t listed, std::size_t of) {
    if (stop_->load(std::memory_order_relaxed)) throw RunAbandoned{};
    if (progress_) {
      count_.made = listed - count_.present;
      progress_->update(count_);
    } else if (Clock::now() - began_ > std::chrono::seconds{1}) {
      count_ = {.total = of, .present = listed};
      progress_.emplace(name_).begin(count_);
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::string name_;
  const std::atomic<bool>* stop_;
  Clock::time_point began_;
  std::optional<Progress> progress_;
  ProgressCount count_;
};

}  // namespace fairway::cli
