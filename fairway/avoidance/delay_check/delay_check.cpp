// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/delay_check/delay_check.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fairway/avoidance/pledge/bits.hpp"
#include "fairway/avoidance/pledge/following.hpp"
#include "fairway/avoidance/pledge/reading.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

using delay_check::Trajectory;
using pledge::Member;
using pledge::Reference;

constexpr double listening = 2.0;       // turns, before it plans for the first time
constexpr double last_decisions = 1.5;  // before a turn in which it plans
constexpr double rounded = 0.1;         // of what is told, for a pair [m]
constexpr double most_late = 2.0;       // who looks at its clock so long after has missed a commitment [s]
constexpr double least_gain = 0.5;      // of a leg, towards the goal [m]
constexpr double surely = 0.8;          // a leg ends so much within the arrival [m]
constexpr double longest_told = 0.5 * pledge::clock_period - 5.0;  // times farther off are read as past [s]
constexpr double bend = 0.5;  // more than this it turns on the spot only [rad]

constexpr std::array lengths{1.0, 0.5, 0.25};  // of the way to the goal
constexpr std::array bearings_deg{0.0, 25.0, -25.0, 50.0, -50.0, 75.0, -75.0, 100.0, -100.0};
constexpr std::array climbs{1.0, 0.0, 2.0};  // of what belongs to the length

/// How long a straight leg takes [s].
double duration(const Vec3& leg, const Member& m) {
  const double vertical = std::fabs(leg.z()) / math::fmax(leg.z() > 0.0 ? m.descent : m.climb, 0.01);
  return math::fmax(horizontal_norm(leg) / math::fmax(m.speed, 0.01), vertical);
}

/// A leg in the direction of the goal, shorter, turned aside, and climbing otherwise.
Vec3 leg_of(const Vec3& to_goal, double length, double bearing_deg, double climb) {
  const double angle = bearing_deg * std::numbers::pi / 180.0, c = math::cos(angle), s = math::sin(angle);
  const double down = math::fmin(length * climb, 1.0) * to_goal.z();
  return {length * (c * to_goal.x() - s * to_goal.y()), length * (s * to_goal.x() + c * to_goal.y()), down};
}

/// The angle between two legs, as seen from above [rad].
double bend_between(const Vec3& a, const Vec3& b) {
  const Vec2 p = a.head<2>(), q = b.head<2>();
  return std::fabs(math::atan2(cross(p, q), p.dot(q)));
}

}  // namespace

bool DelayCheck::begin(const Situation& s, Memory& memory) const noexcept {
  const Vec3 place = pledge::resting_place(s);
  memory.own = delay_check::as_told(
      {.radius = s.own.radius, .committed = Trajectory::standing(place, s.time)}, datum(), s.time);
  memory.began = s.time;
  memory.turn = pledge::member_of(s, params.speed_ratio).turn;
  const bool is_told_whole = memory.own.radius > s.own.radius - 1e-6;
  return memory.begun = is_told_whole && (memory.own.committed.to - place).norm() < 0.05;
}

void DelayCheck::hear(const Situation& s, Memory& memory) const noexcept {
  for (const Heard& heard : s.link->heard) {
    const auto known = std::span{memory.others}.first(memory.count);
    const auto at = std::ranges::find(known, heard.from, &Other::id);
    if (at != known.end() && heard.sent <= at->sent) continue;
    const auto word = delay_check::decode(heard.speech, datum(), heard.sent);
    if (!word) continue;
    if (at == known.end() && memory.count == most_others) {
      memory.is_crowded = true;
      continue;
    }
    Other& other = at != known.end() ? *at : memory.others[memory.count++];
    other = {.id = heard.from, .sent = heard.sent, .word = *word};
  }
}

/// Of all that is known: what the others have committed to, and what they may commit to next.
bool DelayCheck::is_clear(const Memory& memory, const Trajectory& own, double from) const noexcept {
  const Reference way = own.reference();
  for (const Other& other : std::span{memory.others}.first(memory.count)) {
    const double apart = memory.own.radius + other.word.radius + 2.0 * params.tube_m + rounded;
    const auto meets = [&](const Trajectory& there, double begins) {
      return least_distance(way, there.reference(), begins, pledge::never, apart) < apart;
    };
    const std::optional<Trajectory>& next = other.word.next;
    if (meets(other.word.committed, from)) return false;
    if (next && meets(*next, math::fmax(from, next->departs))) return false;
  }
  return true;
}

/// The delay check: what comes next is given up for any conflict, and committed to when its time has come.
void DelayCheck::check(const Situation& s, Memory& memory) const noexcept {
  std::optional<Trajectory>& next = memory.own.next;
  if (!next) return;
  if (s.time > memory.commits + most_late || !is_clear(memory, *next, next->departs)) {
    next.reset();
  } else if (s.time >= memory.commits) {
    memory.own.committed = *next;
    next.reset();
  }
}

/// Where all speak at once they plan one after the other, since of two who plan at once both would give up.
bool DelayCheck::is_first_to_plan(const Situation& s, const Memory& memory) const noexcept {
  if (s.link->turn_period > 1.5 * s.period) return true;
  const auto heard = std::span{memory.others}.first(memory.count);
  const auto before = std::ranges::count_if(heard, [&](const Other& other) { return other.id < s.own.id; });
  const auto turn = static_cast<std::size_t>(std::llround(s.time / s.period));
  return turn % (memory.count + 1) == static_cast<std::size_t>(before);
}

