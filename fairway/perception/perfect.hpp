// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fairway/avoidance/situation.hpp"
#include "fairway/comms/message.hpp"
#include "fairway/world/obstacle_field.hpp"

namespace fairway {

/// How far perfect perception reaches.
struct Reach {
  double vehicles{};   ///< between centres [m]
  double obstacles{};  ///< from the vehicle's sphere to the surface of what is not charted [m]
};

/// Perfect perception: everyone and everything within range, exact and at once. Holds scratch memory only,
/// so one serves a whole fleet.
class PerfectPerception {
 public:
  explicit PerfectPerception(std::size_t track_count) { near_.reserve(track_count); }

  /// A track for every vehicle but `own_index` and for every drifter within reach, nearest first, ties by id.
  /// Does not allocate once `tracks` has the capacity. O(n log n).
  void perceive(const Mailbox& messages, std::span<const Drifter> drifters, std::size_t own_index,
                const Reach& reach, std::vector<Track>& tracks);

 private:
  struct Near {
    double distance2;
    TrackId id;
    std::size_t index;  ///< of the message; of the drifter from messages.size() on
  };
  std::vector<Near> near_;
};

/// The obstacles that a vehicle at `position` with a sphere of `radius` knows of: those charted, and those
/// within reach. Does not allocate once `known` has the capacity.
void perceive_obstacles(std::span<const Obstacle> obstacles, const Vec3& position, double radius,
                        const Reach& reach, std::vector<Obstacle>& known);

}  // namespace fairway
