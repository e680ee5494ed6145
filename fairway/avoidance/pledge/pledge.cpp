// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/pledge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fairway/avoidance/orca3d/orca3d.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

using pledge::Agreement;
using pledge::Member;
using pledge::Reference;

constexpr double look_ahead = 2.0;    // of the reference's velocity, for the vehicle's lag and slip [s]
constexpr double stopping = 2.0;      // from a member's speed, with its lag [s]
constexpr double soon = 8.0;          // within it nobody who is lost may come near a promised way [s]
constexpr double threatened = 12.0;   // likewise a member that is held [s]
constexpr int most_losses = 1;        // after which a member that is lost again is so for good
constexpr double at_rest = 0.05;      // slower than this a member is held [m/s]
constexpr double settling = 4.0;      // for so long, since it may be on its way back [s]
constexpr double return_gain = 0.3;   // to its anchor [1/s]
constexpr double still = 0.075;       // who would go slower than this through the water does not turn [m/s]
constexpr int longest_wait = 20;      // of a member for its turn [s]
constexpr double turn_gain = 0.5;     // [1/s]
constexpr double fastest_turn = 0.8;  // [rad/s]

/// How it goes with all of it at once within its greatest speed: what is left of that beside climbing. That
/// is a speed over ground; a hull that reaches no more by itself has what the current leaves of it.
Member member_of(const Situation& s, double speed_ratio) noexcept {
  const double all = speed_ratio * std::min(s.goal.cruise_speed, s.limits.max_speed);
  const bool is_known = s.envelope != nullptr;
  const double up = std::min(is_known ? speed_ratio * s.envelope->up : all, s.limits.max_climb_rate);
  const double down = std::min(is_known ? speed_ratio * s.envelope->down : all, s.limits.max_climb_rate);
  const double vertical = s.goal.position.z() > s.own.position.z() ? down : up;
  const bool is_at_its_most = is_known && s.envelope->ahead < 0.98 * s.limits.max_speed;
  const double ahead = !is_known ? all
                       : is_at_its_most
                           ? math::fmin(speed_ratio * s.envelope->ahead - horizontal_norm(s.current), all)
                           : math::fmin(speed_ratio * s.envelope->ahead, all);
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

bool is_in_current(const Situation& s) noexcept { return horizontal_norm(s.current) > 0.02; }

/// The course through the water that makes a velocity over ground. A hull takes up what sets it aside only
/// slowly, so abeam what counts is how it drifts, not how the water does.
double course_of(const Situation& s, const Vec3& over_ground) noexcept {
  Vec2 w = over_ground.head<2>() - s.current.head<2>();
  const Vec2 abeam = starboard_of(unit_at(s.own.yaw));
  w -= (s.own.velocity - s.current).head<2>().dot(abeam) * abeam;
  return math::atan2(w.y(), w.x());
}

/// What of a velocity the vehicle may and can go, the vertical part of it first.
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

/// The course on which the reference will go next, once it is time to turn to it. In a current that is no
/// sooner than it has to be, since nobody who has turned aside stays where it is.
std::optional<double> next_course(const Situation& s, const Reference& way, double turn) noexcept {
  for (int ahead = 0; ahead <= longest_wait; ++ahead) {
    const Vec3 v = way.velocity(s.time + ahead);
    if (horizontal_norm(v) <= 0.02) continue;
    const double course = course_of(s, v);
    const double takes = turn * (0.3 + 0.7 * std::fabs(wrap_angle(course - s.own.yaw)) / std::numbers::pi);
    return is_in_current(s) && ahead > takes ? std::nullopt : std::optional{course};
  }
  return {};
}

/// Goes `wanted` over ground by surge, heave and turn rate of its own, whatever the steering of its scenario:
/// ahead through the water, on the course that makes good what the current sets it aside. `course` goes
/// before that; who neither has one nor is to go through the water keeps its heading.
Command driven(const Situation& s, const Vec3& wanted, std::optional<double> course, Mode mode,
               std::string_view note) noexcept {
  const Vec2 ahead = unit_at(s.own.yaw), current = s.current.head<2>();
  const double through = math::fmax((wanted.head<2>() - current).dot(ahead), 0.0);
  const Vec2 made = (through + current.dot(ahead)) * ahead;
  if (!course && horizontal_norm(wanted - s.current) > still) course = course_of(s, wanted);
  const double turn_rate =
      course ? std::clamp(turn_gain * wrap_angle(*course - s.own.yaw), -fastest_turn, fastest_turn) : 0.0;
  return {.velocity = {made.x(), made.y(), wanted.z()}, .mode = mode, .turn_rate = turn_rate, .note = note};
}

/// Back to the anchor, ahead: who only stops where it is drifts sideways for long. In a current it lies with
/// its bow against it. On `course`, if there is one.
Command held(const Situation& s, const Vec3& anchor, std::string_view why,
             std::optional<double> course = {}) noexcept {
  return driven(s, clamp_norm(return_gain * (anchor - s.own.position), 0.3), course, Mode::hold, why);
}

/// The course on which a member that is held will depart, once it is time to turn to it: who departs while it
/// turns the other way is late. Not in a current, in which nobody who has turned aside stays where it is.
std::optional<double> first_course(const Situation& s, const Agreement& agreement) noexcept {
  const double turn = agreement.member(number(s.own.id)).turn;
  if (is_in_current(s) || agreement.plan().start - s.time > turn + settling) return {};
  const Reference way = agreement.promised(s.time);
  return way.empty() ? std::nullopt : next_course(s, way, turn);
}

/// The command that keeps to the reference of a member that takes so long to turn.
Command followed(const Situation& s, const Reference& way, double turn,
                 const Pledge::Params& params) noexcept {
  const Vec3 off = way.at(s.time) - s.own.position;
  const Vec3 ahead = way.velocity(s.time + look_ahead);
  const Vec3 velocity = within_limits(s, ahead + params.gain_hz * off);
  // while the reference turns on the spot, so does the vehicle
  const auto course = horizontal_norm(ahead) > 0.02 ? std::nullopt : next_course(s, way, turn);
  const bool keeps_tube = off.norm() <= params.tube_m;
  return driven(s, velocity, course, keeps_tube ? Mode::avoid : Mode::infeasible,
                keeps_tube ? "" : "is farther from its promised place than its tube");
}

/// Out of the way of who is lost: by ORCA among all whose whereabouts are known.
Command evaded(const Situation& s, const Agreement& agreement, const Vec3& stay, Context& context) noexcept {
  std::array<Track, pledge::most_members> tracks;
  std::size_t count = 0;
  for (std::size_t i = 0; i < pledge::most_members; ++i) {
    const Reference way = i == number(s.own.id) ? Reference{} : agreement.whereabouts(i);
    if (way.empty()) continue;
    tracks[count++] = {.id = TrackId{static_cast<std::uint32_t>(i)},
                       .position = way.at(s.time),
                       .velocity = way.velocity(s.time),
                       .radius = agreement.member(i).radius,
                       .reacts = !agreement.is_lost(i)};
  }
  const auto distance = [&](const Track& track) { return (track.position - s.own.position).squaredNorm(); };
  std::ranges::sort(std::span{tracks}.first(count), {}, distance);
  Situation shown = s;
  shown.goal = {.position = stay, .cruise_speed = s.goal.cruise_speed};
  shown.tracks = std::span{tracks}.first(count);
  NoMemory none;
  const Command way_out = Orca3d{{.time_horizon_s = threatened}}.decide(shown, none, context);
  return driven(s, way_out.velocity, {}, s.attendance == Attendance::under_way ? Mode::avoid : Mode::hold,
                "goes out of the way of a member that is lost");
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
    if (s.time < memory.moved + settling) return held(s, s.own.position, "comes to rest");
    if (!begin(s, memory)) return refused("it is too far from the datum for its words");
  }
  take_part(s, memory);
  watch(s, memory);
  const Agreement& agreement = memory.agreement;
  const Reference* way = agreement.way();
  if (way == nullptr) {
    const bool is_lost = agreement.status() == pledge::Status::lost;
    const Vec3 stay = is_lost ? memory.stay : agreement.member(number(s.own.id)).anchor;
    if (memory.gives_way) return evaded(s, agreement, stay, context);
    return held(s, stay, agreement.reason(s.time), is_lost ? std::nullopt : first_course(s, agreement));
  }
  if (context.sketch != nullptr) draw(*way, s.time, params.tube_m, *context.sketch);
  return followed(s, *way, agreement.member(number(s.own.id)).turn, params);
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
  for (const Heard& heard : s.link->heard) {
    if (number(heard.from) >= memory.heard.size()) continue;
    std::optional<double>& last = memory.heard[number(heard.from)];
    const bool is_new = !last || heard.sent > *last;
    if (is_new && agreement.hear(heard.speech, s.time)) last = heard.sent;
  }
  if (s.attendance == Attendance::arrived && agreement.status() != pledge::Status::arrived &&
      agreement.status() != pledge::Status::lost) {
    const Reference* gone = agreement.way();
    agreement.arrive(gone != nullptr ? gone->knots().back().position : s.own.position);
  }
  // where the clock has not begun there is time
  if (s.attendance == Attendance::ready) agreement.go_on(s.time, s.period, *s.link, params.patience_count);
  if (s.attendance == Attendance::under_way) agreement.go_on(s.time, s.period, *s.link, 0.0);
}

