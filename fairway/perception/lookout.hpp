// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "fairway/core/boxed.hpp"
#include "fairway/core/echo.hpp"
#include "fairway/core/kind_info.hpp"
#include "fairway/core/params.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/perception/perfect.hpp"
#include "fairway/perception/sonar_watch.hpp"

namespace fairway {

/// What one vehicle makes of the world round it, by the kind of perception that it has: `perfect`, or
/// `sonar`. A value: a copy is a snapshot.
class Lookout {
 public:
  /// Room for `track_count` tracks is reserved. Throws InputError for an unknown kind or parameter.
  Lookout(std::string_view kind, const ParamValues& params, const Reach& reach, std::size_t track_count,
          Rng rng);

  /// Whether there is anything to let work.
  bool has_sensor() const { return static_cast<bool>(sonar_); }

  /// Lets the sensors work. Called once a tick, whether anyone decides or not. Does not allocate in steady
  /// state.
  void sense(const Scene& scene, const Viewpoint& own);

  /// All that the vehicle knows now: tracks nearest first, ties by id, up to `own.most_tracks`, and
  /// obstacles in the order of the scene, up to `own.farthest_obstacle`; with a sonar, of these only the
  /// charted ones, for others are tracks. `near` is memory to work in. Does not allocate once the vectors
  /// have the capacity.
  void report(const Scene& scene, const Viewpoint& own, std::vector<Near>& near, std::vector<Track>& tracks,
              std::vector<Obstacle>& obstacles);

  /// The echoes of the sonar's last ping; empty without one.
  std::span<const Echo> echoes() const;

 private:
  Reach reach_;
  Boxed<SonarWatch> sonar_;  ///< nothing: perception is perfect
};

/// The kinds of perception that there are.
std::vector<KindInfo> perception_kinds();

}  // namespace fairway
