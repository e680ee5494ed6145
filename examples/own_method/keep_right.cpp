// SPDX-License-Identifier: Apache-2.0
#include "keep_right.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fairway/core/angles.hpp"

using namespace fairway;

namespace {

/// The least distance to come within `horizon` [s] if both go on [m].
double least_distance(const Vec3& way, const Vec3& closing, double horizon) {
  const double speed_squared = closing.squaredNorm();
  const double nearest = speed_squared > 0.0 ? -way.dot(closing) / speed_squared : 0.0;
  return (way + std::clamp(nearest, 0.0, horizon) * closing).norm();
}

}  // namespace

Command KeepRight::decide(const Situation& s, Memory&, Context& context) const noexcept {
  const Vec3 preferred = s.preferred_velocity();
  const bool is_free = std::ranges::all_of(s.tracks, [&](const Track& track) {
    return least_distance(track.position - s.own.position, track.velocity - preferred, params.horizon_s) >
           s.own.radius + track.radius + params.margin_m;
  });
  if (is_free) return {.velocity = preferred, .mode = Mode::cruise};

  // in north, east, down a turn to starboard is one about the axis that points down
  Vec3 velocity = preferred;
  velocity.head<2>() = turned(preferred.head<2>(), radians(params.turn_deg));
  if (context.sketch != nullptr) context.sketch->velocity(velocity, "to starboard");
  return {.velocity = velocity, .mode = Mode::avoid, .note = "keeps right"};
}
