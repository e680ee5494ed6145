// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/pledge.hpp"

#include <algorithm>

#include "fairway/avoidance/pledge/evasion.hpp"
#include "fairway/avoidance/pledge/following.hpp"
#include "fairway/avoidance/pledge/making_room.hpp"
#include "fairway/avoidance/pledge/reading.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

using pledge::Agreement;
using pledge::driven;
using pledge::held;
using pledge::Member;
using pledge::Reference;
using pledge::resting_place;

constexpr double soon = 8.0;           // within it nobody who is lost may come near a promised way [s]
constexpr double threatened = 12.0;    // likewise a member that is held [s]
constexpr double cleared = 30.0;       // nor, once that is out of its way [s]
constexpr int most_losses = 1;         // after which a member that is lost again is so for good
constexpr double aside_within = 0.5;   // of a place to which a member goes aside it comes [m]
constexpr int patient_rounds = 2;      // without a plan, before a member goes aside
constexpr double at_rest = 0.05;       // slower than this a member is held [m/s]
constexpr double waves = 4.0;          // over so long they go to and fro [s]
constexpr double settling = 4.0;       // for so long, before it departs, a member turns to its course [s]
constexpr double resting = 12.0;       // at rest for so long, who was lost is held again [s]
constexpr double shortest_turn = 4.0;  // however often words come: to hear, decide and be heard [decisions]
constexpr double same_place = 0.2;     // as near to each other two destinations are one [m]

/// The course on which a member that is held will go, once it is time to turn to it.
std::optional<double> first_course(const Situation& s, const Agreement& agreement) noexcept {
  const Member& own = agreement.own();
  const double soon_enough = s.time + own.turn + settling;
  if (agreement.plan().start() > soon_enough) return {};
  const Reference way = agreement.promised(s.time);
  if (way.empty() || way.knots().front().time > soon_enough) return {};
  const double goes = way.knots().front().time + pledge::turns_for(own) + s.period;
  const std::optional<double> course = pledge::course_at(s, way, goes);
  return course ? course : pledge::next_course(s, way, own.turn);
}

/// What of own anchor or destination lies too near to what stands; empty if nothing does.
std::string_view hemmed_in(const Situation& s, const Member& member, double berth) noexcept {
  for (const Obstacle& obstacle : s.obstacles) {
    if (nearest_point(obstacle, member.anchor).distance < berth)
      return "lies nearer to an obstacle than its sphere and its tube";
    const double off = nearest_point(obstacle, member.destination).distance;
    if (off + pledge::ends_before(member) < berth)
      return "has no way: its destination is nearer to an obstacle than its sphere and its tube";
  }
  return {};
}

/// Out of the way of all whose whereabouts are known, none of whom is counted on to know own ship's.
Command evaded(const Situation& s, const Agreement& agreement, const Vec3& stay) noexcept {
  pledge::Evasion evasion{s, agreement.own().turn};
  const double beside = s.own.radius + agreement.terms().tubes.radius + agreement.terms().tubes.told;
  for (std::size_t i = 0; i < agreement.count(); ++i) {
    const Reference way = i == agreement.self() ? Reference{} : agreement.whereabouts(i);
    if (!way.empty()) evasion.avoid(way, agreement.evades_by(i, s.time));
  }
  for (const pledge::Bystander& other : agreement.others().bystanders())
    if (other.known) evasion.avoid(Reference{other.place}, beside + other.radius);
  for (const pledge::Passing& other : agreement.others().passing())
    evasion.avoid(other.way, beside + other.radius);
  constexpr std::string_view why = "goes out of the way of a member that is lost, or cannot know of it";
  const std::optional<Vec3> velocity = evasion.best();
  if (!velocity) return held(s, stay, why);
  return driven(s, *velocity, {}, s.attendance == Attendance::under_way ? Mode::avoid : Mode::hold, why);
}

/// Of somebody who is lost, or, where it has stopped beside a plan, of who goes by that and may not have
/// heard of it.
bool is_in_the_way(const Situation& s, const Pledge::Memory& memory) noexcept {
  const Reference here{resting_place(s)};
  const double until = s.time + (memory.gives_way ? cleared : threatened);
  return memory.agreement.meets_lost(here, s.time, until) ||
         (memory.is_beside && memory.agreement.meets_moving(here, s.time, until));
}

}  // namespace

