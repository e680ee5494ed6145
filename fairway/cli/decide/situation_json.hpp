// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "fairway/avoidance/situation.hpp"
#include "fairway/core/params.hpp"

namespace fairway {

/// One line of `fairway decide`, owning what its situation shows. It moves but does not copy: obstacles
/// look at the vertices.
struct DecideRequest {
  DecideRequest() = default;
  DecideRequest(DecideRequest&&) noexcept = default;
  DecideRequest& operator=(DecideRequest&&) noexcept = default;

  Situation without_others;   ///< all but tracks and obstacles
  std::vector<Track> tracks;  ///< nearest first, ties by id
  std::vector<std::vector<Vec3>> vertices;
  std::vector<Obstacle> obstacles;
  ParamValues params;

  /// Valid while this lives.
  Situation situation() const {
    Situation shown = without_others;
    shown.tracks = tracks;
    shown.obstacles = obstacles;
    return shown;
  }
};

/// Reads a line such as
///
///     {"time":0,"period":0.1,"own":{"id":0,"position":[n,e,d],"velocity":[n,e,d],"yaw":0,"radius":1},
///      "goal":{"position":[n,e,d]},"preferred_velocity":[n,e,d],"limits":{"max_speed":0.5},
///      "tracks":[{"id":1,"position":[n,e,d],"velocity":[n,e,d],"radius":1}],
///      "obstacles":[{"kind":"sphere","position":[n,e,d],"radius":2},
///                   {"kind":"segment","from":[n,e,d],"to":[n,e,d]},
///                   {"kind":"polygon","vertices":[[n,e,d],[n,e,d],[n,e,d]]}],
///      "params":{"time_horizon_s":5}}
///
/// in SI units and radians. May be left out: time (0), tracks, obstacles, params, preferred_velocity;
/// own.priority (the id); goal.cruise_speed or goal.speed (limits.max_speed); of the limits all but
/// max_speed; a track's yaw, age (0), priority (its id), destination, reacts (true) and
/// position_covariance and velocity_covariance (zero), of three rows. Throws InputError naming `line` and the
/// path for anything else: unknown or missing keys, wrong types and lengths, numbers that are not finite,
/// negative lengths, matrices that are no covariance, two tracks of one id, polygons that run clockwise.
DecideRequest parse_situation(std::string_view text, std::size_t line);

}  // namespace fairway
