// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <limits>
#include <vector>

#include "fairway/avoidance/velocity_program/velocity_program.hpp"

/// The velocity program solved by trying every set of constraints that may bind, in long double: slow,
/// short and independent of the incremental one. Expects constraints in general position.
namespace fairway::brute_force {

using Real = long double;
using Vec = Eigen::Matrix<Real, 3, 1>;

struct Plane {
  Vec normal;
  Real offset;
};

inline std::vector<Plane> planes_of(std::span<const HalfSpace> half_spaces) {
  std::vector<Plane> planes;
  for (const HalfSpace& h : half_spaces)
    planes.push_back({{h.normal.x(), h.normal.y(), h.normal.z()}, h.offset});
  return planes;
}

inline Real worst_violation(const std::vector<Plane>& planes, const Vec& v) {
  Real worst = 0;
  for (const Plane& plane : planes) worst = std::fmax(worst, plane.offset - plane.normal.dot(v));
  return worst;
}

/// Calls `see` with the points of the flat given by `equations` that can be optimal: the one nearest to
/// `goal`, and where the flat leaves the ball, the one there nearest to `goal`, and its antipode.
template <class See>
void candidates(const std::vector<Plane>& equations, const Vec& goal, Real radius, See see) {
  const auto count = static_cast<Eigen::Index>(equations.size());
  Vec foot = Vec::Zero();
  Vec along = goal;
  if (count > 0) {
    Eigen::Matrix<Real, Eigen::Dynamic, 3> a(count, 3);
    Eigen::Matrix<Real, Eigen::Dynamic, 1> b(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      a.row(i) = equations[static_cast<std::size_t>(i)].normal.transpose();
      b(i) = equations[static_cast<std::size_t>(i)].offset;
    }
    // least-norm solutions, by orthogonal factors so that nearly parallel planes stay accurate
    const Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<Real, Eigen::Dynamic, 3>> factors(a);
    foot = factors.solve(b);
    along = goal - Vec{factors.solve(a * goal)};
  }
  if (count < 3) {
    see(Vec{foot + along});
    const Real half = std::sqrt(radius * radius - foot.squaredNorm());
    const Real length = along.norm();
    if (half >= 0 && length > 0) {
      see(Vec{foot + half / length * along});
      see(Vec{foot - half / length * along});
    }
  } else {
    see(foot);
  }
}

/// Calls `see` with every set of at most `size` of `count` indices.
template <class See>
void subsets(std::size_t count, std::size_t size, See see, std::vector<std::size_t> chosen = {}) {
  see(chosen);
  if (chosen.size() == size) return;
  for (std::size_t i = chosen.empty() ? 0 : chosen.back() + 1; i < count; ++i) {
    chosen.push_back(i);
    subsets(count, size, see, chosen);
    chosen.pop_back();
  }
}

struct Answer {
  Vec velocity = Vec::Zero();
  Real violation = std::numeric_limits<Real>::infinity();
};

inline Answer nearest_velocity(std::span<const HalfSpace> half_spaces, const Vec3& preferred,
                               double max_speed) {
  constexpr Real rounding = 1e-13L;
  const std::vector<Plane> planes = planes_of(half_spaces);
  const Vec goal = preferred.cast<Real>();
  const Real radius = max_speed;

  // feasible: the nearest of all points in which at most three constraints, the ball being one, bind
  Answer best;
  Real nearest = std::numeric_limits<Real>::infinity();
  subsets(planes.size(), 3, [&](const std::vector<std::size_t>& chosen) {
    std::vector<Plane> equations;
    for (const std::size_t i : chosen) equations.push_back(planes[i]);
    candidates(equations, goal, radius, [&](const Vec& v) {
      const Real distance = (v - goal).norm();
      if (v.norm() > radius * (1 + rounding) || worst_violation(planes, v) > rounding * radius) return;
      if (distance < nearest) {
        nearest = distance;
        best = {v, 0};
      }
    });
  });
  if (best.violation == 0) return best;

  // infeasible: the same over sets that are violated equally, as far along the first as can be
  subsets(planes.size(), 4, [&](const std::vector<std::size_t>& chosen) {
    if (chosen.empty()) return;
    const Plane& first = planes[chosen[0]];
    std::vector<Plane> equations;
    for (std::size_t i = 1; i < chosen.size(); ++i) {
      const Plane& other = planes[chosen[i]];
      equations.push_back({other.normal - first.normal, other.offset - first.offset});
    }
    candidates(equations, first.normal, radius, [&](const Vec& v) {
      if (v.norm() > radius * (1 + rounding)) return;
      const Real violation = worst_violation(planes, v);
      if (violation < best.violation) best = {v, violation};
    });
  });
  return best;
}

}  // namespace fairway::brute_force
