// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/perfect.hpp"

namespace fairway {
namespace {

/// Since it was sent [s].
double age_of(const Message& message, const Scene& scene) {
  return scene.time - seconds(message.sent, scene.period);
}

/// Where the sender is by now if it has kept its velocity [m, NED].
Vec3 place_of(const Message& message, const Scene& scene) {
  return message.position + age_of(message, scene) * message.velocity;
}

Track track_of(const Mover& mover) {
  return {.id = mover.id,
          .position = mover.position,
          .velocity = mover.velocity,
          .yaw = yaw_of(mover.q_nb),
          .radius = mover.radius,
          .priority = mover.priority,
          .reacts = mover.reacts};
}

}  // namespace

Track track_of(const Message& message, const Scene& scene) {
  // an unforeseen acceleration a, kept up since, has changed the velocity by a t and moved it by a t^2 / 2
  const double age = age_of(message, scene);
  const double drift = scene.unforeseen_acceleration * age;
  return {.id = TrackId{number(message.from)},
          .position = place_of(message, scene),
          .velocity = message.velocity,
          .yaw = message.yaw,
          .radius = message.radius,
          .age = age,
          .priority = message.priority,
          .destination = message.destination,
          .position_covariance = 0.25 * age * age * drift * drift * Mat3::Identity(),
          .velocity_covariance = drift * drift * Mat3::Identity()};
}

void PerfectPerception::perceive(const Scene& scene, const Viewpoint& own, const Reach& reach,
                                 std::vector<Track>& tracks) {
  const Vec3& here = own.estimate.p_n;
  const TrackId self = scene.movers[scene.own_index].id;

  near_.clear();
  for (std::size_t i = 0; i < scene.heard.size(); ++i) {
    const Message& message = scene.heard[i];
    const TrackId id{number(message.from)};
    const double distance2 = (place_of(message, scene) - here).squaredNorm();
    if (message.told && id != self && distance2 <= reach.vehicles * reach.vehicles)
      near_.push_back({distance2, id, i});
  }
  for (std::size_t i = 0; i < scene.movers.size(); ++i) {
    const Mover& mover = scene.movers[i];
    if (!mover.silent || i == scene.own_index) continue;
    const double distance2 = (mover.position - here).squaredNorm();
    const double range = mover.is_vehicle ? reach.vehicles : reach.obstacles + own.radius + mover.radius;
    if (distance2 <= range * range) near_.push_back({distance2, mover.id, scene.heard.size() + i});
  }
  sort_nearest_first(near_);

  tracks.clear();
  for (const Near& near : near_) {
    const bool heard = near.index < scene.heard.size();
    tracks.push_back(heard ? track_of(scene.heard[near.index], scene)
                           : track_of(scene.movers[near.index - scene.heard.size()]));
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
