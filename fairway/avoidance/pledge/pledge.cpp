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

/// The command that keeps to the reference.
Command followed(const Situation& s, const Reference& way, const Pledge::Params& params) noexcept {
  const Vec3 off = way.at(s.time) - s.own.position;
  const Vec3 ahead = way.velocity(s.time + look_ahead);
  const Vec3 velocity = ahead + params.gain_hz * off;
  // while the reference turns on the spot, so does the vehicle
  const std::optional<double> course = horizontal_norm(ahead) > 0.02
                                           ? std::optional{math::atan2(velocity.y(), velocity.x())}
                                           : next_course(way, s.time);
  const bool keeps_tube = off.norm() <= params.tube_m;
  return {.velocity = along_heading(clamp_norm(velocity, s.limits.max_speed), s.own.yaw),
          .mode = keeps_tube ? Mode::avoid : Mode::infeasible,
          .turn_rate = turn_rate_to(course, s.own.yaw),
          .note = keeps_tube ? "" : "is farther from its promised place than its tube"};
}

void draw(const Reference& way, double time, double tube, Sketch& sketch) noexcept {
  std::array<Vec3, Reference::most_knots> points;
  std::size_t count = 0;
  for (const pledge::Knot& knot : way.knots()) points[count++] = knot.position;
  sketch.path(std::span{points}.first(count), "promised way");
  sketch.sphere(way.at(time), tube, "tube");
}

}  // namespace

Command Pledge::decide(const Situation& s, Memory& memory, Context& context) const noexcept {
  const auto refused = [](std::string_view why) { return Command{.mode = Mode::infeasible, .note = why}; };
  if (s.link == nullptr) return refused("pledge hears nobody: it needs an exchange");
  if (number(s.own.id) >= static_cast<std::uint32_t>(params.team_count))
    return refused("its id is beyond those of the group (team_count)");
  if (!memory.begun) {
    if (s.own.velocity.norm() > at_rest) memory.moved = s.time;
    if (s.time < memory.moved + settling) return {.mode = Mode::hold, .note = "comes to rest"};
    if (!begin(s, memory)) return refused("it is too far from the datum for its words");
  }
  take_part(s, memory);
  const Agreement& agreement = memory.agreement;
  const Reference* way = agreement.way();
  if (way == nullptr) return held(s, agreement.member(number(s.own.id)).anchor, agreement.reason(s.time));
  if (context.sketch != nullptr) draw(*way, s.time, params.tube_m, *context.sketch);
  return followed(s, *way, params);
}

/// Enters the group where it lies. False if that is too far away to be told.
bool Pledge::begin(const Situation& s, Memory& memory) const noexcept {
  const Vec2 datum{params.datum_north_m, params.datum_east_m};
  const Member member = member_of(s, params.speed_ratio);
  if (!pledge::fits(member, datum)) return false;
  memory.agreement = Agreement{number(s.own.id),
                               {.count = static_cast<std::size_t>(params.team_count),
                                .datum = datum,
                                .tubes = {.radius = params.tube_m, .told = 0.1}}};
  memory.agreement.hold(member);
  return memory.begun = true;
}

/// Hears what has come in, and goes on with the agreement as far as its mission lets it.
void Pledge::take_part(const Situation& s, Memory& memory) const noexcept {
  Agreement& agreement = memory.agreement;
  memory.time = s.time;
  memory.turn_period = s.link->turn_period;
  for (const Heard& heard : s.link->heard) agreement.hear(heard.speech, s.time);
  if (s.attendance == Attendance::arrived && agreement.status() != pledge::Status::arrived) {
    const Reference* gone = agreement.way();
    agreement.arrive(gone != nullptr ? gone->knots().back().position : s.own.position);
  }
  // where the clock has not begun there is time
  if (s.attendance == Attendance::ready) agreement.go_on(s.time, s.period, *s.link, params.patience_count);
  if (s.attendance == Attendance::under_way) agreement.go_on(s.time, s.period, *s.link, 0.0);
}

Speech Pledge::speech(const Memory& memory) const noexcept {
  return memory.begun ? memory.agreement.say(memory.time, memory.turn_period) : Speech{};
}

}  // namespace fairway
