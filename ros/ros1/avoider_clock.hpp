// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace fairway::ros1 {

/// The time that an avoider goes by: the graph's clock, but never behind navigation that has already come.
/// A simulation's clock and its odometry travel by different connections, so either may be first.
class AvoiderClock {
 public:
  /// What the graph's clock shows now [s].
  double at(double clock) {
    if (clock < now_ - restart_s) now_ = clock;  // a simulation has begun again
    return now_ = std::max(now_, clock);
  }

  /// Likewise when navigation of `stamp` [s] comes.
  double at(double clock, double stamp) {
    const double now = at(clock);
    const bool is_early = stamp > now && stamp <= clock + early_s;
    return now_ = is_early ? stamp : now;
  }

  /// It is `now` [s], earlier or later than it was.
  double begin(double now) { return now_ = now; }

  double now() const { return now_; }

 private:
  static constexpr double restart_s = 1.0;
  static constexpr double early_s = 0.1;  // a clock that is behind by so much is still on its way
  double now_{};
};

}  // namespace fairway::ros1
