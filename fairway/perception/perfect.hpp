// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "fairway/avoidance/situation.hpp"
#include "fairway/perception/nearest_first.hpp"
#include "fairway/perception/scene.hpp"

namespace fairway {

/// Perfect perception: whoever tells is known by what it tells, everything else that moves within reach is
/// seen exactly and at once. Makes a track for everyone heard of but the own vehicle, and for every silent
/// vehicle and drifter, within reach, nearest first, ties by id, and of these the first `own.most_tracks`.
/// `near` is memory to work in. Does not allocate once both have the capacity. With `scene.places` it costs
/// what is near, and what drifts; O(n log n) without.
void perceive_movers(const Scene& scene, const Viewpoint& own, const Reach& reach, std::vector<Near>& near,
                     std::vector<Track>& tracks);

/// The track of a vehicle that was heard of, predicted from its last message to the time of the scene.
Track track_of(const Message& message, const Scene& scene);

/// The obstacles that a vehicle at `position` with a sphere of `radius` knows of: those charted, and those
/// within reach. Does not allocate once `known` has the capacity.
void perceive_obstacles(std::span<const Obstacle> obstacles, const Vec3& position, double radius,
                        const Reach& reach, std::vector<Obstacle>& known);

}  // namespace fairway
