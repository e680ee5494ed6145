// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/minimum_snap/fit_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fairway/core/error.hpp"
#include "fairway/core/math.hpp"
#include "fairway/planning/minimum_snap/even_pace.hpp"

namespace fairway {
namespace {

/// A piece of a segment's curve over s = begin .. begin + extent.
struct Piece {
  Bezier curve;
  double begin;
  double extent;
};

void search(const Piece& piece, const PlanarMap& map, double enough_m, int depth, ClosestPass& closest) {
  const auto [left, right] = piece.curve.halves();
  const Vec2 middle = left.last();
  const double clearance = map.clearance(middle);
  const double half = 0.5 * piece.extent;
  if (clearance < closest.clearance_m) {
    closest.clearance_m = clearance;
    closest.s = piece.begin + half;
  }
  const double least_possible = clearance - piece.curve.reach(middle);
  if (depth == 0 || least_possible >= enough_m) return;
  if (least_possible >= closest.clearance_m - clearance_tolerance_m) return;
  search({left, piece.begin, half}, map, enough_m, depth - 1, closest);
  search({right, piece.begin + half, half}, map, enough_m, depth - 1, closest);
}

/// Waypoints and the durations of the segments between them.
struct Course {
  std::vector<Vec2> waypoints;
  std::vector<double> durations;
};

Course course_along(std::span<const Vec2> path, double segment_time_s) {
  Course course{.waypoints = {path.begin(), path.end()}, .durations = durations_by_length(path)};
  if (segment_time_s > 0.0) std::ranges::fill(course.durations, segment_time_s);
  return course;
}

/// `p` moved outward until it has `margin` of clearance, or as near to that as the obstacles let it come.
Vec2 pushed_out(Vec2 p, const PlanarMap& map, double margin) {
  for (int step = 0; step < 8; ++step) {
    const double missing = margin - map.clearance(p);
    if (missing <= 0.0) break;
    const Vec2 next = p + missing * map.outward(p);
    if (map.clearance(next) <= map.clearance(p)) break;
    p = next;
  }
  return p;
}

void insert(Course& course, std::size_t segment, const Vec2& waypoint) {
  const auto at = static_cast<std::ptrdiff_t>(segment);
  const double first = (waypoint - course.waypoints[segment]).norm();
  const double second = (course.waypoints[segment + 1] - waypoint).norm();
  const double duration = course.durations[segment];
  course.durations[segment] = duration * first / (first + second);
  course.durations.insert(course.durations.begin() + at + 1, duration * second / (first + second));
  course.waypoints.insert(course.waypoints.begin() + at + 1, waypoint);
}

/// What the clearance of a straight line may seem to lack where it touches an inflated obstacle.
constexpr double rounding_m = 1e-9;

/// A curve so many times as long as the straight line of its segment swings out. Next to segments that are
/// much shorter, and so much stiffer, that comes to many times its length where nothing is done about it.
constexpr double swing_ratio = 1.1;

/// Segments down to this part of the path are divided.
constexpr double divisible_ratio = 0.01;

/// Where a trajectory has to be repaired.
struct Flaw {
  std::size_t segment;
  double s;          // in the middle of it, or where it is deepest in an obstacle
  double missing_m;  // clearance; none where the curve only swings out
};

double step_length(const Course& course, std::size_t segment) {
  return (course.waypoints[segment + 1] - course.waypoints[segment]).norm();
}

/// In the order of the segments, at most one of each. Swinging is minded in segments that can be divided.
std::vector<Flaw> flaws_of(const Trajectory& trajectory, const Course& course, const PlanarMap& map,
                           bool minds_swing) {
  const double divisible = divisible_ratio * length_of(course.waypoints);
  std::vector<Flaw> flaws;
  for (std::size_t i = 0; i < course.durations.size(); ++i) {
    const ClosestPass pass = closest_pass(trajectory, i, map, 0.0);
    const double step = step_length(course, i);
    if (pass.clearance_m < -rounding_m) {
      flaws.push_back({i, pass.s, -pass.clearance_m});
    } else if (minds_swing && step > divisible && trajectory.length(i) > swing_ratio * step) {
      flaws.push_back({i, 0.5, 0.0});
    }
  }
  return flaws;
}

/// A waypoint on the straight line beside each flaw, in the middle half of its segment and clear of
/// obstacles by `margin`; where the segment is short already, its ends are pushed outward by what is missing.
void repair(Course& course, const Trajectory& trajectory, std::span<const Flaw> flaws, const PlanarMap& map,
            double margin) {
  const double divisible = divisible_ratio * length_of(course.waypoints);
  for (auto flaw = flaws.rbegin(); flaw != flaws.rend(); ++flaw) {
    const Vec2 from = course.waypoints[flaw->segment];
    const Vec2 step = course.waypoints[flaw->segment + 1] - from;
    if (step.norm() > divisible) {
      const Vec2 astray = trajectory.derivative(flaw->segment, 0, flaw->s);
      const double t = std::clamp((astray - from).dot(step) / step.squaredNorm(), 0.25, 0.75);
      insert(course, flaw->segment, pushed_out(from + t * step, map, margin));
      continue;
    }
    for (std::size_t i = std::max<std::size_t>(1, flaw->segment);
         i <= flaw->segment + 1 && i + 1 < course.waypoints.size(); ++i) {
      Vec2& waypoint = course.waypoints[i];
      const double has = math::fmax(0.0, map.clearance(waypoint));
      waypoint = pushed_out(waypoint, map, has + flaw->missing_m + margin);
    }
  }
}

/// Brings the trajectory to the pace of the limits: evenly, where that is clear and quicker.
void keep_pace(std::span<const Vec2> path, const PlanarMap& map, const FitOptions& options,
               FittedTrajectory& fitted) {
  fitted.trajectory = paced(fitted.trajectory, options.limits);
  if (options.joining == Joining::rest_to_rest) return;
  std::optional<PacedTrajectory> even = evenly_paced(path, map, options.limits);
  const bool clear_already = fitted.status != FitStatus::violates;
  if (!even || (clear_already && even->trajectory.duration() >= fitted.trajectory.duration())) return;
  if (!clear_already) fitted.status = FitStatus::repaired;
  fitted.trajectory = std::move(even->trajectory);
  fitted.waypoints = std::move(even->waypoints);
}

}  // namespace

ClosestPass closest_pass(const Trajectory& trajectory, std::size_t segment, const PlanarMap& map,
                         double enough_m) noexcept {
  constexpr int deepest = 40;
  const Bezier curve = trajectory.curve(segment);
  ClosestPass closest{.clearance_m = map.clearance(curve.first()), .segment = segment, .s = 0.0};
  if (const double last = map.clearance(curve.last()); last < closest.clearance_m) {
    closest.clearance_m = last;
    closest.s = 1.0;
  }
  search({curve, 0.0, 1.0}, map, enough_m, deepest, closest);
  return closest;
}

double least_clearance(const Trajectory& trajectory, const PlanarMap& map) noexcept {
  if (trajectory.segments().empty()) return map.clearance(trajectory.sample(0.0).position);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < trajectory.segments().size(); ++i) {
    least = math::fmin(least, closest_pass(trajectory, i, map, least).clearance_m);
  }
  return least;
}

