// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/perfect.hpp"

#include <algorithm>

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

}  // namespace

void PerfectPerception::perceive(const Mailbox& messages, std::size_t own_index, double range,
                                 std::vector<Track>& tracks) {
  const Vec3& here = messages[own_index].position;

  // order by distance first, so that the larger tracks are written once
  near_.clear();
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const double distance2 = (messages[i].position - here).squaredNorm();
    if (i != own_index && distance2 <= range * range) near_.push_back({distance2, i});
  }
  std::ranges::sort(near_, [&](const Near& a, const Near& b) {
    if (a.distance2 != b.distance2) return a.distance2 < b.distance2;
    return number(messages[a.index].from) < number(messages[b.index].from);
  });

  tracks.clear();
  for (const Near& near : near_) tracks.push_back(track_of(messages[near.index]));
}

}  // namespace fairway
