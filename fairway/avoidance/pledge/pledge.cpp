// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/pledge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

using pledge::Agreement;
using pledge::Member;
using pledge::Reference;

constexpr double look_ahead = 2.0;    // of the reference's velocity, for the vehicle's lag and slip [s]
constexpr double at_rest = 0.05;      // slower than this a member is held [m/s]
constexpr double settling = 4.0;      // for so long, since it may be on its way back [s]
constexpr double near = 0.25;         // to its anchor a member does not turn towards it [m]
constexpr double turn_gain = 0.5;     // [1/s]
constexpr double fastest_turn = 0.8;  // [rad/s]

/// How it goes with all of it at once within its greatest speed: what is left of that beside climbing.
Member member_of(const Situation& s, double speed_ratio) noexcept {
  const double all = speed_ratio * std::min(s.goal.cruise_speed, s.limits.max_speed);
  const bool is_known = s.envelope != nullptr;
  const double up = std::min(is_known ? speed_ratio * s.envelope->up : all, s.limits.max_climb_rate);
  const double down = std::min(is_known ? speed_ratio * s.envelope->down : all, s.limits.max_climb_rate);
  const double vertical = s.goal.position.z() > s.own.position.z() ? down : up;
  const double ahead = is_known ? math::fmin(speed_ratio * s.envelope->ahead, all) : all;
  const double beside = std::sqrt(math::fmax(all * all - vertical * vertical, 0.25 * all * all));
  const double turn_rate =
      is_known && s.envelope->turn_rates[0] > 0.0 ? std::min(s.envelope->turn_rates[0], fastest_turn) : 0.3;
  return {.anchor = s.own.position,
          .destination = s.goal.position,
          .arrival = s.goal.arrival,
          .radius = s.own.radius,
          .speed = math::fmin(ahead, beside),
          .climb = up,
          .descent = down,
          .turn = 1.5 + std::numbers::pi / turn_rate};
}

/// The course on which the reference goes, or will go next; nothing where it goes no more.
std::optional<double> next_course(const Reference& way, double time) noexcept {
  constexpr int longest = 20;  // a member waits for its turn [s]
  for (int ahead = 0; ahead <= longest; ++ahead) {
    const Vec3 v = way.velocity(time + ahead);
    if (horizontal_norm(v) > 0.02) return math::atan2(v.y(), v.x());
  }
  return {};
}

/// What of a velocity a vehicle makes that goes ahead and up or down, and turns meanwhile.
Vec3 along_heading(const Vec3& velocity, double yaw) noexcept {
  const Vec2 ahead = unit_at(yaw);
  const Vec2 made = math::fmax(velocity.head<2>().dot(ahead), 0.0) * ahead;
  return {made.x(), made.y(), velocity.z()};
}

/// Of the vehicle's turning, whatever the steering of its scenario: towards where it is to go.
double turn_rate_to(const std::optional<double>& course, double yaw) noexcept {
  return course ? std::clamp(turn_gain * wrap_angle(*course - yaw), -fastest_turn, fastest_turn) : 0.0;
}

/// Back to the anchor, ahead: who only stops where it is drifts sideways for long.
Command held(const Situation& s, const Vec3& anchor, std::string_view why) noexcept {
  const Vec3 off = anchor - s.own.position;
  const bool is_near = horizontal_norm(off) < near;
  const auto course = is_near ? std::nullopt : std::optional{math::atan2(off.y(), off.x())};
  const Vec3 velocity = clamp_norm(0.3 * off, 0.3);
  return {.velocity = along_heading(velocity, s.own.yaw),
          .mode = Mode::hold,
          .turn_rate = turn_rate_to(course, s.own.yaw),
          .note = why};
}

}  // namespace

Command Pledge::decide(const Situation& s, Memory& memory, Context& context) const noexcept {
  if (s.link == nullptr)
    return {.mode = Mode::infeasible, .note = "pledge hears nobody: it needs an exchange"};
  const std::size_t self = number(s.own.id);
  if (self >= static_cast<std::size_t>(params.team_count))
    return {.mode = Mode::infeasible, .note = "its id is beyond those of the group (team_count)"};
  Agreement& agreement = memory.agreement;
  if (!memory.begun) {
    if (s.own.velocity.norm() > at_rest) memory.moved = s.time;
    if (s.time < memory.moved + settling) return {.mode = Mode::hold, .note = "comes to rest"};
    agreement = Agreement{self,
                          {.count = static_cast<std::size_t>(params.team_count),
                           .datum = {params.datum_north_m, params.datum_east_m},
                           .tubes = {.radius = params.tube_m, .told = 0.1}}};
    const Member member = member_of(s, params.speed_ratio);
    if (!pledge::fits(member, {params.datum_north_m, params.datum_east_m}))
      return {.mode = Mode::infeasible, .note = "it is too far from the datum for its words"};
    agreement.hold(member);
    memory.begun = true;
  }
  memory.time = s.time;
  memory.turn_period = s.link->turn_period;
  for (const Heard& heard : s.link->heard) agreement.hear(heard.speech, s.time);
  if (s.attendance == Attendance::arrived && agreement.status() != pledge::Status::arrived) {
    const Reference* gone = agreement.way();
    agreement.arrive(gone != nullptr ? gone->knots().back().position : s.own.position);
  }
  if (s.attendance == Attendance::ready || s.attendance == Attendance::under_way)
    agreement.go_on(s.time, s.period, *s.link,
                    s.attendance == Attendance::ready ? params.patience_count : 0.0);

  const Reference* way = agreement.way();
  if (way == nullptr) return held(s, agreement.member(self).anchor, agreement.reason(s.time));
  if (context.sketch != nullptr) {
    std::array<Vec3, Reference::most_knots> points;
    std::size_t count = 0;
    for (const pledge::Knot& knot : way->knots()) points[count++] = knot.position;
    context.sketch->path(std::span{points}.first(count), "promised way");
    context.sketch->sphere(way->at(s.time), params.tube_m, "tube");
  }
  const Vec3 off = way->at(s.time) - s.own.position;
  const Vec3 velocity = way->velocity(s.time + look_ahead) + params.gain_hz * off;
  // while the reference turns on the spot, so does the vehicle
  const bool goes = horizontal_norm(way->velocity(s.time + look_ahead)) > 0.02;
  const std::optional<double> course =
      goes ? std::optional{math::atan2(velocity.y(), velocity.x())} : next_course(*way, s.time);
  Command command{.velocity = along_heading(clamp_norm(velocity, s.limits.max_speed), s.own.yaw),
                  .mode = Mode::avoid,
                  .turn_rate = turn_rate_to(course, s.own.yaw)};
  if (off.norm() > params.tube_m) {
    command.mode = Mode::infeasible;
    command.note = "is farther from its promised place than its tube";
  }
  return command;
}

Speech Pledge::speech(const Memory& memory) const noexcept {
  return memory.begun ? memory.agreement.say(memory.time, memory.turn_period) : Speech{};
}

}  // namespace fairway
