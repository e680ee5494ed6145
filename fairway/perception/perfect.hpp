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

/// The obstacles that the vehicle knows of, those charted and those within reach, in the order of the scene;
/// none that is farther than `own.farthest_obstacle`. `near` is memory to work in, and holds no more than
/// `most_picked_out` of the scene. Does not allocate once both have the capacity. With `scene.indexes` it
/// costs what is known and near; O(obstacles) without, and where much is known.
void perceive_obstacles(const Scene& scene, const Viewpoint& own, const Reach& reach, std::vector<Near>& near,
                        std::vector<Obstacle>& known);

/// Where more of so many obstacles are known, all are gone through one by one, which is sooner than to put
/// what is found in order.
constexpr std::size_t most_picked_out(std::size_t obstacle_count) { return obstacle_count / 8 + 1; }

}  // namespace fairway
