// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/planning/minimum_snap/trajectory.hpp"

namespace fairway {

/// How the segments of a trajectory meet at the waypoints between start and end.
enum class Joining {
  smooth,        ///< continuous through the 6th derivative in physical time
  rest_to_rest,  ///< each segment by itself, with no velocity, acceleration or jerk at its ends
};

/// The trajectory through `waypoints`, the segment after waypoint i taking durations[i], that starts and ends
/// without velocity, acceleration and jerk and has the least integral of squared snap (Mellinger, Kumar 2011;
/// rehman2021, section III-A-3 and eq. 19). That integral is a quadratic form in velocity, acceleration and
/// jerk at the inner waypoints, so its minimiser is unique, the derivatives 4 to 6 are continuous there as
/// well, and it is found by one block-tridiagonal Cholesky decomposition: O(waypoints).
///
/// Throws InputError for fewer than two waypoints, any that is not finite, two in a row that are the same, a
/// duration per segment that is missing or not positive.
Trajectory minimum_snap(std::span<const Vec2> waypoints, std::span<const double> durations,
                        Joining joining = Joining::smooth);

/// Condition number of the linear system that minimum_snap() solves for segments of these durations, which
/// is that of its unknowns scaled to a unit diagonal. O(segments^3); for tests and documents.
double minimum_snap_condition(std::span<const double> durations);

/// A duration in proportion to the length of each segment: at 1 m/s on average [s].
std::vector<double> durations_by_length(std::span<const Vec2> waypoints);

/// What a trajectory may not exceed.
struct TrajectoryLimits {
  double max_speed_mps{};
  double max_acceleration_mps2{};  ///< may be infinite
};

/// The same way at the pace at which speed or acceleration just reaches its limit. Speeds go with the inverse
/// of the time taken and accelerations with its square, so this is exact, to the millionth to which the peaks
/// are. Throws InputError if a limit is not positive.
Trajectory paced(const Trajectory& trajectory, const TrajectoryLimits& limits);

}  // namespace fairway