/// Who is off its tube by as much again is lost; before that it is best to come back. Who
/// would come near somebody who is lost, or is held beside its promised way, stops where it is and is held
/// there; who is held where somebody comes who is lost goes out of the way, and tells where it is by then.
void Pledge::watch(const Situation& s, Memory& memory) const noexcept {
  Agreement& agreement = memory.agreement;
  if (agreement.status() == pledge::Status::lost) return recover(s, memory);
  const Reference* way = agreement.way();
  if (way == nullptr) {
    memory.gives_way = agreement.meets_lost(Reference{s.own.position}, s.time, s.time + threatened);
    const Vec3 anchor = agreement.member(number(s.own.id)).anchor;
    const bool has_gone = memory.gives_way && (anchor - s.own.position).norm() > 0.5 * params.tube_m;
    if (has_gone) stay_at(s, s.own.position, agreement);
    return;
  }
  memory.gives_way = false;
  const double off = (way->at(s.time) - s.own.position).norm();
  if (off > 2.0 * params.tube_m) {
    ++memory.losses;
    memory.moved = s.time;
    memory.stay = s.own.position;
    agreement.lose(s.own.position, s.own.velocity);
  } else if (agreement.meets_lost(*way, s.time, s.time + soon) ||
             agreement.meets_held(*way, s.time, s.time + soon)) {
    stay_at(s, s.own.position + stopping * s.own.velocity, agreement);
  }
}

/// Held at a place from now on, whatever was promised.
void Pledge::stay_at(const Situation& s, const Vec3& place, Agreement& agreement) const noexcept {
  if (s.attendance == Attendance::arrived) return agreement.arrive(place);
  Member member = member_of(s, params.speed_ratio);
  member.anchor = place;
  agreement.hold(member);
}

/// Who was lost is held again once it has come to rest, but not for ever again.
void Pledge::recover(const Situation& s, Memory& memory) const noexcept {
  Agreement& agreement = memory.agreement;
  if (s.own.velocity.norm() > at_rest) memory.moved = s.time;
  if (memory.losses > most_losses || s.time < memory.moved + settling)
    return agreement.lose(s.own.position, s.own.velocity);
  stay_at(s, s.own.position, agreement);
}

Speech Pledge::speech(const Memory& memory) const noexcept {
  return memory.begun ? memory.agreement.say(memory.time, memory.turn_period) : Speech{};
}

}  // namespace fairway
