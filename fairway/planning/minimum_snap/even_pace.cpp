// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/minimum_snap/even_pace.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/planning/minimum_snap/fit_trajectory.hpp"

namespace fairway {
namespace {

/// Share of the acceleration that the profile of speeds uses; the spline's peaks are higher than its mean.
constexpr double profile_share = 0.4;

/// The point at `distance` along the straight lines of `path`.
Vec2 point_along(std::span<const Vec2> path, double distance) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double length = (path[i + 1] - path[i]).norm();
    if (distance <= length) return path[i] + distance / length * (path[i + 1] - path[i]);
    distance -= length;
  }
  return path.back();
}

std::vector<Vec2> points_along(std::span<const Vec2> path, int pieces) {
  const double length = length_of(path);
  std::vector<Vec2> points{path.front()};
  for (int i = 1; i < pieces; ++i) points.push_back(point_along(path, length * i / pieces));
  points.push_back(path.back());
  return points;
}

/// Time to come `distance` far from rest at constant acceleration, and at full speed from then on.
double time_to(double distance, double speed, double acceleration) {
  const double way = speed * speed / (2.0 * acceleration);
  if (!(distance > way)) return std::sqrt(2.0 * distance / acceleration);
  return std::sqrt(2.0 * way / acceleration) + (distance - way) / speed;
}

/// The time that each piece takes when the path is sped up on, cruised and slowed down on.
std::vector<double> profile(double length, int pieces, const TrajectoryLimits& limits) {
  const double acceleration =
      math::fmin(profile_share * limits.max_acceleration_mps2, 1e3 * limits.max_speed_mps);
  const auto time_at = [&](double s) {
    const double half = 0.5 * length;
    const double up = time_to(math::fmin(s, half), limits.max_speed_mps, acceleration);
    if (s <= half) return up;
    return 2.0 * time_to(half, limits.max_speed_mps, acceleration) -
           time_to(math::fmax(0.0, length - s), limits.max_speed_mps, acceleration);
  };
  std::vector<double> durations;
  for (int i = 0; i < pieces; ++i)
    durations.push_back(time_at(length * (i + 1) / pieces) - time_at(length * i / pieces));
  return durations;
}

}  // namespace

std::optional<PacedTrajectory> evenly_paced(std::span<const Vec2> path, const PlanarMap& map,
                                            const TrajectoryLimits& limits) {
  const double length = length_of(path);
  if (!(length > 0.0)) return {};
  std::optional<PacedTrajectory> best;
  for (const int pieces : {6, 9, 13, 20, 30, 45, 68}) {
    const std::vector<Vec2> points = points_along(path, pieces);
    Trajectory candidate = paced(minimum_snap(points, profile(length, pieces, limits)), limits);
    if (best && candidate.duration() >= best->trajectory.duration()) continue;
    if (least_clearance(candidate, map) < 0.0) continue;
    best = {std::move(candidate), points};
  }
  return best;
}

}  // namespace fairway
