// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/perfect.hpp"

#include <algorithm>
#include <limits>

namespace fairway {
namespace {

Track track_of(const Message& message) {
  return {.id = TrackId{number(message.from)},
          .position = message.position,
          .velocity = message.velocity,
          .yaw = message.yaw,
          .radius = message.radius,
          .age = 0.0,
          .priority = message.priority,
          .destination = message.destination};
}

/// Apart from those of vehicles, which count from 0.
TrackId id_of(const Drifter& drifter) { return TrackId{0x8000'0000U + drifter.number}; }

/// It goes first, since it does not give way.
Track track_of(const Drifter& drifter) {
  return {.id = id_of(drifter),
          .position = drifter.position,
          .velocity = drifter.velocity,
          .radius = drifter.radius,
          .priority = std::numeric_limits<std::int32_t>::min(),
          .reacts = false};
}

}  // namespace

void PerfectPerception::perceive(const Mailbox& messages, std::span<const Drifter> drifters,
                                 std::size_t own_index, const Reach& reach, std::vector<Track>& tracks) {
  const Vec3& here = messages[own_index].position;

  // order by distance first, so that the larger tracks are written once
  near_.clear();
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const double distance2 = (messages[i].position - here).squaredNorm();
    if (i != own_index && distance2 <= reach.vehicles * reach.vehicles)
      near_.push_back({distance2, TrackId{number(messages[i].from)}, i});
  }
  for (std::size_t i = 0; i < drifters.size(); ++i) {
    const double distance2 = (drifters[i].position - here).squaredNorm();
    const double range = reach.obstacles + messages[own_index].radius + drifters[i].radius;
    if (distance2 <= range * range) near_.push_back({distance2, id_of(drifters[i]), messages.size() + i});
  }
  std::ranges::sort(near_, [](const Near& a, const Near& b) {
    if (a.distance2 != b.distance2) return a.distance2 < b.distance2;
    return number(a.id) < number(b.id);
  });

  tracks.clear();
  for (const Near& near : near_) {
    const bool vehicle = near.index < messages.size();
    tracks.push_back(vehicle ? track_of(messages[near.index])
                             : track_of(drifters[near.index - messages.size()]));
  }
}

void perceive_obstacles(std::span<const Obstacle> obstacles, const Vec3& position, double radius,
                        const Reach& reach, std::vector<Obstacle>& known) {
  known.clear();
  for (const Obstacle& obstacle : obstacles) {
    const bool seen =
        obstacle.charted || nearest_point(obstacle, position).distance - radius <= reach.obstacles;
    if (seen) known.push_back(obstacle);
  }
}

}  // namespace fairway
