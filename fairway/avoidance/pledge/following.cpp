// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/following.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::pledge {
namespace {

constexpr double look_ahead = 2.0;       // of the reference's velocity, for the vehicle's lag and slip [s]
constexpr double steepest_share = 0.85;  // of a member's speed is at most for climbing and diving
constexpr double same_level = 0.5;       // within it a destination needs no climb to speak of [m]
constexpr double return_gain = 0.3;      // to its anchor [1/s]
constexpr double still = 0.075;  // who would go slower than this through the water does not turn [m/s]
constexpr double halting =
    0.015;  // whose reference goes no faster halts or turns; a step is told as 0.02 [m/s]
constexpr double most_drift_share = 0.5;  // of what a member is to go, that its course makes up for
constexpr double least_astern = 0.1;      // with which a member that is held goes back astern [m/s]
constexpr double aside_for_good = 1.5;    // who is held and farther off than this turns to its anchor [m]
constexpr double off_its_way = 0.5;       // that a member mostly is at most [m]
constexpr double allowance = 1.0;         // of its depths and its radius as they are told, and more [m]
constexpr double slack = 0.2;             // across, that a member that is held does not turn for [m]
constexpr int longest_wait = 20;          // of a member for its turn [s]
constexpr double turn_gain = 0.5;         // [1/s]
constexpr double fastest_turn = 0.8;      // [rad/s]

/// The course through the water that makes a velocity over ground. A hull takes up what sets it aside only
/// slowly, so abeam what counts is how it drifts, not how the water does. No more of that than a share of
/// what it is to go, though: who hardly goes would turn after its own drift, round and round.
double course_of(const Situation& s, const Vec3& over_ground) noexcept {
  Vec2 w = over_ground.head<2>() - s.current.head<2>();
  const Vec2 abeam = starboard_of(unit_at(s.own.yaw));
  const double most = most_drift_share * w.norm();
  w -= std::clamp((s.own.velocity - s.current).head<2>().dot(abeam), -most, most) * abeam;
  return math::atan2(w.y(), w.x());
}

/// What it goes in one direction alone, of which it plans for a share.
double alone(const Situation& s, double Envelope::*direction, double share) noexcept {
  const double all = share * std::min(s.goal.cruise_speed, s.limits.max_speed);
  return s.envelope != nullptr ? math::fmin(share * s.envelope->*direction, all) : all;
}

/// At which it climbs or dives on its way to its goal.
double vertical_of(const Situation& s, double up, double down) noexcept {
  const double deeper = s.goal.position.z() - s.own.position.z();
  return std::fabs(deeper) < same_level ? 0.0 : deeper > 0.0 ? down : up;
}

/// What it goes along its way beside that.
double along_beside(const Situation& s, double vertical, double share) noexcept {
  const double all = share * std::min(s.goal.cruise_speed, s.limits.max_speed);
  const bool is_at_its_most = s.envelope != nullptr && s.envelope->ahead < 0.98 * s.limits.max_speed;
  const double ahead = is_at_its_most
                           ? math::fmin(share * s.envelope->ahead - horizontal_norm(s.current), all)
                           : alone(s, &Envelope::ahead, share);
  return math::fmin(ahead, std::sqrt(math::fmax(all * all - vertical * vertical, 0.0)));
}

/// Its speeds as they are told: rounded up only where that leaves half of what it has to spare, since it has
/// to come back to its way when it is off it.
void round_speeds(const Situation& s, Member& member) noexcept {
  const auto climb = [&](double planned, double Envelope::*direction) {
    const double most = math::fmin(alone(s, direction, 1.0), s.limits.max_climb_rate);
    return climb_as_told(planned, 0.5 * (planned + most));
  };
  member.climb = climb(member.climb, &Envelope::up);
  member.descent = climb(member.descent, &Envelope::down);
  const double most = along_beside(s, vertical_of(s, member.climb, member.descent), 1.0);
  member.speed = speed_as_told(member.speed, 0.5 * (member.speed + most));
}

/// For all levels, if its way may be told to be level.
bool has_room_below(const Member& member, double floor) noexcept {
  const double from = member.anchor.z(), to = member.destination.z();
  const bool may_be_level = std::fabs(to - from) < level_within + allowance;
  return !may_be_level || math::fmax(from, to) + most_levels * level_step(member) + allowance <= floor;
}

/// A little way back to its anchor, ahead or astern, whichever is nearer: who turns round for that
/// overshoots, and turns round again.
Command nudged(const Situation& s, const Vec3& off, const Vec3& back, std::string_view why) noexcept {
  const Vec2 ahead = unit_at(s.own.yaw);
  const double along = off.head<2>().dot(ahead), across = off.head<2>().dot(starboard_of(ahead));
  const double course_off = math::atan2(along < 0.0 ? -across : across, std::fabs(along));
  const bool is_abeam = std::fabs(across) > slack;
  const double turn_rate = is_abeam ? std::clamp(turn_gain * course_off, -fastest_turn, fastest_turn) : 0.0;
  const Vec2 made = back.head<2>().dot(ahead) * ahead;
  return {
      .velocity = {made.x(), made.y(), back.z()}, .mode = Mode::hold, .turn_rate = turn_rate, .note = why};
}

}  // namespace

bool is_in_current(const Situation& s) noexcept { return horizontal_norm(s.current) > noticed_current; }

