// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <span>

#include "fairway/core/lanes/number.hpp"

/// The incremental programs behind velocity_program.hpp, for one program or for several of as many
/// half-spaces side by side (lanes/number.hpp): a program of fewer has `HalfSpaceOf::everything()` for the
/// rest. `on` tells whose answer is wanted; what the others come to means nothing.
namespace fairway::lanes {

/// The velocities v with normal . v >= offset.
template <class Real>
struct HalfSpaceOf {
  VecOf<Real> normal;  ///< unit, into the allowed side
  Real offset;         ///< of the bounding plane along `normal` [m/s]

  /// The half-space with `point` on its boundary.
  static HalfSpaceOf through(const VecOf<Real>& point, const VecOf<Real>& normal) {
    return {normal, dot(normal, point)};
  }
  static HalfSpaceOf everything() {
    const Real zero{0.0};
    return {{zero, zero, zero}, Real{-std::numeric_limits<double>::infinity()}};
  }

  /// How far `v` lies on the forbidden side [m/s]; negative on the allowed one.
  Real violation(const VecOf<Real>& v) const { return offset - dot(normal, v); }
};

template <class Real>
HalfSpaceOf<Real> select(const MaskOf<Real>& mask, const HalfSpaceOf<Real>& yes,
                         const HalfSpaceOf<Real>& no) {
  return {select(mask, yes.normal, no.normal), select(mask, yes.offset, no.offset)};
}

template <class Real>
using HalfSpacesOf = std::span<const HalfSpaceOf<Real>>;

/// Violations below this fraction of the greatest speed are rounding. A hundred times what a scalar
/// product rounds, so that a test that passes and the cut that follows it cannot contradict each other.
inline constexpr double rounding = 1e-14;

/// The velocities that can be reached, and what counts as rounding among them.
template <class Real>
struct Ball {
  Real radius;
  Real tolerance;
};

/// Where a plane or a line is cut by the ball. Planes have an orthonormal basis in them, so that a
/// point built from coordinates lies on the plane to rounding, however it meets its neighbours.
template <class Real>
struct Disc {
  VecOf<Real> centre;
  VecOf<Real> e1, e2;
  Real radius;

  VecOf<Real> at(const Real& x, const Real& y) const { return centre + x * e1 + y * e2; }
};

template <class Real>
struct Chord {
  VecOf<Real> middle;  ///< the point nearest to the origin
  VecOf<Real> direction;
  Real lo, hi;

  VecOf<Real> at(const Real& t) const { return middle + t * direction; }
};

/// Objective: as near as possible to a velocity.
template <class Real>
struct NearestTo {
  using Vec = VecOf<Real>;

  const Vec& target;

  Vec in(const Ball<Real>& ball) const {
    const Real length = square_root(dot(target, target));
    const auto beyond = length > ball.radius;
    return none(beyond) ? target : select(beyond, (ball.radius / length) * target, target);
  }
  Vec in(const Disc<Real>& disc) const {
    const Real x = dot(disc.e1, target), y = dot(disc.e2, target);
    const Real length2 = x * x + y * y;
    const auto beyond = length2 > disc.radius * disc.radius;
    if (none(beyond)) return disc.at(x, y);
    const Real scale = disc.radius / square_root(length2);
    return disc.at(select(beyond, x * scale, x), select(beyond, y * scale, y));
  }
  Vec in(const Chord<Real>& chord) const {
    return chord.at(smaller(larger(dot(chord.direction, target), chord.lo), chord.hi));
  }
};

/// Objective: as far as possible along a unit vector; where that leaves a choice, as near as possible
/// to a velocity.
template <class Real>
struct FarthestAlong {
  using Vec = VecOf<Real>;
  static constexpr double no_slope = 1e-10;

  const Vec& axis;
  NearestTo<Real> tie;

  Vec in(const Ball<Real>& ball) const { return ball.radius * axis; }
  Vec in(const Disc<Real>& disc) const {
    const Real x = dot(disc.e1, axis), y = dot(disc.e2, axis);
    const Real length2 = x * x + y * y;
    const Real scale = disc.radius / square_root(length2);
    return unless_level(length2 <= no_slope * no_slope, disc, disc.at(scale * x, scale * y));
  }
  Vec in(const Chord<Real>& chord) const {
    const Real slope = dot(chord.direction, axis);
    const Vec end = chord.at(select(slope > 0.0, chord.hi, chord.lo));
    return unless_level(magnitude(slope) <= no_slope, chord, end);
  }

