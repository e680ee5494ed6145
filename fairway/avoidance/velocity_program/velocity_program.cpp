// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_program/velocity_program.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace fairway {
namespace {

using HalfSpaceView = std::span<const HalfSpace>;

/// Violations below this fraction of the greatest speed are rounding. A hundred times what a scalar
/// product rounds, so that a test that passes and the cut that follows it cannot contradict each other.
constexpr double rounding = 1e-14;

/// The velocities that can be reached, and what counts as rounding among them.
struct Ball {
  double radius;
  double tolerance;
};

/// Where a plane or a line is cut by the ball. Planes have an orthonormal basis in them, so that a
/// point built from coordinates lies on the plane to rounding, however it meets its neighbours.
struct Disc {
  Vec3 centre;
  Vec3 e1, e2;
  double radius;

  Vec3 at(double x, double y) const { return centre + x * e1 + y * e2; }
};

struct Chord {
  Vec3 middle;  ///< the point nearest to the origin
  Vec3 direction;
  double lo, hi;

  Vec3 at(double t) const { return middle + t * direction; }
};

/// Objective: as near as possible to a velocity.
struct NearestTo {
  const Vec3& target;

  Vec3 in(const Ball& ball) const { return clamp_norm(target, ball.radius); }
  Vec3 in(const Disc& disc) const {
    double x = disc.e1.dot(target);
    double y = disc.e2.dot(target);
    const double length2 = x * x + y * y;
    if (length2 > disc.radius * disc.radius) {
      const double scale = disc.radius / std::sqrt(length2);
      x *= scale;
      y *= scale;
    }
    return disc.at(x, y);
  }
  Vec3 in(const Chord& chord) const {
    return chord.at(std::min(std::max(chord.direction.dot(target), chord.lo), chord.hi));
  }
};

/// Objective: as far as possible along a unit vector; where that leaves a choice, as near as possible
/// to a velocity.
struct FarthestAlong {
  static constexpr double no_slope = 1e-10;

  const Vec3& axis;
  NearestTo tie;

