// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/situation.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "fairway/core/envelope_numbers.hpp"

namespace fairway {
namespace {

bool is_length(double value) { return value >= 0.0 && value <= std::numeric_limits<double>::max(); }

bool is_usable(const Track& track) {
  return is_finite(track.position) && is_finite(track.velocity) && is_length(track.radius) &&
         0.0 * (track.position_covariance + track.velocity_covariance).sum() == 0.0;
}

/// The bits of nine numbers, one over the other: none is set if all are zero.
std::uint64_t bits_of(const Mat3& matrix) {
  std::uint64_t bits = 0;
  for (const double number : matrix.reshaped()) bits |= std::bit_cast<std::uint64_t>(number);
  return bits;
}

/// Whether each can be used. Every decision asks, so all are added up first: a sum is finite only if all that
/// is in it are. Mostly all covariances are zero, which is seen sooner. What does not add up is looked at one
/// by one, since finite numbers too may overflow.
bool are_usable(std::span<const Track> tracks) {
  std::uint64_t covariances = 0;  // bits
  Vec3 vectors = Vec3::Zero();
  double radii = 0.0, least = 0.0;
  for (const Track& track : tracks) {
    covariances |= bits_of(track.position_covariance) | bits_of(track.velocity_covariance);
    vectors += track.position + track.velocity;
    radii += track.radius;
    least = std::min(least, track.radius);
  }
  Mat3 errors = Mat3::Zero();
  if (covariances != 0)
    for (const Track& track : tracks) errors += track.position_covariance + track.velocity_covariance;
  if (0.0 * (errors.sum() + vectors.sum() + radii) == 0.0 && least == 0.0) return true;
  return std::ranges::all_of(tracks, [](const Track& track) { return is_usable(track); });
}

}  // namespace

std::string_view why_unusable(const Situation& s) noexcept {
  if (!std::isfinite(s.time)) return "the time is not finite";
  if (!(s.period > 0.0) || !std::isfinite(s.period)) return "the period is not a positive number";
  if (!is_finite(s.own.position)) return "the own position is not finite";
  if (!is_finite(s.own.velocity)) return "the own velocity is not finite";
  if (!is_finite(s.current)) return "the current is not finite";
  if (!std::isfinite(s.own.yaw) || !std::isfinite(s.own.yaw_rate))
    return "the own yaw or its rate is not finite";
  if (!is_length(s.own.radius)) return "the own radius is not a length";
  if (!is_length(s.own.position_sigma)) return "the deviation of the own position is not a length";
  if (!is_finite(s.goal.position)) return "the goal's position is not finite";
  if (s.goal.velocity && !is_finite(*s.goal.velocity)) return "the goal's velocity is not finite";
  if (!is_length(s.goal.cruise_speed)) return "the cruise speed is not a speed";
  if (!is_length(s.goal.arrival)) return "the goal's arrival is not a length";
  if (!(s.limits.max_speed >= 0.0)) return "the speed limit is not a speed";
  if (!(s.limits.max_climb_rate >= 0.0)) return "the limit of climbing is not a speed";
  if (!(s.limits.max_acceleration >= 0.0)) return "the limit of acceleration is not one";
  if (!(s.limits.max_turn_rate >= 0.0)) return "the limit of turning is not a turn rate";
  if (!(s.limits.min_depth <= s.limits.max_depth)) return "the ceiling is not above the floor";
  if (!is_length(s.limits.min_speed)) return "the least speed is not a speed";
  if (!are_usable(s.tracks)) return "a track has a number that is not finite, or no radius";
  if (!std::ranges::all_of(s.obstacles, has_shape))
    return "an obstacle has a number that is not finite, or no extent";
  if (s.envelope != nullptr) return why_unusable(*s.envelope);
  return {};
}

}  // namespace fairway
