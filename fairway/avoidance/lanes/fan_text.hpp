// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "fairway/avoidance/lanes/pack.hpp"
#include "fairway/avoidance/trackable/fan.hpp"

/// What rolling out plans side by side is compiled from, as kernel_text.hpp.
namespace fairway::lanes {

template <std::size_t N>
trackable::Motion<Pack<N>> motion_at(const trackable::Fan::Column *columns) {
  const auto at = [&](std::size_t i) { return Pack<N>::from(columns[i]); };
  return {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
}

template <std::size_t N>
void write_motion(const trackable::Motion<Pack<N>> &m, trackable::Fan::Column *columns) {
  m.north.to(columns[0]);
  m.east.to(columns[1]);
  m.ahead_north.to(columns[2]);
  m.ahead_east.to(columns[3]);
  m.turn_rate.to(columns[4]);
  m.speed.to(columns[5]);
  m.sway.to(columns[6]);
  m.error.to(columns[7]);
}

template <std::size_t N>
void roll_in_lanes(trackable::Fan &fan) {
  using Real = Pack<N>;
  const trackable::Response &can = *fan.response;
  trackable::Motion<Real> m = motion_at<N>(fan.motion);
  const Real heading_north = Real::from(fan.heading_north), heading_east = Real::from(fan.heading_east);
  const Real speed = Real::from(fan.speed);

  // the root of the least square is the least root, rounded or not: one root for each hazard
  Real least2[trackable::most_hazards];
  for (std::size_t i = 0; fan.asks_room && i < fan.hazard_count; ++i)
    least2[i] = std::numeric_limits<double>::infinity();

  const Real zero{0.0};
  PackMask<N> is_clear = zero <= zero;
  Real clear_steps{static_cast<double>(trackable::foresight_steps)};
  for (std::size_t k = fan.begin; k < trackable::foresight_steps; ++k) {
    if (k == fan.hold_steps) write_motion<N>(m, fan.held);
    if (fan.circles)
      trackable::advance<Real>(can, m.speed, heading_north, m);
    else
      trackable::follow<Real>(can, heading_north, heading_east, speed, m);

    const double time = static_cast<double>(k + 1) * can.step;
    PackMask<N> is_near = zero < zero;
    for (std::size_t i = 0; i < fan.hazard_count; ++i) {
      if (k < fan.first_steps[i]) continue;
      const Real d2 = trackable::distance2<Real>(fan.hazards[i], time, m.north, m.east);
      is_near = is_near | (d2 < fan.near2[i]);
      if (fan.asks_room) least2[i] = smaller(least2[i], d2);
    }
    clear_steps = select(is_near & is_clear, Real{static_cast<double>(k)}, clear_steps);
    is_clear = is_clear & !is_near;
    if (none(is_clear)) break;
  }
  clear_steps.to(fan.clear_steps);
  if (!fan.asks_room) return;

  Real room{std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < fan.hazard_count; ++i)
    room = smaller<Real>(room, square_root(least2[i]) - fan.hazards[i].contact);
  room.to(fan.room);
}

}  // namespace fairway::lanes
