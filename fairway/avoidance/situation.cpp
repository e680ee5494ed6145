// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/situation.hpp"

#include <algorithm>
#include <limits>

namespace fairway {
namespace {

bool is_length(double value) { return value >= 0.0 && value <= std::numeric_limits<double>::max(); }

/// Of numbers whose sum does not overflow; one test for all of them, since every decision asks it of every
/// track.
bool has_finite_sum(const Mat3& a, const Mat3& b) { return 0.0 * (a + b).sum() == 0.0; }

bool is_usable(const Track& track) {
  return is_finite(track.position) && is_finite(track.velocity) && is_length(track.radius) &&
         has_finite_sum(track.position_covariance, track.velocity_covariance);
}

bool is_usable(const Obstacle& obstacle) {
  switch (obstacle.kind) {
    case Obstacle::Kind::sphere:
      return is_finite(obstacle.position) && is_length(obstacle.radius);
    case Obstacle::Kind::segment:
      return is_finite(obstacle.from) && is_finite(obstacle.to);
    case Obstacle::Kind::polygon:
      return obstacle.vertices.size() >= 3 &&
             std::ranges::all_of(obstacle.vertices, [](const Vec3& v) { return is_finite(v); });
  }
  return false;
}

}  // namespace

bool is_usable(const Situation& s) noexcept {
  return s.period > 0.0 && std::isfinite(s.period) && is_finite(s.own.position) &&
         is_finite(s.own.velocity) && std::isfinite(s.own.yaw) && std::isfinite(s.own.yaw_rate) &&
         is_length(s.own.radius) && is_finite(s.goal.position) &&
         (!s.goal.velocity || is_finite(*s.goal.velocity)) && is_length(s.goal.cruise_speed) &&
         s.limits.max_speed >= 0.0 && s.limits.max_climb_rate >= 0.0 &&
         s.limits.min_depth <= s.limits.max_depth &&
         std::ranges::all_of(s.tracks, [](const Track& t) { return is_usable(t); }) &&
         std::ranges::all_of(s.obstacles, [](const Obstacle& o) { return is_usable(o); });
}

}  // namespace fairway
