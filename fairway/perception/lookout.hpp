// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "fairway/core/echo.hpp"
#include "fairway/core/params.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/perception/perfect.hpp"

namespace fairway {

/// What one vehicle makes of the world round it, by the kind of perception that it has: `perfect`. A value: a
/// copy is a snapshot.
class Lookout {
 public:
  /// Room for `track_count` tracks is reserved. Throws InputError for an unknown kind or parameter.
  Lookout(std::string_view kind, const ParamValues& params, const Reach& reach, std::size_t track_count,
          Rng rng);

  /// Lets the sensors work. Called once a tick, whether anyone decides or not. Does not allocate in steady
  /// state.
  void sense(const Scene& scene, const Viewpoint& own);

  /// All that the vehicle knows now: tracks nearest first, ties by id, and obstacles. Does not allocate once
  /// the vectors have the capacity.
  void report(const Scene& scene, const Viewpoint& own, std::vector<Track>& tracks,
              std::vector<Obstacle>& obstacles);

  /// Of the sonar's last ping; empty without one.
  std::span<const Echo> echoes() const { return {}; }

 private:
  Reach reach_;
  PerfectPerception perfect_;
};

}  // namespace fairway