  Vec3 in(const Ball& ball) const { return ball.radius * axis; }
  Vec3 in(const Disc& disc) const {
    const double x = disc.e1.dot(axis);
    const double y = disc.e2.dot(axis);
    const double length2 = x * x + y * y;
    if (length2 <= no_slope * no_slope) return tie.in(disc);
    const double scale = disc.radius / std::sqrt(length2);
    return disc.at(scale * x, scale * y);
  }
  Vec3 in(const Chord& chord) const {
    const double slope = chord.direction.dot(axis);
    if (std::fabs(slope) <= no_slope) return tie.in(chord);
    return chord.at(slope > 0.0 ? chord.hi : chord.lo);
  }
};

/// The boundary of a half-space within the ball, or nothing (false).
bool cut(const Ball& ball, const HalfSpace& h, Disc& disc) {
  const double radius2 = (ball.radius - h.offset) * (ball.radius + h.offset);
  if (radius2 < 0.0) return false;
  disc.radius = std::sqrt(radius2);
  disc.centre = h.offset * h.normal;

  // e1 is horizontal: a scene in a horizontal plane is solved without rounding out of it
  const Vec3& n = h.normal;
  const double horizontal2 = n.x() * n.x() + n.y() * n.y();
  if (horizontal2 > 0.0) {
    const double scale = 1.0 / std::sqrt(horizontal2);
    disc.e1 = {-scale * n.y(), scale * n.x(), 0.0};
  } else {
    disc.e1 = {1.0, 0.0, 0.0};
  }
  disc.e2 = n.cross(disc.e1);
  return true;
}

/// The boundary of a half-space within a disc, or nothing (false).
bool cut(const Disc& disc, const HalfSpace& h, Chord& chord) {
  // in coordinates of the disc: a . x >= b
  const double a1 = h.normal.dot(disc.e1);
  const double a2 = h.normal.dot(disc.e2);
  const double b = h.offset - h.normal.dot(disc.centre);
  const double length2 = a1 * a1 + a2 * a2;
  if (!(length2 > 1e-30)) return false;  // parallel planes

  const double inverse = 1.0 / std::sqrt(length2);
  const double distance = b * inverse;
  const double half2 = (disc.radius - distance) * (disc.radius + distance);
  if (half2 < 0.0) return false;
  chord.hi = std::sqrt(half2);
  chord.lo = -chord.hi;
  chord.middle = disc.at(distance * inverse * a1, distance * inverse * a2);
  chord.direction = inverse * (a1 * disc.e2 - a2 * disc.e1);
  return true;
}

/// The one-dimensional program: shortens a chord to what all half-spaces allow. Each gives way by the
/// tolerance, so that rounding does not make a single point infeasible.
bool shorten(Chord& chord, HalfSpaceView half_spaces, double tolerance) {
  for (const HalfSpace& h : half_spaces) {
    const double slope = h.normal.dot(chord.direction);
    const double missing = h.violation(chord.middle) - tolerance;
    if (std::fabs(slope) <= 1e-14) {
      if (missing > 0.0) return false;
    } else if (slope > 0.0) {
      chord.lo = std::max(chord.lo, missing / slope);
    } else {
      chord.hi = std::min(chord.hi, missing / slope);
    }
    if (chord.lo > chord.hi) return false;
  }
  return true;
}

/// The two-dimensional program, on the boundary of `plane`. `v` is left alone if there is no answer.
template <class Objective>
bool solve_on_plane(const HalfSpace& plane, HalfSpaceView half_spaces, const Ball& ball,
                    const Objective& objective, Vec3& v) {
  Disc disc;
  if (!cut(ball, plane, disc)) return false;
  Vec3 best = objective.in(disc);
  for (std::size_t i = 0; i < half_spaces.size(); ++i) {
    if (half_spaces[i].violation(best) <= ball.tolerance) continue;

    // the optimum moves onto the line in which the two planes meet
    Chord chord;
    if (!cut(disc, half_spaces[i], chord)) return false;
    if (!shorten(chord, half_spaces.first(i), ball.tolerance)) return false;
    best = objective.in(chord);
  }
  v = best;
  return true;
}

/// The three-dimensional program. Returns the index of the first half-space that cannot be kept
/// together with those before it, `v` being the optimum among those, or else their number.
template <class Objective>
std::size_t solve_in_space(HalfSpaceView half_spaces, const Ball& ball, const Objective& objective, Vec3& v) {
  v = objective.in(ball);
  for (std::size_t i = 0; i < half_spaces.size(); ++i) {
    if (half_spaces[i].violation(v) <= ball.tolerance) continue;
    if (!solve_on_plane(half_spaces[i], half_spaces.first(i), ball, objective, v)) return i;
  }
  return half_spaces.size();
}

double worst_violation(HalfSpaceView half_spaces, const Vec3& v) {
  double worst = 0.0;
  for (const HalfSpace& h : half_spaces) worst = std::max(worst, h.violation(v));
  return worst;
}

/// The four-dimensional program: of the velocities whose largest violation is least, the one nearest to
/// `preferred`. On entry `v` is the answer for the first `kept` half-spaces.
void minimise_violation(HalfSpaceView half_spaces, std::size_t kept, const Vec3& preferred, Ball ball,
                        Vec3& v) {
  std::array<HalfSpace, max_half_spaces> bisectors;
  double level = 0.0;
  for (std::size_t i = kept; i < half_spaces.size(); ++i) {
    const HalfSpace& worst = half_spaces[i];
    const double violation = worst.violation(v);
    if (violation <= level + ball.tolerance) continue;

    // half-space i is violated most now: velocities that violate no earlier one more than it lie
    // beyond the bisectors between it and them; among those, its own violation is made least
    ball.tolerance = std::max(ball.tolerance, rounding * violation);
    std::size_t count = 0;
    for (const HalfSpace& other : half_spaces.first(i)) {
      const Vec3 difference = other.normal - worst.normal;
      const double length2 = difference.squaredNorm();
      if (!(length2 > 1e-30)) continue;
      const double inverse = 1.0 / std::sqrt(length2);
      bisectors[count++] = {inverse * difference, inverse * (other.offset - worst.offset - ball.tolerance)};
    }
    bisectors[count++] = {-worst.normal, -worst.offset};  // no violation is less than none

    Vec3 better;
    const HalfSpaceView earlier{bisectors.data(), count};
    const FarthestAlong objective{worst.normal, {preferred}};
    if (solve_in_space(earlier, ball, objective, better) == count) v = better;
    level = std::max(level, worst.violation(v));
  }
}

}  // namespace

VelocityChoice nearest_velocity(HalfSpaceView half_spaces, const Vec3& preferred, double max_speed) noexcept {
  half_spaces = half_spaces.first(std::min(half_spaces.size(), max_half_spaces));
  const Ball ball{max_speed, rounding * max_speed};

  Vec3 v;
  const std::size_t kept = solve_in_space(half_spaces, ball, NearestTo{preferred}, v);
  if (kept == half_spaces.size()) return {v, 0.0};

  minimise_violation(half_spaces, kept, preferred, ball, v);

  // what only rounding made infeasible is not
  const double violation = worst_violation(half_spaces, v);
  return {v, violation > 1e-11 * max_speed ? violation : 0.0};
}

}  // namespace fairway
