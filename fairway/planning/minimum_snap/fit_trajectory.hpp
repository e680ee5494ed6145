// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/planning/minimum_snap/minimum_snap.hpp"
#include "fairway/planning/planar_map.hpp"

namespace fairway {

/// Where a trajectory comes closest to the obstacles of a map.
struct ClosestPass {
  double clearance_m{};   ///< there; nowhere is it less by more than the tolerance asked for
  std::size_t segment{};  ///< of the trajectory
  double s{};             ///< normalised time in the segment
};

/// How finely clearances are searched: no violation larger than this is missed [m].
inline constexpr double clearance_tolerance_m = 1e-3;

/// The closest pass of one segment. A piece of the curve is left alone if its clearance, by the convex hull
/// of its control points, cannot be less than what is known by more than `clearance_tolerance_m`, or is
/// `enough_m` anyway: no assumption about sampling enters. In open water the clearance is infinite.
ClosestPass closest_pass(const Trajectory& trajectory, std::size_t segment, const PlanarMap& map,
                         double enough_m) noexcept;

/// Least clearance of the whole trajectory, to `clearance_tolerance_m` [m].
double least_clearance(const Trajectory& trajectory, const PlanarMap& map) noexcept;

struct FitOptions {
  TrajectoryLimits limits;
  double segment_time_s{0.0};  ///< for each segment of the path; 0: by length and at the pace of the limits
  Joining joining{Joining::smooth};
};

enum class FitStatus {
  as_given,  ///< the smooth curve through the path is clear of the obstacles
  repaired,  ///< it is, after waypoints were inserted and pushed outward
  violates,  ///< it is not
};

struct FittedTrajectory {
  FitStatus status{};
  Trajectory trajectory;
  std::vector<Vec2> waypoints;  ///< those of the path and those inserted [m, NE]
  int rounds_count{};           ///< of repair
};

/// The minimum snap trajectory along a free `path`, checked against the map all along and repaired where
/// the smooth curve leaves the path for an obstacle: waypoints are inserted on the path there, clear of the
/// obstacle by a margin, and pushed outward where they are close already; at most 30 rounds. With times by
/// length a segment that swings out by more than a tenth of its length is divided likewise, and where an even
/// pace (even_pace.hpp) is clear and quicker it is taken. A given segment time is shared among the parts of a
/// segment by their length, and then limits of speed and acceleration are not looked at.
///
/// No violation above `clearance_tolerance_m` is left unless the status says so. A path of one waypoint is
/// rest. Throws InputError as minimum_snap() and paced() do, and for an empty path.
FittedTrajectory fit_trajectory(std::span<const Vec2> path, const PlanarMap& map, const FitOptions& options);

}  // namespace fairway
