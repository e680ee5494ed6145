// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/pledge.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"

namespace fairway {
namespace {

using pledge::Agreement;
using pledge::Member;
using pledge::Reference;

constexpr double look_ahead = 0.5;    // of the reference's velocity, for the vehicle's lag [s]
constexpr double half_turn_at = 0.3;  // where nothing is known of the vehicle's turning [rad/s]

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
      is_known && s.envelope->turn_rates[0] > 0.0 ? s.envelope->turn_rates[0] : half_turn_at;
  return {.anchor = s.own.position,
          .destination = s.goal.position,
          .arrival = s.goal.arrival,
          .radius = s.own.radius,
          .speed = math::fmin(ahead, beside),
          .climb = up,
          .descent = down,
          .turn = 2.2 / turn_rate};
}

/// To where the reference goes next, over ground, as a heading; nothing where it goes no more.
std::optional<double> next_heading(const Reference& way, double time) noexcept {
  for (double ahead = 0.0; ahead <= 20.0; ahead += 1.0) {
    const Vec3 v = way.velocity(time + ahead);
    if (horizontal_norm(v) > 0.02) return math::atan2(v.y(), v.x());
  }
  return {};
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
  if (s.attendance == Attendance::arrived && agreement.status() != pledge::Status::arrived)
    agreement.arrive(s.own.position);
  if (s.attendance == Attendance::ready || s.attendance == Attendance::under_way)
    agreement.go_on(s.time, s.period, *s.link, s.attendance == Attendance::ready ? params.patience_count : 0.0);

  const Reference* way = agreement.way();
  if (way == nullptr) return {.mode = Mode::hold, .note = agreement.reason(s.time)};
  if (context.sketch != nullptr) {
    std::array<Vec3, Reference::most_knots> points;
    std::size_t count = 0;
    for (const pledge::Knot& knot : way->knots()) points[count++] = knot.position;
    context.sketch->path(std::span{points}.first(count), "promised way");
    context.sketch->sphere(way->at(s.time), params.tube_m, "tube");
  }
  const Vec3 off = way->at(s.time) - s.own.position;
  const Vec3 velocity = way->velocity(s.time + look_ahead) + params.gain_hz * off;
  Command command{.velocity = clamp_norm(velocity, s.limits.max_speed), .mode = Mode::avoid};
  if (horizontal_norm(velocity) < 0.05) command.heading = next_heading(*way, s.time);
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
