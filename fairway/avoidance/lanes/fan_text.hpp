// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "fairway/avoidance/trackable/fan.hpp"
#include "fairway/core/lanes/pack.hpp"

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

/// What the plans are, and where they begin.
template <std::size_t N>
struct Begun {
  using Real = Pack<N>;

  trackable::Motion<Real> motion;
  trackable::Heading<Real> heading;
  Real speed;
  Real turn_rate;  // of who circles

  explicit Begun(const trackable::Fan &fan) {
    using Plans = trackable::Fan::Plans;
    if (fan.plans == Plans::courses)
      begin_courses(fan);
    else if (fan.plans == Plans::stop)
      begin_to_stop(fan);
    else
      begin_circles(fan);
  }

  void begin_courses(const trackable::Fan &fan) {
    const trackable::Courses &all = *fan.courses;
    const Real cosine = Real::from(all.cosines + fan.first),
               sine = all.side * Real::from(all.sines + fan.first);
    speed = Real::from(all.speeds + fan.first);
    heading = trackable::heading_for<Real>(*fan.response, cosine * all.north - sine * all.east,
                                           sine * all.north + cosine * all.east, speed);
    const trackable::Motion<double> &now = *fan.now;
    motion = {now.north,     now.east,  now.ahead_north, now.ahead_east,
              now.turn_rate, now.speed, now.sway,        now.error};
    motion.error = heading.error(motion);
  }

  void begin_to_stop(const trackable::Fan &fan) {
    motion = motion_at<N>(fan.motion);
    const trackable::Response &can = *fan.response;
    const bool turns = can.standing_north != 0.0 || can.standing_east != 0.0;
    heading = turns ? trackable::Heading<Real>{can.standing_north, can.standing_east}
                    : trackable::Heading<Real>{motion.ahead_north, motion.ahead_east};
    motion.error = turns ? heading.error(motion) : Real{0.0};
    speed = 0.0;
  }

  void begin_circles(const trackable::Fan &fan) {
    motion = motion_at<N>(fan.motion);
    turn_rate = Real::from(fan.side) * trackable::greatest_turn_rate<Real>(fan.response->law, motion.speed);
  }
};

template <std::size_t N, bool looks_within>
void roll_fan(trackable::Fan &fan) {
  using Real = Pack<N>;
  const trackable::Response &can = *fan.response;
  const Begun<N> plan{fan};
  trackable::Motion<Real> m = plan.motion;
  const bool circles = fan.plans == trackable::Fan::Plans::circle;

  // the root of the least square is the least root, rounded or not: one root for each hazard
  Real least2[trackable::most_hazards];
  for (std::size_t i = 0; fan.asks_room && i < fan.hazard_count; ++i)
    least2[i] = std::numeric_limits<double>::infinity();

  const Real zero{0.0};
  PackMask<N> is_clear = zero <= zero;
  Real clear_steps{static_cast<double>(fan.steps)};
  for (std::size_t k = fan.begin; k < fan.steps; ++k) {
    if (k == fan.hold_steps) write_motion<N>(m, fan.held);
    const Real before_north = m.north, before_east = m.east;
    if (circles)
      trackable::advance<Real>(can, m.speed, plan.turn_rate, m);
    else
      trackable::follow<Real>(can, plan.heading, plan.speed, m);

    const double before = static_cast<double>(k) * can.step;
    const double time = static_cast<double>(k + 1) * can.step;
    PackMask<N> is_near = zero < zero;
    for (std::size_t i = 0; i < fan.hazard_count; ++i) {
      if (k < fan.first_steps[i]) continue;
      Real d2 = trackable::distance2<Real>(fan.hazards[i], time, m.north, m.east);
      if (looks_within && fan.within2[i] > 0.0) {
        const Real within2 = trackable::distance2_within<Real>(fan.hazards[i], before, before_north,
                                                               before_east, time, m.north, m.east);
        const PackMask<N> is_met = within2 < fan.within2[i];
        if (fan.asks_room)
          d2 = select(is_met, smaller(d2, within2), d2);
        else
          is_near = is_near | is_met;
      }
      is_near = is_near | (d2 < fan.near2[i]);
      if (fan.asks_room) least2[i] = smaller(least2[i], d2);
    }
    clear_steps = select(is_near & is_clear, Real{static_cast<double>(k)}, clear_steps);
    is_clear = is_clear & !is_near;
    if (none(is_clear)) break;
  }
  clear_steps.to(fan.clear_steps);
  if (!fan.asks_room) return;

  const double end = static_cast<double>(fan.steps) * can.step;
  Real room{std::numeric_limits<double>::infinity()}, last_room = room;
  for (std::size_t i = 0; i < fan.hazard_count; ++i) {
    const Real last2 = trackable::distance2<Real>(fan.hazards[i], end, m.north, m.east);
    room = smaller<Real>(room, square_root(least2[i]) - fan.hazards[i].contact);
    last_room = smaller<Real>(last_room, square_root(last2) - fan.hazards[i].contact);
  }
  room.to(fan.room);
  last_room.to(fan.last_room);
}

template <std::size_t N>
void roll_in_lanes(trackable::Fan &fan) {
  if (fan.within2 != nullptr)
    roll_fan<N, true>(fan);
  else
    roll_fan<N, false>(fan);
}

}  // namespace fairway::lanes