 private:
  template <class Flat>
  Vec unless_level(const MaskOf<Real>& level, const Flat& flat, const Vec& farthest) const {
    return any(level) ? select(level, tie.in(flat), farthest) : farthest;
  }
};

/// The boundary of a half-space within the ball; false where there is nothing of it.
template <class Real>
[[gnu::always_inline]] inline MaskOf<Real> cut(const Ball<Real>& ball, const HalfSpaceOf<Real>& h,
                                               Disc<Real>& disc) {
  const Real radius2 = (ball.radius - h.offset) * (ball.radius + h.offset);
  const MaskOf<Real> meets = !(radius2 < 0.0);
  if (none(meets)) return meets;
  disc.radius = square_root(radius2);
  disc.centre = h.offset * h.normal;

  // e1 is horizontal: a scene in a horizontal plane is solved without rounding out of it
  const VecOf<Real>& n = h.normal;
  const Real zero{0.0};
  const Real horizontal2 = n.x() * n.x() + n.y() * n.y();
  const Real scale = 1.0 / square_root(horizontal2);
  const auto steep = horizontal2 > 0.0;
  disc.e1 = {select(steep, -scale * n.y(), Real{1.0}), select(steep, scale * n.x(), zero), zero};
  disc.e2 = cross(n, disc.e1);
  return meets;
}

/// The boundary of a half-space within a disc; false where there is nothing of it.
template <class Real>
[[gnu::always_inline]] inline MaskOf<Real> cut(const Disc<Real>& disc, const HalfSpaceOf<Real>& h,
                                               Chord<Real>& chord) {
  // in coordinates of the disc: a . x >= b
  const Real a1 = dot(h.normal, disc.e1);
  const Real a2 = dot(h.normal, disc.e2);
  const Real b = h.offset - dot(h.normal, disc.centre);
  const Real length2 = a1 * a1 + a2 * a2;
  const MaskOf<Real> meets = length2 > 1e-30;  // planes that are parallel do not
  if (none(meets)) return meets;

  const Real inverse = 1.0 / square_root(length2);
  const Real distance = b * inverse;
  const Real half2 = (disc.radius - distance) * (disc.radius + distance);
  chord.hi = square_root(half2);
  chord.lo = -chord.hi;
  chord.middle = disc.at(distance * inverse * a1, distance * inverse * a2);
  chord.direction = inverse * (a1 * disc.e2 - a2 * disc.e1);
  return meets & !(half2 < 0.0);
}

/// The one-dimensional program: shortens a chord to what all half-spaces allow. Each gives way by the
/// tolerance, so that rounding does not make a single point infeasible.
template <class Real>
[[gnu::always_inline]] inline MaskOf<Real> shorten(Chord<Real>& chord, HalfSpacesOf<Real> half_spaces,
                                                   const Real& tolerance, MaskOf<Real> on) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const HalfSpaceOf<Real>& h : half_spaces) {
    if (none(on)) break;
    const Real slope = dot(h.normal, chord.direction);
    const Real missing = h.violation(chord.middle) - tolerance;
    const Real bound = missing / slope;
    const MaskOf<Real> parallel = magnitude(slope) <= 1e-14;
    const MaskOf<Real> rises = slope > 0.0;
    chord.lo = larger(chord.lo, select(rises & !parallel, bound, Real{-infinity}));
    chord.hi = smaller(chord.hi, select(rises | parallel, Real{infinity}, bound));
    on = on & !(parallel & (missing > 0.0)) & !(chord.lo > chord.hi);
  }
  return on;
}

/// The two-dimensional program, on the boundary of `plane`. `v` is left alone where there is no answer.
template <class Real, class Objective>
MaskOf<Real> solve_on_plane(const HalfSpaceOf<Real>& plane, HalfSpacesOf<Real> half_spaces,
                            const Ball<Real>& ball, const Objective& objective, MaskOf<Real> on,
                            VecOf<Real>& v) {
  Disc<Real> disc;
  on = on & cut(ball, plane, disc);
  if (none(on)) return on;
  VecOf<Real> best = objective.in(disc);
  for (std::size_t i = 0; i < half_spaces.size(); ++i) {
    const MaskOf<Real> violated = on & !(half_spaces[i].violation(best) <= ball.tolerance);
    if (none(violated)) continue;

    // the optimum moves onto the line in which the two planes meet
    Chord<Real> chord;
    MaskOf<Real> met = violated & cut(disc, half_spaces[i], chord);
    met = shorten(chord, half_spaces.first(i), ball.tolerance, met);
    on = on & (met | !violated);
    if (none(on)) return on;
    best = select(met, objective.in(chord), best);
  }
  v = select(on, best, v);
  return on;
}

