// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "ros/bridge/plain.hpp"

namespace fairway::ros1 {

/// Lockstep: keeps the last motion of everyone until all are of one instant. Messages of different vehicles
/// travel by different connections, so an avoider may have a mate's of now and its own of a second ago.
class AvoiderGate {
 public:
  explicit AvoiderGate(std::size_t vehicles) : latest_(vehicles) {
    for (bridge::Motion& motion : latest_) motion.time = std::numeric_limits<double>::quiet_NaN();
  }

  void hear(std::size_t vehicle, const bridge::Motion& motion) { latest_[vehicle] = motion; }

  /// Whether everyone's motion is of one instant, and it did not open for that one before.
  bool opens() {
    const double time = latest_.front().time;
    const bool together = std::all_of(latest_.begin(), latest_.end(),
                                      [time](const bridge::Motion& motion) { return motion.time == time; });
    if (!together || time == opened_) return false;
    opened_ = time;
    return true;
  }

  /// Whether it has opened for the instant that vehicle 0 is in.
  bool is_open() const { return latest_.front().time == opened_; }

  const bridge::Motion& motion(std::size_t vehicle) const { return latest_[vehicle]; }

 private:
  std::vector<bridge::Motion> latest_;
  double opened_{std::numeric_limits<double>::quiet_NaN()};  // [s]
};

}  // namespace fairway::ros1
