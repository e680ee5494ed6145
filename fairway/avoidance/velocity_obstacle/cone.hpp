// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "fairway/core/lanes/number.hpp"

/// What velocity obstacles are made of, and whether velocities are in them, written once for one number and
/// for several side by side: `Real` is a number or a pack of them (core/lanes/number.hpp), to the same bits.
namespace fairway::velocity_obstacle {

using lanes::larger;
using lanes::MaskOf;
using lanes::none;
using lanes::select;
using lanes::smaller;
using lanes::square_root;

/// A velocity obstacle: between its legs, beyond its cut. [m/s, NED]
struct Cone {
  double apex_north, apex_east;
  double port_north, port_east;  ///< unit, along the legs
  double starboard_north, starboard_east;
  double near_north, near_east;  ///< from the apex, the middles of the ends of the cut
  double far_north, far_east;
  double radius;  ///< of the cut
  bool is_disc;   ///< the cut has one end

  bool overlaps;                 ///< instead, all that does not lead out:
  double away_north, away_east;  ///< unit
  double rate;                   ///< (v - apex) . away >= rate does
};

/// Below this sine two directions are one.
inline constexpr double in_line = 1e-9;

/// Unit, along the legs of a cone.
template <class Real>
struct Legs {
  Real port_north, port_east, starboard_north, starboard_east;
};

/// The tangents to a disc that is `distance` away, more than its radius: at the half angle arcsin(R / d) to
/// both sides.
template <class Real>
Legs<Real> legs_to_disc(const Real& north, const Real& east, const Real& distance, const Real& radius) {
  const Real sine = radius / distance;
  const Real cosine = square_root((1.0 - sine) * (1.0 + sine));
  const Real along = north / distance, across = east / distance;
  return {cosine * along + sine * across, cosine * across - sine * along, cosine * along - sine * across,
          cosine * across + sine * along};
}

/// Where a cone begins, and 1 / the horizon of its cut, seen from there.
template <class Real>
struct Apex {
  Real north, east, inverse_horizon;
};

/// That of HRVO, of a disc, given those of VO and of RVO.
template <class Real>
Apex<Real> hybrid_apex(const Real& north, const Real& east, const Real& radius, const Legs<Real>& legs,
                       const Real& vo_north, const Real& vo_east, const Apex<Real>& rvo) {
  // from the apex of VO to that of RVO, along the legs: e = a other + b kept
  const Real e_north = rvo.north - vo_north, e_east = rvo.east - vo_east;
  const Real distance2 = north * north + east * east;
  const MaskOf<Real> passes_to_starboard =
      north * e_east - east * e_north >=
      -in_line * square_root(distance2) * square_root(e_north * e_north + e_east * e_east);
  const Real kept_north = select(passes_to_starboard, legs.starboard_north, legs.port_north);
  const Real kept_east = select(passes_to_starboard, legs.starboard_east, legs.port_east);
  const Real other_north = select(passes_to_starboard, legs.port_north, legs.starboard_north);
  const Real other_east = select(passes_to_starboard, legs.port_east, legs.starboard_east);
  const Real b =
      (other_north * e_east - other_east * e_north) / (other_north * kept_east - other_east * kept_north);

  // so the legs meet at b before the apex of RVO, whose leg is cut off where it was
  const Real tangent = square_root(distance2 - radius * radius);
  return {rvo.north - b * kept_north, rvo.east - b * kept_east,
          larger<Real>(rvo.inverse_horizon + b / tangent, 0.0)};
}

/// Discs side by side, in columns, and what their cones come to. The columns are as long as a whole number of
/// lanes. [m, m/s, NED, relative to own ship]
struct Discs {
  static constexpr std::size_t most = 64;  ///< at once
  using Column = double[most];

  std::size_t count = 0;
  double own_north{}, own_east{};                ///< v_u [m/s]
  double inverse_horizon{}, inverse_interval{};  ///< [1/s]
  bool by_side{};                                ///< of HRVO, else of RVO, where a disc shares

  alignas(64) Column north, east, radius, velocity_north, velocity_east;
  alignas(64) Column shares;  ///< 1: RVO or HRVO; 0: VO

  alignas(64) Column apex_north, apex_east, port_north, port_east, starboard_north, starboard_east;
  alignas(64) Column cut;       ///< 1 / the horizon, seen from the apex [1/s]
  alignas(64) Column distance;  ///< [m]
  alignas(64) Column overlaps;  ///< 1 or 0
};

/// Velocities that may be in obstacles.
struct Tried {
  const Cone* const* cones{};
  std::size_t cone_count{};
  double slack{};                  ///< less deep is outside [m/s]
  const double *north{}, *east{};  ///< as many as there are lanes [m/s]
};

/// VelocityObstacle::depth()
template <class Real>
Real depth_in(const Cone& cone, const Real& north, const Real& east) {
  const Real w_north = north - cone.apex_north, w_east = east - cone.apex_east;
  if (cone.overlaps) return cone.rate - (w_north * cone.away_north + w_east * cone.away_east);

  // before the cut: the nearest of what is left of the cone is where the solid looks at us
  Real out_north = w_north - cone.near_north, out_east = w_east - cone.near_east;
  if (!cone.is_disc) {
    const double along_north = cone.far_north - cone.near_north;
    const double along_east = cone.far_east - cone.near_east;
    const double length2 = along_north * along_north + along_east * along_east;
    if (length2 > 0.0) {
      const Real place = (out_north * along_north + out_east * along_east) / length2;
      const Real share = larger<Real>(0.0, smaller<Real>(place, 1.0));
      out_north = w_north - (cone.near_north + share * along_north);
      out_east = w_east - (cone.near_east + share * along_east);
    }
  }
  const Real inside = smaller<Real>(cone.port_north * w_east - cone.port_east * w_north,
                                    w_north * cone.starboard_east - w_east * cone.starboard_north);
  const auto is_before = (out_north * cone.port_north + out_east * cone.port_east <= 0.0) &
                         (out_north * cone.starboard_north + out_east * cone.starboard_east <= 0.0);
  if (none(is_before)) return inside;
  return select(is_before, cone.radius - square_root(out_north * out_north + out_east * out_east), inside);
}

}  // namespace fairway::velocity_obstacle
