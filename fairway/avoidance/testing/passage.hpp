// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway::encounters {

/// How a vehicle does as it is told, and until when.
struct Trip {
  double duration{};  ///< at the most [s]
  double lag{0.0};    ///< of velocities, of the first order [s]
  double reach{1.0};  ///< it has arrived this near to the goal [m]
  double sight{1e9};  ///< of what moves and what no chart shows, from its sphere [m]
};

/// What came of it.
struct Passage {
  double clearance = 1e9;         ///< least, between own sphere and every surface [m]
  std::optional<double> arrival;  ///< [s]
  double length = 0.0;            ///< of the way [m]
  double fastest = 0.0;           ///< commanded [m/s]
  int changes = 0;                ///< of mode
  int avoiding = 0;               ///< decisions
  int infeasible = 0;             ///< decisions
};

/// From own ship to the surface of what is there, less its own radius [m].
inline double gap_to(const Obstacle& o, const Ownship& own) {
  return nearest_point(o, own.position).distance - own.radius;
}
inline double gap_to(const Track& t, const Ownship& own) {
  return (t.position - own.position).norm() - t.radius - own.radius;
}

/// Carries out velocities until the vehicle has arrived; tracks keep theirs.
inline Passage passage(OwnedSituation e, Avoider avoider, const Trip& trip) {
  Passage p;
  Situation& s = e.situation;
  Ownship& own = s.own;
  const double kept = trip.lag > 0.0 ? std::exp(-s.period / trip.lag) : 0.0;
  Mode mode = Mode::cruise;
  for (int k = 0; k < static_cast<int>(trip.duration / s.period) && !p.arrival; ++k) {
    s.time = k * s.period;
    OwnedSituation seen = e;
    std::erase_if(seen.obstacles,
                  [&](const Obstacle& o) { return !o.charted && gap_to(o, own) > trip.sight; });
    std::erase_if(seen.tracks, [&](const Track& t) { return gap_to(t, own) > trip.sight; });
    const Command command = avoider.decide(seen.sorted());
    p.changes += command.mode == mode ? 0 : 1;
    mode = command.mode;
    p.avoiding += mode == Mode::avoid ? 1 : 0;
    p.infeasible += mode == Mode::infeasible ? 1 : 0;
    p.fastest = std::fmax(p.fastest, command.velocity.norm());

    // v = command + (v_0 - command) e^(-t / lag), integrated over the period
    const Vec3 excess = own.velocity - command.velocity;
    const Vec3 way = s.period * command.velocity + trip.lag * (1.0 - kept) * excess;
    own.position += way;
    own.velocity = command.velocity + kept * excess;
    p.length += way.norm();
    for (Track& t : e.tracks) {
      t.position += s.period * t.velocity;
      p.clearance = std::fmin(p.clearance, gap_to(t, own));
    }
    for (const Obstacle& o : e.obstacles) p.clearance = std::fmin(p.clearance, gap_to(o, own));
    if ((own.position - s.goal.position).norm() <= trip.reach) p.arrival = s.time;
  }
  return p;
}

}  // namespace fairway::encounters
