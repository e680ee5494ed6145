// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>

#include "fairway/core/angles.hpp"
#include "fairway/core/envelope.hpp"
#include "fairway/core/lanes/number.hpp"

/// How a vehicle moves that keeps to a plan, written once for one plan and for several side by side: `Real`
/// is a number or a pack of them (lanes/number.hpp), to the same bits.
namespace fairway::trackable {

using lanes::larger;
using lanes::magnitude;
using lanes::MaskOf;
using lanes::none;
using lanes::select;
using lanes::smaller;
using lanes::square_root;
using lanes::with_sign_of;

/// What the turn law takes of a vehicle and of its mission.
struct Law {
  static constexpr std::size_t rates = 4;

  double gain{};               ///< of the turn rate over the error of the heading [1/s]
  double turn_share{};         ///< of the greatest turn rate that is used
  double max_turn_rate{};      ///< of the mission, or infinite [rad/s]
  double sure_turn_rate{};     ///< it may turn that fast at any speed [rad/s]
  double top_turn_rate{};      ///< and never faster [rad/s]
  double least{};              ///< speed [m/s]
  double ahead{};              ///< greatest speed [m/s]
  double turn_rates[rates]{};  ///< greatest, at 0, 1/3, 2/3 and 1 of the greatest speed [rad/s]
  double brakes_first_above{///< to stop or to turn round, it turns on as it does until it is that slow [m/s]
                            std::numeric_limits<double>::infinity()};
};

/// How the vehicle answers to what is ordered, in steps of equal length.
struct Response {
  Law law;
  double step{};                        ///< [s]
  double turn_share{}, surge_share{};   ///< of the way to what is ordered, gone in a step
  double plateau{1.0};                  ///< share of an ordered turn rate to which it comes so
  double tail_share{};                  ///< of the way from there to the whole, gone in a step
  double most_turn{};                   ///< by which the turn rate changes in a step [rad/s]
  double most_faster{}, most_slower{};  ///< by which the speed does [m/s]
  double lost_slower{};  ///< of the latter, for each rad/s by which the turn rate changes [m/rad]
  Slip slip;             ///< in a step
  double drift_north{}, drift_east{};        ///< what sets it aside [m/s]
  double standing_north{}, standing_east{};  ///< where who stops turns its bow, unit; zero: it does not
};

/// Relative to where it is now. [m, m/s, rad, rad/s, NED]
template <class Real>
struct Motion {
  Real north, east;
  Real ahead_north, ahead_east;  ///< unit
  Real turn_rate;
  Real speed;
  Real sway;   ///< through the water
  Real error;  ///< from the heading to that of the plan
};

/// A disc or all near a segment, at time 0 relative to own ship, that keeps its velocity. [m, m/s, NED]
struct Hazard {
  double north, east;              ///< of one end of its middle line
  double along_north, along_east;  ///< from there to the other end
  double length2;                  ///< of the middle line, squared [m2]; 0: a disc
  double velocity_north, velocity_east;
  double contact;  ///< own radius and its own
};

/// As std::clamp(). A register takes the smaller of two, or the larger, by one instruction.
template <class Real>
Real clamped(const Real& value, const Real& least, const Real& most) {
  const Real at_most = select(most < value, most, value);
  return select(at_most < least, least, at_most);
}

/// As Envelope::turn_rate(), and what the law and the mission leave of it.
template <class Real>
Real greatest_turn_rate(const Law& law, const Real& speed) {
  constexpr std::size_t last = Law::rates - 1;
  Real rate{law.turn_rates[0]};
  if (law.ahead > 0.0) {
    const Real place = magnitude(speed) / law.ahead * static_cast<double>(last);
    rate = law.turn_rates[0] + place * (law.turn_rates[1] - law.turn_rates[0]);
    for (std::size_t i = 1; i < last; ++i) {
      const double from = static_cast<double>(i);
      rate = select(place < from, rate,
                    law.turn_rates[i] + (place - from) * (law.turn_rates[i + 1] - law.turn_rates[i]));
    }
    rate = select(place < static_cast<double>(last), rate, Real{law.turn_rates[last]});
  }
  return smaller<Real>(law.turn_share * rate, law.max_turn_rate);
}

/// Ordered where a course needs `error` [rad] more to starboard, at `speed` [m/s] through the water. What may
/// be turned at any speed does not wait for the speed to be known.
template <class Real>
Real turn_order(const Law& law, const Real& error, const Real& speed) {
  const Real wanted = law.gain * error;
  if (none(magnitude(wanted) > law.sure_turn_rate)) return wanted;
  const Real most = greatest_turn_rate(law, speed);
  return clamped<Real>(wanted, -most, most);
}

/// Ordered of the `wanted` speed; `along` is the cosine of the angle by which the heading is off.
template <class Real>
Real surge_order(const Law& law, const Real& wanted, const Real& along) {
  const Real share = larger<Real>(0.0, along);
  return larger<Real>(wanted * share * share, law.least);
}

/// Of who is ordered to go at `surge`; who is to stop, or to turn round, turns when it has braked.
template <class Real>
Real turn_order_after(const Real& surge, const Law& law, const Motion<Real>& m) {
  const Real turn = turn_order(law, m.error, m.speed);
  const MaskOf<Real> brakes = (surge <= law.least) & (m.speed > law.brakes_first_above);
  return none(brakes) ? turn : select(brakes, m.turn_rate, turn);
}

/// The direction (along, across) as math::atan2 has it, within 2e-8 rad (Abramowitz and Stegun, 4.4.49).
template <class Real>
Real angle_of(const Real& across, const Real& along) {
  const Real x = magnitude(along), y = magnitude(across);
  const Real tangent = smaller(x, y) / larger<Real>(larger(x, y), std::numeric_limits<double>::min());
  const Real z = tangent * tangent;
  Real sum = 0.0028662257;
  for (const double term : {-0.0161657367, 0.0429096138, -0.0752896400, 0.1065626393, -0.1420889944,
                            0.1999355085, -0.3333314528, 1.0})
    sum = sum * z + term;
  Real angle = tangent * sum;
  angle = select(x < y, 0.5 * pi - angle, angle);
  angle = select(along < 0.0, pi - angle, angle);
  return with_sign_of(angle, across);
}

/// A direction of the bow, unit. [NED]
template <class Real>
struct Heading {
  Real north, east;

