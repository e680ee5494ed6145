// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "fairway/avoidance/velocity_obstacle/cone.hpp"
#include "fairway/core/lanes/pack.hpp"

/// What making velocity obstacles and trying velocities side by side is compiled from, as kernel_text.hpp.
namespace fairway::lanes {

template <std::size_t N>
void cones_in_lanes(velocity_obstacle::Discs &discs) {
  using Real = Pack<N>;
  const Real own_north = discs.own_north, own_east = discs.own_east;
  for (std::size_t i = 0; i < discs.count; i += N) {
    const PackMask<N> is_there = Real::counting() < static_cast<double>(discs.count - i);
    const auto of = [&](const double *column) { return select(is_there, Real::from(column + i), Real{0.0}); };
    const Real north = of(discs.north), east = of(discs.east), radius = of(discs.radius);
    const Real vo_north = of(discs.velocity_north), vo_east = of(discs.velocity_east);
    const PackMask<N> shares = of(discs.shares) > 0.0;

    const Real distance = square_root(north * north + east * east);
    const PackMask<N> overlaps = distance <= radius * (1.0 + velocity_obstacle::in_line);
    const auto legs = velocity_obstacle::legs_to_disc<Real>(north, east, distance, radius);
    velocity_obstacle::Apex<Real> apex{
        select(shares, 0.5 * (own_north + vo_north), vo_north),
        select(shares, 0.5 * (own_east + vo_east), vo_east),
        select(shares, Real{0.5 * discs.inverse_horizon}, Real{discs.inverse_horizon})};
    if (discs.by_side) {
      const Real sine = legs.port_north * legs.starboard_east - legs.port_east * legs.starboard_north;
      const PackMask<N> moves = shares & !overlaps & (sine > velocity_obstacle::in_line);
      const auto hybrid =
          velocity_obstacle::hybrid_apex<Real>(north, east, radius, legs, vo_north, vo_east, apex);
      apex = {select(moves, hybrid.north, apex.north), select(moves, hybrid.east, apex.east),
              select(moves, hybrid.inverse_horizon, apex.inverse_horizon)};
    }
    apex.north.to(discs.apex_north + i);
    apex.east.to(discs.apex_east + i);
    apex.inverse_horizon.to(discs.cut + i);
    legs.port_north.to(discs.port_north + i);
    legs.port_east.to(discs.port_east + i);
    legs.starboard_north.to(discs.starboard_north + i);
    legs.starboard_east.to(discs.starboard_east + i);
    distance.to(discs.distance + i);
    select(overlaps, Real{1.0}, Real{0.0}).to(discs.overlaps + i);
  }
}

template <std::size_t N>
unsigned outside_in_lanes(const velocity_obstacle::Tried &tried) {
  using Real = Pack<N>;
  const Real north = Real::from(tried.north), east = Real::from(tried.east);
  PackMask<N> is_outside = north <= std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < tried.cone_count; ++k) {
    is_outside =
        is_outside & !(velocity_obstacle::depth_in<Real>(*tried.cones[k], north, east) > tried.slack);
    if (none(is_outside)) break;
  }
  return bits_of(is_outside);
}

}  // namespace fairway::lanes