Command Pledge::decide(const Situation& given, Memory& memory, Context& context) const noexcept {
  const double unsure = pledge::beyond_tube(given.own, params.tube_m);
  Situation s = given;
  s.own.radius += unsure;
  if (s.link == nullptr) return refused(s, "pledge hears nobody: it needs an exchange", memory);
  if (number(s.own.id) >= static_cast<std::uint32_t>(params.team_count))
    return refused(s, "its id is beyond those of the group (team_count)", memory);
  if (!memory.begun) {
    const std::string_view misfit = begin(s, memory);
    if (!misfit.empty()) return refused(s, misfit, memory);
  }
  const std::string_view unheard = hear(s, memory);
  const bool alone = memory.agreement.rounds().groups().count() == 1;
  std::array<Obstacle, pledge::most_vehicles> room;
  const pledge::Chart chart = alone ? s.obstacles : memory.agreement.chart(s.obstacles, room);
  memory.obedience.look(s);
  Command command = decided(s, chart, memory, context);
  memory.obedience.ask(s, command);
  memory.datum.look(memory.agreement, s.link->ranges, rests(s, memory), unsure);
  if (!unheard.empty()) command.note = unheard;
  if (!memory.misfit.empty()) command.note = memory.misfit;
  if (memory.datum.doubted().any())
    command.note = "measures a distance that does not fit: it or another is not where it says";
  return command;
}

/// Who cannot take part keeps the place at which that was found, or, if it cannot stop, comes back to it
/// again and again.
Command Pledge::refused(const Situation& s, std::string_view why, Memory& memory) const noexcept {
  if (s.attendance != Attendance::under_way || !memory.refused_at) memory.refused_at = s.own.position;
  Command command = held(s, *memory.refused_at, why);
  command.mode = Mode::infeasible;
  return command;
}

Command Pledge::decided(const Situation& s, const pledge::Chart& chart, Memory& memory,
                        Context& context) const noexcept {
  take_part(s, chart, memory);
  watch(s, chart, memory);
  const Reference* way = memory.agreement.way();
  if (way == nullptr) return stayed(s, memory);
  if (context.sketch != nullptr) pledge::draw(*way, s.time, params.tube_m, *context.sketch);
  return pledge::followed(s, *way, memory.agreement.own().turn,
                          {.gain = params.gain_hz, .tube = params.tube_m, .stops = memory.agreement.stops()});
}

/// Where it is held, or out of the way of who is lost.
Command Pledge::stayed(const Situation& s, const Memory& memory) const noexcept {
  const Agreement& agreement = memory.agreement;
  const bool is_lost = agreement.status() == pledge::Status::lost;
  const Member& own = agreement.own();
  const Vec3 stay = is_lost ? memory.stay : own.anchor;
  if (memory.gives_way) return evaded(s, agreement, stay);
  const bool waits = agreement.status() == pledge::Status::held;
  const std::string_view hemmed = waits ? hemmed_in(s, own, pledge::berth(own, tubes())) : std::string_view{};
  return held(s, stay, hemmed.empty() ? agreement.reason(s.time) : hemmed,
              is_lost ? std::nullopt : first_course(s, agreement));
}

/// Enters the group where it will come to rest. Why it cannot, if that is so.
std::string_view Pledge::begin(const Situation& s, Memory& memory) const noexcept {
  const Vec2 datum{params.datum_north_m, params.datum_east_m};
  const Member member = pledge::member_of(s, params.speed_ratio, resting_place(s), s.goal.position);
  const std::string_view misfit = pledge::misfit_of(member, datum);
  if (!misfit.empty()) return misfit;
  memory.agreement =
      Agreement{number(s.own.id),
                {.count = static_cast<std::size_t>(params.team_count), .datum = datum, .tubes = tubes()}};
  memory.agreement.hold(member);
  memory.begun = true;
  return {};
}

/// Why somebody's last word could not be taken, if that is so.
std::string_view Pledge::hear(const Situation& s, Memory& memory) const noexcept {
  std::string_view unheard;
  memory.time = s.time;
  memory.turn_period = math::fmax(s.link->turn_period, shortest_turn * s.period);
  for (const Heard& heard : s.link->heard) {
    if (number(heard.from) >= memory.heard.size()) continue;
    std::optional<double>& last = memory.heard[number(heard.from)];
    if (last && heard.sent <= *last) continue;
    switch (memory.agreement.hear(heard.speech, heard.sent, s.time)) {
      case pledge::Hearing::taken:
        last = heard.sent;
        break;
      case pledge::Hearing::early:
        unheard = "hears a word that is yet to be said: its clock, or another's, is wrong";
        break;
      case pledge::Hearing::unreadable:
        unheard = "cannot read a word: it is damaged, of another version, or of another method";
        break;
    }
  }
  return unheard;
}

