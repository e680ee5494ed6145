// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/perception/sonar/sonar.hpp"

namespace fairway {

/// A sonar without noise, misses and false echoes.
inline SonarParams quiet_sonar() {
  SonarParams params;
  params.echo_range_sigma_m = params.echo_bearing_sigma_deg = params.heading_sigma_deg = 0.0;
  params.missed_ratio = params.false_echoes_count = 0.0;
  return params;
}

inline Mover ball(const Vec3& position, double radius, const Vec3& velocity = Vec3::Zero()) {
  return {.id = TrackId{7}, .position = position, .velocity = velocity, .radius = radius, .silent = true};
}

/// The vehicle that looks, and then what it looks at.
inline std::vector<Mover> movers_round(const VehicleState& own, const std::vector<Mover>& others) {
  std::vector<Mover> movers{{.id = TrackId{0}, .position = own.p_n, .radius = 1.0}};
  movers.insert(movers.end(), others.begin(), others.end());
  return movers;
}

/// The echoes of one ping.
inline std::vector<Echo> echoes_of(const SonarParams& params, const VehicleState& own,
                                   const std::vector<Mover>& others,
                                   const std::vector<Obstacle>& obstacles = {}, Rng rng = Rng{1}) {
  const std::vector<Mover> movers = movers_round(own, others);
  std::vector<Echo> echoes;
  Rng false_rng = rng.stream("false");
  Sonar{params}.ping(own, {.movers = movers, .obstacles = obstacles}, rng, false_rng, echoes);
  return echoes;
}

}  // namespace fairway
