// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/lanes/kernel.hpp"
#include "fairway/avoidance/orca_params.hpp"
#include "fairway/avoidance/parting.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/avoidance/velocity_program/velocity_program.hpp"
#include "fairway/core/lanes/number.hpp"

/// Between situations and the columns of a kernel: one number of each column is at `at`, the next `width`
/// numbers after it.
namespace fairway::orca {

/// Stands in for a speed limit that is not set [m/s]: the velocity program needs a bounded space.
inline constexpr double fastest = 1000.0;

inline void write_columns(const Vec3& position, const Vec3& velocity, double radius, double last,
                          std::size_t width, double* at) {
  at[0] = position.x();
  at[width] = position.y();
  at[2 * width] = position.z();
  at[3 * width] = velocity.x();
  at[4 * width] = velocity.y();
  at[5 * width] = velocity.z();
  at[6 * width] = radius;
  at[7 * width] = last;
}

/// Vehicles share the work of avoiding each other; what does not react leaves all of it to us.
inline void write_neighbour(const Situation& s, const OrcaParams& params, const Track& track,
                            std::size_t width, double* at) {
  const double share = track.reacts ? params.responsibility_ratio : 1.0;
  write_columns(track.position, track.velocity, track.radius,
                std::copysign(share, parting_direction(s.own.id, track.id).x()), width, at);
}

inline void write_nobody(std::size_t width, double* at) {
  write_columns(Vec3::Zero(), Vec3::Zero(), -1.0, 0.0, width, at);
}

/// Writes those within range, as many as count and find room, and returns how many.
inline std::size_t find_neighbours(const Situation& s, const OrcaParams& params,
                                   std::span<const Track*> neighbours) {
  using Vec = lanes::VecOf<double>;
  const Vec position = s.own.position;
  const std::size_t most = std::min(static_cast<std::size_t>(params.max_neighbours_count), neighbours.size());
  const double range2 = params.crit_dist_m * params.crit_dist_m;
  std::size_t count = 0;
  for (const Track& track : s.tracks) {
    const Vec p = Vec{track.position} - position;
    if (dot(p, p) > range2) continue;
    if (count == most) break;
    neighbours[count++] = &track;
  }
  return count;
}

/// Member by member: to make it as a whole is to clear what its optional parts hold.
inline Command command_of(const VelocityChoice& choice) {
  Command command;
  command.velocity = choice.velocity;
  command.mode = choice.is_feasible() ? Mode::avoid : Mode::infeasible;
  command.astern = true;
  return command;
}

}  // namespace fairway::orca