Vec3 within_limits(const Situation& s, const Vec3& v) noexcept {
  const double up = s.envelope != nullptr ? s.envelope->up : s.limits.max_speed;
  const double down = s.envelope != nullptr ? s.envelope->down : s.limits.max_speed;
  const double vertical =
      std::clamp(v.z(), -std::min(up, s.limits.max_speed), std::min(down, s.limits.max_speed));
  const double beside = std::sqrt(s.limits.max_speed * s.limits.max_speed - vertical * vertical);
  const double level = horizontal_norm(v);
  const Vec2 horizontal = (level > beside ? beside / level : 1.0) * v.head<2>();
  return {horizontal.x(), horizontal.y(), vertical};
}

Member member_of(const Situation& s, double speed_ratio) noexcept {
  const double all = speed_ratio * std::min(s.goal.cruise_speed, s.limits.max_speed);
  const double steepest = std::min(steepest_share * all, s.limits.max_climb_rate);
  const double up = math::fmin(alone(s, &Envelope::up, speed_ratio), steepest);
  const double down = math::fmin(alone(s, &Envelope::down, speed_ratio), steepest);
  const bool can_turn = s.envelope != nullptr && s.envelope->turn_rates[0] > 0.0;
  const double turn_rate = can_turn ? std::min(s.envelope->turn_rates[0], fastest_turn) : 0.3;
  return {.anchor = s.own.position,
          .destination = s.goal.position,
          .arrival = s.goal.arrival,
          .radius = s.own.radius,
          .speed = along_beside(s, vertical_of(s, up, down), speed_ratio),
          .climb = up,
          .descent = down,
          .turn = 1.5 + std::numbers::pi / turn_rate};
}

Member member_of(const Situation& s, double speed_ratio, const Vec3& anchor,
                 const Vec3& destination) noexcept {
  Member member = member_of(s, speed_ratio);
  round_speeds(s, member);
  member.anchor = anchor;
  member.destination = destination;
  if (!has_room_below(member, s.limits.max_depth)) member.descent = std::min(member.descent, level_keeping);
  return member;
}

double beyond_tube(const Ownship& own, double tube) noexcept {
  return own.position_sigma > 0.0 ? math::fmax(own.position_error() + off_its_way - tube, 0.0) : 0.0;
}

Vec3 resting_place(const Situation& s) noexcept {
  Vec3 place = s.own.position + stopping * s.own.velocity;
  place.z() = math::fmax(place.z(), std::min(0.0, s.own.position.z()));
  return place;
}

std::optional<double> course_at(const Situation& s, const Reference& way, double time) noexcept {
  const Vec3 v = way.velocity(time);
  return horizontal_norm(v) > halting ? std::optional{course_of(s, v)} : std::nullopt;
}

std::optional<double> next_course(const Situation& s, const Reference& way, double turn) noexcept {
  for (int ahead = 0; ahead <= longest_wait; ++ahead) {
    const std::optional<double> course = course_at(s, way, s.time + ahead);
    if (!course) continue;
    const double takes = turn * (0.3 + 0.7 * std::fabs(wrap_angle(*course - s.own.yaw)) / std::numbers::pi);
    return is_in_current(s) && ahead > takes ? std::nullopt : course;
  }
  return {};
}

Command driven(const Situation& s, const Vec3& wanted, std::optional<double> course, Mode mode,
               std::string_view note, double astern) noexcept {
  const Vec2 ahead = unit_at(s.own.yaw), current = s.current.head<2>();
  const double through = math::fmax((wanted.head<2>() - current).dot(ahead), -astern);
  const Vec2 made = (through + current.dot(ahead)) * ahead;
  if (!course && horizontal_norm(wanted - s.current) > still) course = course_of(s, wanted);
  const double turn_rate =
      course ? std::clamp(turn_gain * wrap_angle(*course - s.own.yaw), -fastest_turn, fastest_turn) : 0.0;
  return {.velocity = {made.x(), made.y(), wanted.z()}, .mode = mode, .turn_rate = turn_rate, .note = note};
}

Command held(const Situation& s, const Vec3& anchor, std::string_view why,
             std::optional<double> course) noexcept {
  const Vec3 off = anchor - s.own.position;
  const Vec3 back = clamp_norm(return_gain * off, 0.3);
  const double astern = s.envelope != nullptr ? s.envelope->astern : 0.0;
  const bool can_back = astern > least_astern;
  const bool turns = course || is_in_current(s) || !can_back || horizontal_norm(off) > aside_for_good;
  return turns ? driven(s, back, course, Mode::hold, why, course ? astern : 0.0) : nudged(s, off, back, why);
}

Command followed(const Situation& s, const Reference& way, double turn, const Following& following) noexcept {
  const Vec3 off = way.at(s.time) - s.own.position;
  const bool is_to_stop = s.time + look_ahead >= following.stops;
  const Vec3 ahead = is_to_stop ? Vec3::Zero() : way.velocity(s.time + look_ahead);
  const Vec3 velocity = within_limits(s, ahead + following.gain * off);
  // while the reference turns on the spot, so does the vehicle
  const double along = horizontal_norm(ahead);
  const bool turns = !is_to_stop && along <= halting;
  auto course = turns ? next_course(s, way, turn) : std::nullopt;
  // who is to go slowly turns all the same
  if (along > halting && horizontal_norm(velocity - s.current) > 0.5 * along) course = course_of(s, velocity);
  const bool keeps_tube = off.norm() <= following.tube;
  return driven(s, velocity, course, keeps_tube ? Mode::avoid : Mode::infeasible,
                keeps_tube ? "" : "is farther from its promised place than its tube");
}

void draw(const Reference& way, double time, double tube, Sketch& sketch) noexcept {
  std::array<Vec3, Reference::most_knots> points;
  std::size_t count = 0;
  for (const Knot& knot : way.knots()) points[count++] = knot.position;
  sketch.path(std::span{points}.first(count), "promised way");
  sketch.sphere(way.at(time), tube, "tube");
}

}  // namespace fairway::pledge