/// Goes on with the agreement as far as its mission lets it.
void Pledge::take_part(const Situation& s, const pledge::Chart& chart, Memory& memory) const noexcept {
  Agreement& agreement = memory.agreement;
  if (s.attendance == Attendance::arrived && agreement.status() != pledge::Status::arrived &&
      agreement.status() != pledge::Status::lost) {
    const Reference* gone = agreement.way();
    agreement.arrive(gone != nullptr ? gone->knots().back().position : s.own.position);
  }
  if (s.attendance == Attendance::kept) keep(s, agreement);
  // where the clock has not begun there is time
  const double patience = s.attendance == Attendance::ready ? params.patience_count : 0.0;
  // who measures that somebody is not where it says does not set out among them
  const bool is_wary = agreement.status() == pledge::Status::held && memory.datum.doubted().any();
  const bool goes_on = s.attendance == Attendance::ready || s.attendance == Attendance::under_way;
  const bool is_free = !is_wary && (goes_on || s.attendance == Attendance::kept);
  if (goes_on) retarget(s, memory);
  if (is_free) {
    aim(s, chart, memory);
    Link link = *s.link;
    link.turn_period = memory.turn_period;
    agreement.go_on(s.time, s.period, link, patience, chart, pledge::headway_in(s.current, params.headway_s));
  }
  agreement.take_turns(s.time, s.period, memory.turn_period, is_free && !memory.waits, rests(s, memory));
}

/// Whether it is where it says, if it is held.
bool Pledge::rests(const Situation& s, const Memory& memory) const noexcept {
  return (memory.agreement.own().anchor - s.own.position).norm() <= params.tube_m;
}

/// Whose goal is another than it has told tells that: from where it is held, or once it has come to the end
/// of what it has promised. Where there are several groups, `aim` does it for who is held, and who goes aside
/// does so first.
void Pledge::retarget(const Situation& s, Memory& memory) const noexcept {
  Agreement& agreement = memory.agreement;
  const pledge::Status status = agreement.status();
  memory.misfit = {};
  if ((agreement.own().destination - s.goal.position).norm() <= same_place || status == pledge::Status::lost)
    return;
  const Reference* way = agreement.way();
  const Vec3 anchor = way != nullptr ? way->knots().back().position : agreement.own().anchor;
  const Member member = pledge::member_of(s, params.speed_ratio, anchor, s.goal.position);
  memory.misfit = pledge::misfit_of(member, agreement.terms().datum);
  const bool is_for_aim =
      agreement.rounds().groups().count() > 1 && (status == pledge::Status::held || agreement.is_aside());
  const bool has_come = way == nullptr || s.time >= way->end();
  if (memory.misfit.empty() && has_come && !is_for_aim) agreement.hold(member);
}

/// Who is kept has nowhere to go, and stops where it is if it was on its way. So it goes on hearing the
/// others, and no plan of theirs waits for it.
void Pledge::keep(const Situation& s, Agreement& agreement) const noexcept {
  if (agreement.status() != pledge::Status::held && agreement.status() != pledge::Status::moving) return;
  const Vec3 place = agreement.way() != nullptr ? resting_place(s) : agreement.own().anchor;
  const Member member = pledge::member_of(s, params.speed_ratio, place, place);
  if (agreement.way() != nullptr || (agreement.own().destination - place).norm() > same_place)
    agreement.hold(member);
}

