// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "fairway/avoidance/situation.hpp"
#include "fairway/perception/nearest_first.hpp"
#include "fairway/perception/scene.hpp"

namespace fairway {

/// Perfect perception: whoever tells is known by what it tells, everything else that moves within reach is
/// seen exactly and at once. Holds scratch memory only.
class PerfectPerception {
 public:
  explicit PerfectPerception(std::size_t track_count) { near_.reserve(track_count); }

  /// A track for everyone heard of but the own vehicle, and for every silent vehicle and drifter, within
  /// reach, nearest first, ties by id. Does not allocate once `tracks` has the capacity. O(n log n).
  void perceive(const Scene& scene, const Viewpoint& own, const Reach& reach, std::vector<Track>& tracks);

 private:
  std::vector<Near> near_;
};

/// The track of a vehicle that was heard of, predicted from its last message to the time of the scene.
Track track_of(const Message& message, const Scene& scene);

/// The obstacles that a vehicle at `position` with a sphere of `radius` knows of: those charted, and those
/// within reach. Does not allocate once `known` has the capacity.
void perceive_obstacles(std::span<const Obstacle> obstacles, const Vec3& position, double radius,
                        const Reach& reach, std::vector<Obstacle>& known);

}  // namespace fairway
