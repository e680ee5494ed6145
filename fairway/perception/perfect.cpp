// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/perfect.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "fairway/core/math.hpp"

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

/// Makes the covariances zero. Mostly they are, and to see that takes less than to write eighteen numbers: of
/// one that is not, something stands on the diagonal.
void forget_errors(Track& track) {
  if (track.position_covariance.trace() + track.velocity_covariance.trace() == 0.0) return;
  track.position_covariance.setZero();
  track.velocity_covariance.setZero();
}

/// Makes `track` that of what is seen.
void write(const Mover& mover, Track& track) {
  track = {.id = mover.id,
           .position = mover.position,
           .velocity = mover.velocity,
           .yaw = yaw_of(mover.q_nb),
           .radius = mover.radius,
           .priority = mover.priority,
           .reacts = mover.reacts};
}

/// Makes `track` that of who was heard of.
void write(const Message& message, const Scene& scene, Track& track) {
  // an unforeseen acceleration a, kept up since, has changed the velocity by a t and moved it by a t^2 / 2
  const double age = age_of(message, scene);
  const double drift = scene.unforeseen_acceleration * age;
  track.id = TrackId{number(message.from)};
  track.position = place_of(message, scene);
  track.velocity = message.velocity;
  track.yaw = message.yaw;
  track.radius = message.radius;
  track.age = age;
  track.priority = message.priority;
  track.destination = message.destination;
  track.reacts = true;
  if (drift == 0.0) {  // as always where all is told at once
    forget_errors(track);
  } else {
    track.position_covariance = 0.25 * age * age * drift * drift * Mat3::Identity();
    track.velocity_covariance = drift * drift * Mat3::Identity();
  }
}

/// Whoever was heard of within reach, but the own vehicle; `index` is that of the message.
void add_heard(const Scene& scene, const Viewpoint& own, const Reach& reach, std::vector<Near>& near) {
  const TrackId self = scene.movers[scene.own_index].id;
  for (std::size_t i = 0; i < scene.heard.size(); ++i) {
    const Message& message = scene.heard[i];
    const TrackId id{number(message.from)};
    const double distance2 = (place_of(message, scene) - own.estimate.p_n).squaredNorm();
    if (message.tells_place() && id != self && distance2 <= reach.vehicles * reach.vehicles)
      near.push_back({distance2, id, i});
  }
}

/// The vehicles within reach that were sorted by place; of one that is seen, `index` follows the messages.
void add_places(const Scene& scene, const Viewpoint& own, const Reach& reach, std::vector<Near>& near) {
  const Vicinity& places = *scene.places;
  const Vec3& here = own.estimate.p_n;
  double farthest = reach.vehicles;
  if (own.most_tracks < places.size() && farthest > places.sure_reach(scene.own_index, here))
    farthest = math::fmin(farthest, places.reach_of(own.most_tracks, scene.own_index, here));
  places.visit_others(scene.own_index, here, farthest, [&](std::size_t i, double distance2) {
    if (scene.heard_at_once && scene.heard[i].tells_place()) {
      near.push_back({distance2, TrackId{number(scene.heard[i].from)}, i});
    } else {
      near.push_back({distance2, scene.movers[i].id, scene.heard.size() + i});
    }
  });
}

/// What drifts and, where nobody was sorted by place, the silent vehicles.
void add_seen(const Scene& scene, const Viewpoint& own, const Reach& reach, std::vector<Near>& near) {
  const bool drifters_alone = scene.places != nullptr;
  for (std::size_t i = scene.movers.size(); i-- > 0;) {
    const Mover& mover = scene.movers[i];
    if (drifters_alone && mover.is_vehicle) return;
    if (!mover.silent || (mover.is_vehicle && i == scene.own_index)) continue;
    const double distance2 = (mover.position - own.estimate.p_n).squaredNorm();
    const double range = mover.is_vehicle ? reach.vehicles : reach.obstacles + own.radius + mover.radius;
    if (distance2 <= range * range) near.push_back({distance2, mover.id, scene.heard.size() + i});
  }
}

constexpr double endless = std::numeric_limits<double>::infinity();

/// Makes `near` the indices of the obstacles of which `is_known` is true, ascending. False where nobody has
/// sorted them or there are many of these.
template <class IsKnown>
bool pick_out(const Scene& scene, const Viewpoint& own, const Reach& reach, const IsKnown& is_known,
              std::vector<Near>& near) {
  if (scene.indexes == nullptr) return false;
  const std::size_t most = most_picked_out(scene.obstacles.size());
  bool all_found = true;
  near.clear();
  const auto add = [&](const ObstacleIndex& index, double farthest) {
    index.visit(own.estimate.p_n, farthest, [&](std::size_t i) {
      if (all_found && is_known(scene.obstacles[i])) {
        all_found = near.size() < most;
        if (all_found) near.push_back({0.0, {}, i});
      }
      return all_found ? farthest : -1.0;
    });
  };
  add(scene.indexes->charted, own.farthest_obstacle);
  if (all_found)
    add(scene.indexes->uncharted, math::fmin(own.farthest_obstacle, reach.obstacles + own.radius));
  std::ranges::sort(near, {}, &Near::index);
  return all_found;
}

}  // namespace

Track track_of(const Message& message, const Scene& scene) {
  Track track;
  write(message, scene, track);
  return track;
}

// called for everyone who decides: all of it is compiled into one
[[gnu::flatten]] void perceive_movers(const Scene& scene, const Viewpoint& own, const Reach& reach,
                                      std::vector<Near>& near, std::vector<Track>& tracks) {
  near.clear();
  if (!scene.heard_at_once) add_heard(scene, own, reach, near);
  if (scene.places != nullptr) add_places(scene, own, reach, near);
  add_seen(scene, own, reach, near);
  sort_nearest_first(near, own.most_tracks);

  tracks.resize(near.size());
  for (std::size_t k = 0; k < near.size(); ++k) {
    const std::size_t index = near[k].index;
    if (index < scene.heard.size()) {
      write(scene.heard[index], scene, tracks[k]);
    } else {
      write(scene.movers[index - scene.heard.size()], tracks[k]);
    }
  }
}

void perceive_obstacles(const Scene& scene, const Viewpoint& own, const Reach& reach, std::vector<Near>& near,
                        std::vector<Obstacle>& known) {
  known.clear();
  if (own.farthest_obstacle == -endless) return;
  const auto is_known = [&](const Obstacle& obstacle) {
    if (obstacle.charted && own.farthest_obstacle == endless) return true;
    const double distance = nearest_point(obstacle, own.estimate.p_n).distance;
    return distance <= own.farthest_obstacle &&
           (obstacle.charted || distance - own.radius <= reach.obstacles);
  };
  if (pick_out(scene, own, reach, is_known, near)) {
    for (const Near& each : near) known.push_back(scene.obstacles[each.index]);
  } else {
    std::ranges::copy_if(scene.obstacles, std::back_inserter(known), is_known);
  }
}

}  // namespace fairway