  /// The turn to it [rad].
  Real error(const Motion<Real>& m) const {
    return angle_of<Real>(m.ahead_north * east - m.ahead_east * north,
                          m.ahead_north * north + m.ahead_east * east);
  }
};

/// Where the bow has to point for a direction to be made good at a speed: up into the drift.
template <class Real>
Heading<Real> heading_for(const Response& can, const Real& north, const Real& east, const Real& speed) {
  constexpr double most_sine = 0.7;
  const Real aside = (north * can.drift_east - east * can.drift_north) / speed;
  const Real sine = select(speed > 0.0, -clamped<Real>(aside, -most_sine, most_sine), Real{0.0});
  const Real cosine = square_root(1.0 - sine * sine);
  return {cosine * north - sine * east, sine * north + cosine * east};
}

template <class Real>
void turn(const Real& sine, const Real& cosine, Motion<Real>& m) {
  const Real north = cosine * m.ahead_north - sine * m.ahead_east;
  m.ahead_east = sine * m.ahead_north + cosine * m.ahead_east;
  m.ahead_north = north;
}

/// By how much a turn rate changes in a step that is at `rate` where `ordered` is.
template <class Real>
Real taken_up(const Response& can, const Real& ordered, const Real& rate) {
  if (can.plateau >= 1.0) return can.turn_share * (ordered - rate);
  const MaskOf<Real> slackens = (magnitude(ordered) <= magnitude(rate)) & (0.0 < rate * ordered);
  const Real soon = can.turn_share * (select(slackens, ordered, can.plateau * ordered) - rate);
  const Real late = can.tail_share * (ordered - rate);
  return select(ordered > rate, larger(soon, late), smaller(soon, late));
}

/// One step: turn rate and speed approach what is ordered, and the hull slips about its pivot. Directions
/// keep their length within 1e-3 in as many steps as there are, by less than 0.7 rad each.
template <class Real>
[[gnu::always_inline]] inline void advance(const Response& can, const Real& surge, const Real& turn_rate,
                                           Motion<Real>& m) {
  const Real rate = m.turn_rate, speed = m.speed;
  const Real quicker = clamped<Real>(taken_up(can, turn_rate, rate), -can.most_turn, can.most_turn);
  const Real most_slower = can.most_slower - can.lost_slower * magnitude(quicker);
  m.turn_rate = rate + quicker;
  m.speed = speed + clamped<Real>(can.surge_share * (surge - speed), -most_slower, can.most_faster);
  m.error = m.error - can.step * rate - 0.5 * can.step * quicker;

  // half the turn, the way, the other half
  const Real half = 0.25 * can.step * (rate + m.turn_rate), half2 = half * half;
  const Real sine = half - half * half2 * (1.0 / 6 - 1.0 / 120 * half2);
  const Real cosine = 1.0 - half2 * (1.0 / 2 - 1.0 / 24 * half2);
  turn(sine, cosine, m);
  m.sway = can.slip.after(m.sway, m.speed, m.turn_rate);
  const Real along = 0.5 * (speed + m.speed);
  const Real across =
      can.drift_north * -m.ahead_east + can.drift_east * m.ahead_north + m.sway;  // to starboard
  m.north = m.north + can.step * (along * m.ahead_north + across * -m.ahead_east);
  m.east = m.east + can.step * (along * m.ahead_east + across * m.ahead_north);
  turn(sine, cosine, m);
}

/// One step towards a heading, at a speed.
template <class Real>
[[gnu::always_inline]] inline void follow(const Response& can, const Heading<Real>& heading,
                                          const Real& speed, Motion<Real>& m) {
  const Real along = m.ahead_north * heading.north + m.ahead_east * heading.east;
  const Real surge = surge_order(can.law, speed, along);
  advance<Real>(can, surge, turn_order_after(surge, can.law, m), m);
}

/// Squared distance from the middle line of a hazard, after `time` [s]. [m2]
template <class Real>
Real distance2(const Hazard& hazard, double time, const Real& north, const Real& east) {
  const Real to_north = north - time * hazard.velocity_north - hazard.north;
  const Real to_east = east - time * hazard.velocity_east - hazard.east;
  if (!(hazard.length2 > 0.0)) return to_north * to_north + to_east * to_east;
  const Real share =
      clamped<Real>((hazard.along_north * to_north + hazard.along_east * to_east) / hazard.length2, 0.0, 1.0);
  const Real off_north = to_north - share * hazard.along_north;
  const Real off_east = to_east - share * hazard.along_east;
  return off_north * off_north + off_east * off_east;
}

/// Squared distance of a point from a line that goes from the origin along (along_north, along_east). [m2]
template <class Real>
Real from_way2(const Real& north, const Real& east, const Real& along_north, const Real& along_east) {
  const Real length2 =
      larger<Real>(along_north * along_north + along_east * along_east, std::numeric_limits<double>::min());
  const Real share = clamped<Real>((along_north * north + along_east * east) / length2, Real{0.0}, Real{1.0});
  const Real off_north = north - share * along_north, off_east = east - share * along_east;
  return off_north * off_north + off_east * off_east;
}

/// The least squared distance from the middle line of a hazard within a step that is gone straight and
/// evenly, from (before_north, before_east) after `before` [s] to (north, east) after `time`. [m2]
template <class Real>
Real distance2_within(const Hazard& hazard, double before, const Real& before_north, const Real& before_east,
                      double time, const Real& north, const Real& east) {
  // as the hazard sees it: the way goes on from `from`, the middle line from the origin
  const Real from_north = before_north - before * hazard.velocity_north - hazard.north;
  const Real from_east = before_east - before * hazard.velocity_east - hazard.east;
  const Real to_north = north - time * hazard.velocity_north - hazard.north;
  const Real to_east = east - time * hazard.velocity_east - hazard.east;
  const Real way_north = to_north - from_north, way_east = to_east - from_east;
  const Real of_one_end = from_way2<Real>(-from_north, -from_east, way_north, way_east);
  if (!(hazard.length2 > 0.0)) return of_one_end;

  const Real line_north{hazard.along_north}, line_east{hazard.along_east};
  const Real of_other_end =
      from_way2<Real>(line_north - from_north, line_east - from_east, way_north, way_east);
  const Real of_ends = smaller<Real>(of_one_end, of_other_end);
  const Real of_way = smaller<Real>(from_way2<Real>(from_north, from_east, line_north, line_east),
                                    from_way2<Real>(to_north, to_east, line_north, line_east));
  const Real side_before = line_north * from_east - line_east * from_north;
  const Real side_after = line_north * to_east - line_east * to_north;
  const Real side_of_one = way_east * from_north - way_north * from_east;
  const Real side_of_other = side_of_one + (way_north * line_east - way_east * line_north);
  const MaskOf<Real> crosses =
      (side_before * side_after < Real{0.0}) & (side_of_one * side_of_other < Real{0.0});
  return select(crosses, Real{0.0}, smaller<Real>(of_ends, of_way));
}

}  // namespace fairway::trackable
