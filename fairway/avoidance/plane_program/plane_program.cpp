// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/plane_program/plane_program.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fairway {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Violations below this share of the greatest number in the program are rounding.
constexpr double rounding_share = 1e-14;

/// Below this sine two lines are parallel, and below this difference two normals are one.
constexpr double parallel = 1e-12;
constexpr double coincident = 1e-8;

/// A least violation below this share of the greatest number is none.
constexpr double kept = 1e-11;

/// What contradicting half-planes leave is thin: roundings that much larger are none there, and points this
/// near to each other, as a share of the greatest number, are one.
constexpr double of_thin = 10.0;
constexpr double one_point = 1e-9;

/// Where no disc bounds the least violation, it is looked for within this many times the greatest number.
constexpr double horizon = 1e6;

/// What is looked for: the farthest along `along`, if that is not zero, and of those the nearest to `wanted`.
struct Objective {
  Vec2 wanted;
  Vec2 along = Vec2::Zero();
};

/// The part of a line that is left; `lo_sine` and `hi_sine` tell how sharply it is cut off there.
struct Interval {
  double lo = -infinite;
  double hi = infinite;
  double lo_sine = 1.0;
  double hi_sine = 1.0;

  void cut(double sine, double gap) {
    const double t = gap / sine;
    if (sine > 0.0 && t > lo) {
      lo = t;
      lo_sine = sine;
    } else if (sine < 0.0 && t < hi) {
      hi = t;
      hi_sine = -sine;
    }
  }

  /// Cuts give way by `tolerance`, so that a corner of many lines is not lost to rounding.
  bool is_empty(double tolerance) const { return (lo - hi) * std::min(lo_sine, hi_sine) > tolerance; }

  double nearest(double t) const { return lo > hi ? 0.5 * (lo + hi) : std::clamp(t, lo, hi); }
};

/// Half-planes `at(0)` to `at(count - 1)` and a disc.
template <class At>
class Incremental {
 public:
  Incremental(At at, double radius, double tolerance) : at_{at}, radius_{radius}, tolerance_{tolerance} {}

  /// Adds half-planes one by one; if one is violated, the optimum is on its boundary. Moves `x` to the
  /// optimum of those before the first that leaves nothing, whose index is returned; `count` if none does.
  std::size_t solve(std::size_t count, const Objective& objective, Vec2& x) const {
    x = in_disc(objective);
    for (std::size_t i = 0; i < count; ++i) {
      const HalfPlane line = at_(i);
      if (line.violation(x) <= tolerance_) continue;
      if (!solve_on(line, i, objective, x)) return i;
    }
    return count;
  }

 private:
  Vec2 in_disc(const Objective& objective) const {
    if (!objective.along.isZero(0.0)) return radius_ * objective.along;
    const double length = objective.wanted.norm();
    return length > radius_ ? Vec2{(radius_ / length) * objective.wanted} : objective.wanted;
  }

  /// The optimum on `line` within the first `count` half-planes; false if they leave nothing of it.
  bool solve_on(const HalfPlane& line, std::size_t count, const Objective& objective, Vec2& x) const {
    const Vec2 base = objective.wanted + line.violation(objective.wanted) * line.normal;
    const Vec2 along{-line.normal.y(), line.normal.x()};
    Interval interval;
    if (radius_ < infinite) {
      // a chord whose depth is rounding is a point: its length would be the root of that
      const double depth = radius_ - std::abs(line.offset);
      if (depth < -tolerance_) return false;
      const double half = depth > tolerance_ ? std::sqrt(depth * (radius_ + std::abs(line.offset))) : 0.0;
      const double middle = -base.dot(along);
      interval.lo = middle - half;
      interval.hi = middle + half;
    }
    for (std::size_t j = 0; j < count; ++j) {
      const HalfPlane other = at_(j);
      const double sine = other.normal.dot(along);
      const double gap = other.violation(base);
      if (std::abs(sine) <= parallel) {
        if (gap > tolerance_) return false;
      } else {
        interval.cut(sine, gap);
        if (interval.is_empty(tolerance_)) return false;
      }
    }
    x = base + chosen(interval, objective.along.dot(along)) * along;
    return true;
  }

  static double chosen(const Interval& interval, double slope) {
    if (std::abs(slope) <= 1e2 * parallel) return interval.nearest(0.0);
    return interval.nearest(slope > 0.0 ? interval.hi : interval.lo);
  }

  At at_;
  double radius_;
  double tolerance_;
};

/// The points that violate `worse` at least as much as `other`.
HalfPlane bisector(const HalfPlane& other, const HalfPlane& worse) {
  const Vec2 difference = other.normal - worse.normal;
  const double length = difference.norm();
  if (length <= coincident) return {Vec2::UnitX(), -infinite};
  return {difference / length, (other.offset - worse.offset) / length};
}

