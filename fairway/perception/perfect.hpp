// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "fairway/avoidance/situation.hpp"
#include "fairway/comms/message.hpp"

namespace fairway {

/// Perfect perception: everyone within range, exact and at once. Holds scratch memory only, so one
/// serves a whole fleet.
class PerfectPerception {
 public:
  explicit PerfectPerception(std::size_t fleet_size) { near_.reserve(fleet_size); }

  /// A track for every vehicle but `own_index` within `range` [m], nearest first, ties by id. Does not
  /// allocate once `tracks` has the capacity. O(n log n).
  void perceive(const Mailbox& messages, std::size_t own_index, double range, std::vector<Track>& tracks);

 private:
  struct Near {
    double distance2;
    std::size_t index;
  };
  std::vector<Near> near_;
};

}  // namespace fairway