/// The three-dimensional program. Returns the index of the first half-space that cannot be kept
/// together with those before it, `v` being the optimum among those, or else their number.
template <class Real, class Objective>
Real solve_in_space(HalfSpacesOf<Real> half_spaces, const Ball<Real>& ball, const Objective& objective,
                    MaskOf<Real> on, VecOf<Real>& v) {
  Real kept{static_cast<double>(half_spaces.size())};
  v = objective.in(ball);
  for (std::size_t i = 0; i < half_spaces.size(); ++i) {
    const MaskOf<Real> violated = on & !(half_spaces[i].violation(v) <= ball.tolerance);
    if (none(violated)) continue;
    const MaskOf<Real> lost =
        violated & !solve_on_plane(half_spaces[i], half_spaces.first(i), ball, objective, violated, v);
    if (none(lost)) continue;
    kept = select(lost, Real{static_cast<double>(i)}, kept);
    on = on & !lost;
    if (none(on)) break;
  }
  return kept;
}

/// The four-dimensional program: of the velocities whose largest violation is least, the one nearest to
/// `preferred`. On entry `v` is the answer for the first `kept` half-spaces. `room` holds as many
/// half-spaces.
template <class Real>
void minimise_violation(HalfSpacesOf<Real> half_spaces, const Real& kept, const VecOf<Real>& preferred,
                        Ball<Real> ball, HalfSpaceOf<Real>* room, VecOf<Real>& v) {
  Real level{0.0};
  for (std::size_t i = 0; i < half_spaces.size(); ++i) {
    const MaskOf<Real> left = kept <= static_cast<double>(i);
    if (none(left)) continue;
    const HalfSpaceOf<Real>& worst = half_spaces[i];
    const Real violation = worst.violation(v);
    const MaskOf<Real> on = left & !(violation <= level + ball.tolerance);
    if (none(on)) continue;

    // half-space i is violated most now: velocities that violate no earlier one more than it lie
    // beyond the bisectors between it and them; among those, its own violation is made least
    ball.tolerance = select(on, larger(ball.tolerance, rounding * violation), ball.tolerance);
    std::size_t count = 0;
    for (const HalfSpaceOf<Real>& other : half_spaces.first(i)) {
      const VecOf<Real> difference = other.normal - worst.normal;
      const Real length2 = dot(difference, difference);
      const MaskOf<Real> differs = length2 > 1e-30;
      if (none(on & differs)) continue;
      const Real inverse = 1.0 / square_root(length2);
      const HalfSpaceOf<Real> bisector{inverse * difference,
                                       inverse * (other.offset - worst.offset - ball.tolerance)};
      room[count++] = select(differs, bisector, HalfSpaceOf<Real>::everything());
    }
    room[count++] = {-worst.normal, -worst.offset};  // no violation is less than none

    VecOf<Real> better;
    const FarthestAlong<Real> objective{worst.normal, {preferred}};
    const Real solved = solve_in_space<Real>({room, count}, ball, objective, on, better);
    v = select(on & (solved >= static_cast<double>(count)), better, v);
    level = select(on, larger(level, worst.violation(v)), level);
  }
}

/// Sets `v` and returns the violation that is left: zero where all half-spaces are kept. `room` holds as
/// many.
template <class Real>
Real nearest_velocity(HalfSpacesOf<Real> half_spaces, const VecOf<Real>& preferred, const Real& max_speed,
                      const MaskOf<Real>& on, HalfSpaceOf<Real>* room, VecOf<Real>& v) {
  const Ball<Real> ball{max_speed, rounding * max_speed};
  const Real zero{0.0};
  const Real kept = solve_in_space<Real>(half_spaces, ball, NearestTo<Real>{preferred}, on, v);
  if (none(kept < static_cast<double>(half_spaces.size()))) return zero;

  minimise_violation<Real>(half_spaces, kept, preferred, ball, room, v);

  // what only rounding made infeasible is not
  Real violation = zero;
  for (const HalfSpaceOf<Real>& h : half_spaces) violation = larger(violation, h.violation(v));
  return select(violation > 1e-11 * max_speed, violation, zero);
}

}  // namespace fairway::lanes