double greatest_number(const PlaneProgram& program, const Vec2& wanted) {
  double greatest = wanted.norm();
  for (const HalfPlane& h : program.half_planes) greatest = std::max(greatest, std::abs(h.offset));
  return program.max_length < infinite ? std::max(greatest, program.max_length) : greatest;
}

double largest_violation(std::span<const HalfPlane> half_planes, const Vec2& x) {
  double largest = 0.0;
  for (const HalfPlane& h : half_planes) largest = std::max(largest, h.violation(x));
  return largest;
}

/// Makes the largest violation of the soft half-planes least, the hard ones kept. `x` keeps those before
/// `first`. A half-plane that is violated more than the level so far is the worst at the new optimum: those
/// that are violated less lie beyond bisecting lines. `given` gives the half-planes. Returns that violation.
template <class Given>
double minimise_violation(const PlaneProgram& program, const Given& given, std::size_t first,
                          const Vec2& wanted, double scale, double rounding, Vec2& x) {
  const double radius = program.max_length < infinite ? program.max_length : horizon * scale;
  std::array<HalfPlane, 32> bounds;  // each is read often: the first are made once
  double level = 0.0;
  for (std::size_t i = first; i < program.half_planes.size(); ++i) {
    const HalfPlane worst = given(i);
    if (worst.violation(x) <= level + rounding * scale) continue;
    const auto made = [&](std::size_t j) {
      return j < program.hard_count ? given(j) : bisector(given(j), worst);
    };
    for (std::size_t j = 0; j < std::min(i, bounds.size()); ++j) bounds[j] = made(j);
    const auto at = [&](std::size_t j) { return j < bounds.size() ? bounds[j] : made(j); };
    Vec2 better;
    if (Incremental{at, radius, rounding * scale}.solve(i, {wanted, worst.normal}, better) == i) x = better;
    level = std::max(0.0, worst.violation(x));
  }
  return level;
}

/// The least violation of the soft ones; then, all of them moved back by it, the nearest. As above.
template <class Given>
void violate_least(const PlaneProgram& program, const Given& given, std::size_t first, const Vec2& wanted,
                   double scale, double rounding, Vec2& x) {
  const double level = minimise_violation(program, given, first, wanted, scale, rounding, x);
  const auto moved_back = [&](std::size_t i) {
    const HalfPlane h = given(i);
    return i < program.hard_count ? h : HalfPlane{h.normal, h.offset - level};
  };
  Vec2 nearest;
  const std::size_t kept_count = Incremental{moved_back, program.max_length, 10.0 * rounding * scale}.solve(
      program.half_planes.size(), {.wanted = wanted}, nearest);
  if (kept_count == program.half_planes.size()) x = nearest;
}

PlaneChoice chosen_at(std::span<const HalfPlane> half_planes, const Vec2& x, double scale) {
  const double violation = largest_violation(half_planes, x);
  return {x, violation > kept * scale ? violation : 0.0};
}

/// Where the hard ones contradict each other: these moved back by their least violation, and the others as
/// ever. The point of the hard ones alone, to the bit, where they leave no other.
PlaneChoice among_contradictions(const PlaneProgram& program, const Vec2& wanted, double scale) {
  const std::span<const HalfPlane> all = program.half_planes, hard = all.first(program.hard_count);
  PlaneChoice of_hard = nearest_in_plane({hard, 0, program.max_length}, wanted);
  if (hard.size() == all.size()) return of_hard;

  const double back = largest_violation(hard, of_hard.point);
  const auto moved_back = [&](std::size_t i) {
    return i < program.hard_count ? HalfPlane{all[i].normal, all[i].offset - back} : all[i];
  };
  constexpr double rounding = of_thin * rounding_share;
  Vec2 x;
  const std::size_t failed =
      Incremental{moved_back, program.max_length, rounding * scale}.solve(all.size(), {.wanted = wanted}, x);
  const bool is_lost = failed < program.hard_count;
  if (!is_lost && failed < all.size()) violate_least(program, moved_back, failed, wanted, scale, rounding, x);
  if (is_lost || (x - of_hard.point).norm() <= one_point * scale) x = of_hard.point;
  return chosen_at(all, x, scale);
}

}  // namespace

PlaneChoice nearest_in_plane(const PlaneProgram& program, const Vec2& wanted) noexcept {
  const std::span<const HalfPlane> all = program.half_planes;
  const double scale = greatest_number(program, wanted);
  const auto as_given = [&](std::size_t i) { return all[i]; };

  Vec2 x;
  const std::size_t failed = Incremental{as_given, program.max_length, rounding_share * scale}.solve(
      all.size(), {.wanted = wanted}, x);
  if (failed == all.size()) return {x, 0.0};
  if (failed < program.hard_count) return among_contradictions(program, wanted, scale);
  violate_least(program, as_given, failed, wanted, scale, rounding_share, x);
  return chosen_at(all.subspan(program.hard_count), x, scale);
}

}  // namespace fairway