/// Where there are several groups it says once a round of its own where it is to go in that.
void Pledge::aim(const Situation& s, const pledge::Chart& chart, Memory& memory) const noexcept {
  Agreement& agreement = memory.agreement;
  const pledge::Rounds& rounds = agreement.rounds();
  const bool can_choose = rounds.groups().count() > 1 && agreement.others().may_depart() &&
                          rounds.round() > memory.aimed_round && agreement.status() == pledge::Status::held &&
                          memory.misfit.empty();
  if (!can_choose) return;
  memory.aimed_round = rounds.round();
  const Vec3& anchor = agreement.own().anchor;
  if ((anchor - memory.aimed_from).norm() >= 1.0)
    memory.idle_rounds = 0;
  else if (chart.passing().empty())  // who is on its way may be all that was in its own
    ++memory.idle_rounds;
  memory.aimed_from = anchor;
  // not all who are stuck at once
  const auto own_round = static_cast<std::size_t>(rounds.round()) / rounds.groups().count();
  const bool is_stuck = memory.idle_rounds >= patient_rounds && (own_round + agreement.self()) % 2 == 0;
  const auto stuck = is_stuck ? std::optional{memory.asides++} : std::nullopt;
  const pledge::Aim aim = pledge::aim_of(agreement, s.goal.position, chart, s.limits, stuck);
  memory.waits = aim.kind == pledge::Aim::Kind::none;
  const bool aside = aim.kind == pledge::Aim::Kind::aside;
  Member member = pledge::member_of(s, params.speed_ratio, anchor, aside ? aim.place : s.goal.position);
  if (aside) member.arrival = aside_within;
  const Vec3 told = agreement.own().destination;
  if ((told - member.destination).norm() > same_place) agreement.hold(member, aside);
}

/// Who is off its tube by as much again is lost, and by half of its tube if its hull does not obey; before
/// that it is best to come back. Who is held and leaves its tube tells another anchor, unless it is about to
/// depart. Who would come near somebody who is lost, or is held beside its promised way, or near something
/// that it did not know to stand there, stops where it is and is held there; who is in the way of others goes
/// out of it, and tells where it is by then.
void Pledge::watch(const Situation& s, const pledge::Chart& chart, Memory& memory) const noexcept {
  Agreement& agreement = memory.agreement;
  if (agreement.status() == pledge::Status::lost) return recover(s, memory);
  const Reference* way = agreement.way();
  if (way == nullptr) {
    memory.gives_way = is_in_the_way(s, memory);
    const double off = (agreement.own().anchor - s.own.position).norm();
    if (memory.gives_way && off > 0.5 * params.tube_m) {
      stay_at(s, s.own.position, agreement);
    } else if (memory.losses > 0 && off > (agreement.has_promised(s.time) ? 2.0 : 1.0) * params.tube_m) {
      lose(s, memory);
    } else if (off > params.tube_m && !agreement.has_promised(s.time)) {
      stay_at(s, resting_place(s), agreement);
    }
    return;
  }
  memory.gives_way = memory.is_beside = false;
  const double off = (way->at(s.time) - s.own.position).norm();
  if (off > (memory.obedience.is_lacking() ? 0.5 : 2.0) * params.tube_m) {
    lose(s, memory);
  } else if (agreement.meets_lost(*way, s.time, s.time + soon) ||
             agreement.meets_held(*way, s.time, s.time + soon) ||
             !pledge::keeps_off(*way, chart, s.own.radius + params.tube_m, s.time, s.time + soon)) {
    memory.gives_way = is_in_the_way(s, memory);
    memory.is_beside = true;
    stay_at(s, resting_place(s), agreement);
  }
}

/// Held at a place from now on, whatever was promised.
void Pledge::stay_at(const Situation& s, const Vec3& place, Agreement& agreement) const noexcept {
  if (s.attendance == Attendance::arrived) return agreement.arrive(place);
  agreement.hold(pledge::member_of(s, params.speed_ratio, place, s.goal.position));
}

void Pledge::lose(const Situation& s, Memory& memory) const noexcept {
  ++memory.losses;
  memory.moved = s.time;
  memory.drift = s.own.velocity;
  memory.stay = s.own.position;
  memory.agreement.lose(s.own.position, s.own.velocity);
}

/// Who was lost is held again once it has been at rest for longer than a dead hull that a current takes along
/// is on its way from one to the other, but not for ever again. Waves may move it all the time.
void Pledge::recover(const Situation& s, Memory& memory) const noexcept {
  Agreement& agreement = memory.agreement;
  memory.drift += std::min(1.0, s.period / waves) * (s.own.velocity - memory.drift);
  if (std::min(s.own.velocity.norm(), memory.drift.norm()) > at_rest) memory.moved = s.time;
  if (memory.losses > most_losses || s.time < memory.moved + resting)
    return agreement.lose(s.own.position, s.own.velocity);
  stay_at(s, s.own.position, agreement);
}

Speech Pledge::speech(const Memory& memory) const noexcept {
  return memory.begun ? memory.agreement.say(memory.time, memory.turn_period) : Speech{};
}

Reading Pledge::reading(const Heard& word) const {
  return pledge::reading_of(word, {params.datum_north_m, params.datum_east_m},
                            {.vehicles = static_cast<std::size_t>(params.team_count)});
}

}  // namespace fairway