FittedTrajectory fit_trajectory(std::span<const Vec2> path, const PlanarMap& map, const FitOptions& options) {
  if (path.empty()) throw InputError("a trajectory needs a path");
  if (path.size() == 1) return {FitStatus::as_given, Trajectory{path.front()}, {path.front()}, 0};

  constexpr int most_rounds = 30;
  const bool is_paced = options.segment_time_s <= 0.0;
  Course course = course_along(path, options.segment_time_s);
  FittedTrajectory fitted;
  for (;; ++fitted.rounds_count) {
    fitted.trajectory = minimum_snap(course.waypoints, course.durations, options.joining);
    const std::vector<Flaw> flaws =
        flaws_of(fitted.trajectory, course, map, is_paced && fitted.rounds_count < most_rounds);
    if (flaws.empty()) {
      fitted.status = fitted.rounds_count == 0 ? FitStatus::as_given : FitStatus::repaired;
      break;
    }
    if (fitted.rounds_count == most_rounds || options.joining == Joining::rest_to_rest) {
      fitted.status = FitStatus::violates;
      break;
    }
    const double margin = 5.0 * clearance_tolerance_m * (fitted.rounds_count + 1);
    Course repaired = course;
    repair(repaired, fitted.trajectory, flaws, map, margin);
    if (std::ranges::adjacent_find(repaired.waypoints) != repaired.waypoints.end()) {
      fitted.status = FitStatus::violates;  // pushed together: there is no room
      break;
    }
    course = std::move(repaired);
  }
  fitted.waypoints = std::move(course.waypoints);
  if (is_paced) keep_pace(path, map, options, fitted);
  return fitted;
}

}  // namespace fairway
