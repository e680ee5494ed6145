// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "fairway/avoidance/velocity_program/incremental.hpp"
#include "fairway/core/lanes/number.hpp"

/// The half-spaces of ORCA, for one neighbour or for one of each of several vehicles (lanes/number.hpp).
/// What they are stands in half_space.hpp.
namespace fairway::lanes {

/// Below this sine a relative velocity points along the axis of the cone: no position is known better.
inline constexpr double on_axis = 1e-9;

template <class Real>
struct NeighbourOf {
  VecOf<Real> p;
  VecOf<Real> v;
  Real radius;
  VecOf<Real> parting;
};

template <class Real>
struct ChangeOf {
  VecOf<Real> normal;
  Real distance;
};

template <class Real>
ChangeOf<Real> select(const MaskOf<Real>& mask, const ChangeOf<Real>& yes, const ChangeOf<Real>& no) {
  return {select(mask, yes.normal, no.normal), select(mask, yes.distance, no.distance)};
}

/// Across the axis p of the cone, when the relative velocity does not tell: to starboard of the line
/// of sight, which is to starboard for both; if that is vertical, any fixed linear function of p.
template <class Real>
[[gnu::noinline]] VecOf<Real> starboard_across(VecOf<Real> p) {
  using Vec = VecOf<Real>;
  const Real horizontal = square_root(p.x() * p.x() + p.y() * p.y());
  const Vec level{-p.y() / horizontal, p.x() / horizontal, Real{0.0}};
  const Vec east{Real{0.0}, with_sign_of(Real{1.0}, p.z()), Real{0.0}};
  return select(horizontal > on_axis * magnitude(p.z()), level, east);
}

/// Away from whoever is met in its middle: straight apart.
template <class Real>
[[gnu::noinline]] VecOf<Real> straight_apart(VecOf<Real> p, VecOf<Real> parting) {
  const Real distance = square_root(dot(p, p));
  return select(distance > 0.0, p / -distance, parting);
}

/// Out of the sphere of velocities that bring the two together at a time whose inverse is `rate`, w being
/// v - p `rate`.
template <class Real>
[[gnu::always_inline]] inline ChangeOf<Real> out_of_sphere(const NeighbourOf<Real>& n, const VecOf<Real>& w,
                                                           const Real& w2, const Real& rate) {
  const Real length = square_root(w2);
  VecOf<Real> normal = w / length;
  const MaskOf<Real> is_centre = !(w2 > std::numeric_limits<double>::min());
  if (any(is_centre)) [[unlikely]]
    normal = select(is_centre, straight_apart<Real>(n.p, n.parting), normal);
  return {normal, n.radius * rate - select(is_centre, Real{0.0}, length)};
}

/// Out of the side of the cone. With sin = R / d and f the unit vector from the axis towards v, the normal
/// is cos f - sin p / d, and the apex, at no relative velocity, lies on every tangent plane. This is
/// t = (p.v + |p x v| R / sqrt(d^2 - R^2)) / d^2 without forming v - t p, which cancels.
template <class Real>
[[gnu::always_inline]] inline ChangeOf<Real> out_of_cone(const NeighbourOf<Real>& n, const Real& d2,
                                                         const Real& gap2) {
  const Real inverse_d2 = 1.0 / d2;
  const VecOf<Real> across = n.v - (dot(n.v, n.p) * inverse_d2) * n.p;
  const Real across2 = dot(across, across);
  const Real cos2 = gap2 * inverse_d2;
  VecOf<Real> side = square_root(cos2 / across2) * across;
  const MaskOf<Real> along_axis = !(across2 > on_axis * on_axis * dot(n.v, n.v));
  if (any(along_axis)) [[unlikely]]
    side = select(along_axis, square_root(cos2) * starboard_across<Real>(n.p), side);

  const VecOf<Real> normal = side - (n.radius * inverse_d2) * n.p;
  return {normal, -dot(normal, n.v)};
}

template <class Real>
[[gnu::always_inline]] inline ChangeOf<Real> least_change(const NeighbourOf<Real>& n, double tau,
                                                          double period) {
  const Real d2 = dot(n.p, n.p);
  const Real gap2 = d2 - n.radius * n.radius;
  const MaskOf<Real> overlap = gap2 <= 0.0;
  const Real rate = select(overlap, Real{1.0 / period}, Real{1.0 / tau});

  // the cone is cut off by the sphere at tau: w within the angle that it spans there
  const VecOf<Real> w = n.v - rate * n.p;
  const Real w2 = dot(w, w);
  const Real along = dot(w, n.p);
  const MaskOf<Real> in_sphere = overlap | ((along < 0.0) & (along * along > n.radius * n.radius * w2));

  if (none(in_sphere)) return out_of_cone(n, d2, gap2);
  const ChangeOf<Real> sphere = out_of_sphere(n, w, w2, rate);
  if (none(!in_sphere)) return sphere;
  return select(in_sphere, sphere, out_of_cone(n, d2, gap2));
}

template <class Real>
[[gnu::always_inline]] inline HalfSpaceOf<Real> half_space(const ChangeOf<Real>& change,
                                                           const VecOf<Real>& v_opt, const Real& share) {
  return {change.normal, dot(change.normal, v_opt) + share * change.distance};
}

}  // namespace fairway::lanes
