// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/sonar_watch.hpp"

#include <cmath>

#include "fairway/perception/perfect.hpp"

namespace fairway {

SonarWatch::SonarWatch(const ParamValues& params, std::size_t told_count, Rng rng)
    : SonarWatch{params_of<SonarWatchParams>(params), told_count, rng} {}

SonarWatch::SonarWatch(const SonarWatchParams& params, std::size_t told_count, Rng rng)
    : rate_{params.rate_hz},
      sonar_{params},
      finder_{params},
      tracker_{params},
      merge_{params, static_cast<std::size_t>(params.max_tracks_count), told_count},
      echo_rng_{rng.stream("sonar_echoes")},
      false_rng_{rng.stream("sonar_false_echoes")} {
  const std::size_t known_count = told_count + static_cast<std::size_t>(params.max_tracks_count);
  echoes_.reserve(echo_capacity(params));
  contacts_.reserve(echo_capacity(params));
  seen_.reserve(static_cast<std::size_t>(params.max_tracks_count));
  known_.reserve(known_count);
  near_.reserve(known_count);
}

void SonarWatch::sense(const Scene& scene, const Viewpoint& own) {
  const double turns = scene.time * rate_ + 1e-9;
  if (turns < pings_) return;
  pings_ = std::floor(turns) + 1.0;

  sonar_.ping(own.truth, scene, echo_rng_, false_rng_, echoes_);
  finder_.find(echoes_, scene.obstacles, own.estimate, contacts_);
  tracker_.update(scene.time, contacts_, sonar_.fan(own.estimate));
}

void SonarWatch::report(const Scene& scene, const Viewpoint& own, const Reach& reach,
                        std::vector<Track>& tracks) {
  const Vec3& here = own.estimate.p_n;
  const TrackId self = scene.movers[scene.own_index].id;
  known_.clear();
  for (const Message& message : scene.heard) {
    if (!message.tells_place() || TrackId{number(message.from)} == self) continue;
    const Track track = track_of(message, scene);
    if ((track.position - here).norm() <= reach.vehicles) known_.push_back(track);
  }
  seen_.clear();
  tracker_.report(scene.time, seen_);
  merge_.merge(seen_, known_);

  near_.clear();
  for (std::size_t i = 0; i < known_.size(); ++i)
    near_.push_back({(known_[i].position - here).squaredNorm(), known_[i].id, i});
  sort_nearest_first(near_);
  tracks.clear();
  tracks.reserve(known_.capacity());
  for (const Near& near : near_) tracks.push_back(known_[near.index]);
}

}  // namespace fairway