/// Right before its turn it looks for the leg that brings it to its goal soonest.
void DelayCheck::plan(const Situation& s, Memory& memory) const noexcept {
  const Trajectory& committed = memory.own.committed;
  const bool is_due = s.link->next_turn - s.time <= last_decisions * s.period &&
                      s.time >= memory.began + listening * s.link->turn_period;
  const double ends_off = (s.goal.position - committed.to).norm() - s.goal.arrival;
  if (memory.own.next || !is_due || memory.is_crowded || ends_off <= 0.0 || !is_first_to_plan(s, memory))
    return;

  memory.commits = s.link->next_turn + params.delay_turns_count * s.link->turn_period;
  const bool stands = committed.ends <= memory.commits;
  const double departs = memory.commits + (stands ? memory.turn : 0.0);
  memory.own.next = soonest_leg(s, memory, departs, stands ? pledge::never : bend);
}

/// Of the legs that begin at `departs` on the committed one and are clear, whichever leads to the goal
/// soonest; none if none brings it nearer.
std::optional<Trajectory> DelayCheck::soonest_leg(const Situation& s, const Memory& memory, double departs,
                                                  double most_bend) const noexcept {
  const Trajectory& committed = memory.own.committed;
  const Vec3 place = committed.reference().at(departs);
  const Vec3 whole = s.goal.position - place;
  const double short_of = math::fmax(s.goal.arrival - surely, 0.0) / math::fmax(whole.norm(), 1e-9);
  const Vec3 to_goal = math::fmax(1.0 - short_of, 0.0) * whole;
  const Member m = pledge::member_of(s, params.speed_ratio);
  delay_check::Word word = memory.own;
  std::optional<Trajectory> best;
  double soonest = pledge::never;
  for (const double length : lengths) {
    for (const double bearing : bearings_deg) {
      for (const double climb : climbs) {
        const Vec3 leg = leg_of(to_goal, length, bearing, climb);
        if (bend_between(committed.to - committed.from, leg) > most_bend) continue;
        word.next = {
            .from = place, .to = place + leg, .departs = departs, .ends = departs + duration(leg, m)};
        if (word.next->ends > s.time + longest_told) continue;
        const Trajectory next = *delay_check::as_told(word, datum(), s.time).next;
        const Vec3 left = s.goal.position - next.to;
        const double arrives = next.ends + duration(left, m);
        const bool gains = left.norm() < (s.goal.position - committed.to).norm() - least_gain;
        if (!gains || arrives >= soonest || !is_clear(memory, next, departs)) continue;
        soonest = arrives;
        best = next;
      }
    }
  }
  return best;
}

std::string_view DelayCheck::what_it_waits_for(const Memory& memory) noexcept {
  if (memory.is_crowded) return "hears of more others than it can keep in mind";
  return memory.own.next ? "waits out its delay check" : "waits for a clear way";
}

/// Who is kept gives up what it was to do, and stands where it comes to rest.
void DelayCheck::stand(const Situation& s, Memory& memory) noexcept {
  memory.own.next.reset();
  if (s.time < memory.own.committed.ends)
    memory.own.committed = Trajectory::standing(pledge::resting_place(s), s.time);
}

Command DelayCheck::decide(const Situation& s, Memory& memory, Context& context) const noexcept {
  const auto refused = [](std::string_view why) { return Command{.mode = Mode::infeasible, .note = why}; };
  if (s.link == nullptr) return refused("delay_check hears nobody: it needs an exchange");
  if (memory.begun && s.comes_after_pause(memory.time)) memory = {};
  if (!memory.begun && !begin(s, memory))
    return refused("it is too far from the datum, or too large, for its words");
  memory.time = s.time;
  hear(s, memory);
  check(s, memory);
  if (s.attendance == Attendance::under_way) plan(s, memory);
  if (s.attendance == Attendance::kept) stand(s, memory);

  const Reference way = memory.own.committed.reference();
  if (context.sketch != nullptr) pledge::draw(way, s.time, params.tube_m, *context.sketch);
  if (s.time < way.end())
    return pledge::followed(s, way, memory.turn, {.gain = params.gain_hz, .tube = params.tube_m});
  const bool has_listened = s.time >= memory.began + listening * s.link->turn_period;
  Command command = pledge::held(s, memory.own.committed.to, what_it_waits_for(memory));
  if (s.attendance == Attendance::ready && has_listened) command.mode = Mode::avoid;
  return command;
}

Speech DelayCheck::speech(const Memory& memory) const noexcept {
  return memory.begun ? delay_check::encode(memory.own, datum(), memory.time) : Speech{};
}

Reading DelayCheck::reading(const Heard& heard) const {
  const std::optional<delay_check::Word> word = delay_check::decode(heard.speech, datum(), heard.sent);
  if (!word) return {.text = "not a word of delay_check"};
  const auto way = [](const Trajectory& t) {
    return pledge::place_words(t.to) + " from " + pledge::instant_words(t.departs) + " to " +
           pledge::instant_words(t.ends);
  };
  const Trajectory& committed = word->committed;
  std::string text = committed.ends > committed.departs ? "has committed itself to go to " + way(committed)
                                                        : "stands at " + pledge::place_words(committed.to);
  if (word->next) text += "; will go to " + way(*word->next) + " if nothing speaks against it";
  return {.text = std::move(text)};
}

}  // namespace fairway
