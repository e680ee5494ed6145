// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/agreement.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"

namespace fairway::pledge {
namespace {

constexpr double silent_for_good = 8.0;   // turns after which, of who has gone, the way is assumed
constexpr double turning_away = 0.1;      // likewise, for each second since [m/s]
constexpr double longest_unsure = 30.0;   // up to so long since, for who goes out of the way [s]
constexpr double longest_drift = 120.0;   // for which it is foretold [s]
constexpr double no_way = 1.0;            // from its destination a member has nowhere to go [m]
constexpr double idle_turns = 4.0;        // after so many without use a group lets the next one move
constexpr double idle_decisions = 160.0;  // and so many, for a search about one centre
constexpr int most_plans = 8;             // in a round, of which some came to nothing
constexpr double start_slack = 0.002;     // of rounding, where somebody begins too near [m]
constexpr double most_late = 2.0;         // who looks at its clock so long after a start has missed it [s]

}  // namespace

Agreement::Agreement(std::size_t vehicle, const Terms& terms) noexcept
    : terms_{terms},
      vehicle_{vehicle},
      self_{terms.groups().member_of(vehicle)},
      count_{terms.groups().size_of(terms.groups().group_of(vehicle))},
      others_{vehicle, terms} {}

void Agreement::hold(const Member& member, bool aside) noexcept {
  const std::uint8_t version =
      known_[self_] ? static_cast<std::uint8_t>((members_[self_].version + 1) % 16) : 0;
  members_[self_] = as_told(member, terms_.datum);
  members_[self_].turns_before = others_.rounds.groups().count() == 1;
  members_[self_].version = version;
  known_.set(self_);
  aside_ = aside;
  heard_by_ = {};
  held_since_ = looked_;
  status_ = statuses_[self_] = Status::held;
}

void Agreement::arrive(const Vec3& place) noexcept {
  Member member = members_[self_];
  member.anchor = place;
  hold(member);
  status_ = statuses_[self_] = Status::arrived;
}

void Agreement::lose(const Vec3& place, const Vec3& velocity) noexcept {
  Member member = members_[self_];
  member.anchor = place;
  member.destination = place + foretold * velocity;
  hold(member);
  status_ = statuses_[self_] = Status::lost;
}

/// As it said: straight on.
Reference Agreement::adrift(std::size_t i) const noexcept {
  const Member& m = members_[i];
  Reference way;
  way.add({last_heard_[i], m.anchor});
  way.add(
      {last_heard_[i] + longest_drift, m.anchor + (longest_drift / foretold) * (m.destination - m.anchor)});
  return way;
}

Reference Agreement::whereabouts(std::size_t i) const noexcept {
  if (!known_[i]) return {};
  if (is_lost(i)) return adrift(i);
  if (statuses_[i] == Status::moving)
    return departed_[i] && plan_.participants[i] ? reference_of(members_[i], plan_, plan_.codes[i])
                                                 : gone_[i].way;
  const bool may_have_departed = departed_by_.epoch && departed_by_.participants[i] &&
                                 statuses_[i] == Status::held && last_heard_[i] < departed_by_.start();
  if (may_have_departed) return reference_of(members_[i], departed_by_, departed_by_.codes[i]);
  return Reference{members_[i].anchor};
}

/// Of somebody who is where it says.
double Agreement::clear_of(std::size_t i) const noexcept {
  return least_beside(members_[self_], members_[i], terms_.tubes);
}

double Agreement::evades_by(std::size_t i, double now) const noexcept {
  return clear_of(i) + (is_lost(i) ? turning_away * std::min(now - last_heard_[i], longest_unsure) : 0.0);
}

bool Agreement::meets_lost(const Reference& own, double now, double time) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    if (i != self_ && is_lost(i) &&
        least_distance(own, adrift(i), now, time) < clear_of(i) + turning_away * (now - last_heard_[i]))
      return true;
  }
  return false;
}

/// Up to its next gate, at which it stops anyway. Where it set out nearer to an anchor, as a plan lets it
/// that comes no nearer, it is enough that it does not.
bool Agreement::meets_held(const Reference& own, double now, double time) const noexcept {
  const double until = std::min(time, next_gate());
  for (std::size_t i = 0; i < count_; ++i) {
    const bool is_there =
        i != self_ && statuses_[i] == Status::held && (!left_[i] || last_heard_[i] > departed_by_.start());
    if (!is_there) continue;
    const Knot anchor{now, members_[i].anchor};
    const double least =
        std::min(clear_of(i), (own.at(departed_by_.start()) - anchor.position).norm() - start_slack);
    if (least_distance(own, {&anchor, 1}, now, until, least) < least) return true;
  }
  return false;
}

bool Agreement::meets_moving(const Reference& own, double now, double time) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    if (i == self_ || is_lost(i)) continue;
    const Reference way = whereabouts(i);
    if (way.knots().size() > 1 && least_distance(own, way, now, time) < clear_of(i)) return true;
  }
  return false;
}

void Agreement::go_on(double now, double period, const Link& link, double patience, const Chart& chart,
                      const Headway& headway) noexcept {
  assume(now, link.turn_period);
  stop_at_gate(now);
  acknowledge(now, settled_before(patience, link.turn_period), chart);
  depart(now, link.turn_period, chart);
  if (std::isinf(entered_) && others_.rounds.groups().count() > 1) entered_ = now;  // the first round
  // on board decisions may come more rarely than they are meant to
  const double since = now - looked_;
  looked_ = now;
  const bool is_rare = since > 1.2 * period && since < link.turn_period;
  propose(now, is_rare ? since : period, link, patience, chart, headway);
}

/// So long before a plan's start nobody acknowledges it any more [s]: a turn in which to say so, or what own
/// ship needs to have turned to its way when that goes, and half of what more there is, for others to pass it
/// on. Who acknowledges at the last moment divides the group into who hears of it and who does not.
double Agreement::settled_before(double patience, double turn_period) const noexcept {
  return math::fmax(a_turn * turn_period, turns_ahead_by(own())) + 0.5 * patience * turn_period;
}

/// Who has departed by a way without gates and is silent for good has arrived at its end for all that anybody
/// knows.
void Agreement::assume(double now, double turn_period) noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    const double silent_since = now - silent_for_good * turn_period;
    const Gone& gone = gone_[i];
    if (!gone.by || gone.may_stop || statuses_[i] != Status::moving || gone.way.end() > silent_since ||
        last_heard_[i] > silent_since)
      continue;
    members_[i].anchor = gone.way.knots().back().position;
    statuses_[i] = Status::arrived;
    settled_.set(i);
  }
}

/// Whose acknowledgement does not matter, since it is known where they are.
Members Agreement::unneeded(double now, double turn_period) const noexcept {
  Members all = settled_;
  for (std::size_t i = 0; i < count_; ++i)
    if (is_lost(i) && now - last_heard_[i] < turn_period) all.set(i);
  return all;
}

/// Those who are placed by the plan, own ship not among them.
Clearance Agreement::scene_of(const Plan& plan) const noexcept {
  Clearance scene{members_, plan.participants, terms_.tubes, plan.start()};
  const std::array<Reference, most_members> others = ways_of_others();
  for (std::size_t i = 0; i < count_; ++i) {
    if (i == self_) continue;
    if (plan.participants[i]) {
      scene.place(i, reference_of(members_[i], plan, plan.codes[i]));
    } else if (!others[i].knots().empty()) {
      scene.place(i, others[i]);
    }
  }
  return scene;
}

/// Whether the plan was made from the very states that are known here of those whom it takes along.
bool Agreement::is_as_told() const noexcept {
  return (plan_.participants & ~known_).none() &&
         digest_of(members_, plan_.participants, terms_.datum) == plan_.digest;
}

/// Rules 1 and 2, at least `ahead` before the start.
void Agreement::acknowledge(double now, double ahead, const Chart& chart) noexcept {
  if (plan_.epoch <= std::max(acknowledged_epoch_, refused_epoch_) || !is_pending(now + ahead)) return;
  const bool may_go = !plan_.participants[self_] || others_.may_depart();
  if (!is_as_told() || !may_go || status_ == Status::lost) return;
  if (!is_clear(chart)) {
    refused_epoch_ = plan_.epoch;
    return;
  }
  acknowledged_epoch_ = plan_.epoch;
  acknowledged_.set(self_);
}

/// Whether all that own ship may do is clear of the plan. Who is moving may have to promise to stop at its
/// next gate for that.
bool Agreement::accepts_own(const Clearance& scene, const Reference& way, const Chart& chart) const noexcept {
  return scene.accepts(self_, way) && keeps_off(way, chart, berth(members_[self_], terms_.tubes)) &&
         scene.passes(self_, way, chart.passing());
}

bool Agreement::is_clear(const Chart& chart) noexcept {
  const Clearance scene = scene_of(plan_);
  if (plan_.participants[self_])
    return status_ == Status::held &&
           accepts_own(scene, reference_of(members_[self_], plan_, plan_.codes[self_]), chart);
  if (status_ != Status::moving) return scene.accepts(self_, Reference{members_[self_].anchor});
  bool goes_or_stops = scene.accepts(self_, way_);
  for (std::size_t i = 0; i < count_; ++i)
    goes_or_stops =
        goes_or_stops && (left_[i] || gates_[i] == never || scene.accepts(self_, way_.until(gates_[i])));
  if (goes_or_stops) return true;
  const double gate = next_gate();
  if (gate == never || !scene.accepts(self_, way_.until(gate))) return false;
  way_ = way_.until(gate);
  return true;
}

Reference Agreement::promised(double now) const noexcept {
  return has_promised(now) ? reference_of(members_[self_], plan_, plan_.codes[self_]) : Reference{};
}

/// Rule 3.
void Agreement::depart(double now, double turn_period, const Chart& chart) noexcept {
  if (status_ != Status::held || !plan_.epoch || now < plan_.start() || judged_epoch_ == plan_.epoch) return;
  judged_epoch_ = plan_.epoch;
  const bool has_all = is_as_told() && (everyone() & ~unneeded(now, turn_period) & ~acknowledged_).none();
  if (acknowledged_epoch_ != plan_.epoch || !plan_.participants[self_]) {
    if (!has_all) ++attempts_;
    return;
  }
  acknowledged_epoch_.author = most_members - 1;  // none that starts together with it any more
  Clearance scene = scene_of(plan_);
  const Reference way = reference_of(members_[self_], plan_, plan_.codes[self_]);
  if (!has_all || now > plan_.start() + most_late || !others_.may_depart() ||
      !accepts_own(scene, way, chart)) {
    ++attempts_;
    return;
  }
  way_ = way;
  departed_by_ = plan_;
  scene.place(self_, way_);
  for (std::size_t i = 0; i < most_members; ++i) gates_[i] = scene.gate(self_, i);
  left_ = departed_;
  departed_.set(self_);
  status_ = statuses_[self_] = Status::moving;
  attempts_ = 0;
}

double Agreement::next_gate() const noexcept {
  double next = never;
  for (std::size_t i = 0; i < count_; ++i)
    if (!left_[i]) next = std::min(next, gates_[i]);
  return next;
}

/// Rule 4.
void Agreement::stop_at_gate(double now) noexcept {
  if (status_ != Status::moving || now < std::min(next_gate(), way_.end())) return;
  const bool leads_there =
      !aside_ && first_within(way_, members_[self_].destination, members_[self_].arrival) < never;
  const double stops = leads_there ? next_gate() : std::min(next_gate(), way_.end());
  if (now < stops) return;
  Member member = members_[self_];
  member.anchor = way_.at(stops);
  hold(member, aside_);
}

Members Agreement::held() const noexcept {
  Members all;
  for (std::size_t i = 0; i < count_; ++i)
    // of those who departed by the plan, only who has said since that it is held again
    if (known_[i] && statuses_[i] == Status::held && !is_done_here(i) &&
        (i == self_ || !departed_[i] || last_heard_[i] > plan_.start()))
      all.set(i);
  return all;
}

std::array<Reference, most_members> Agreement::ways_of_others() const noexcept {
  std::array<Reference, most_members> ways;
  for (std::size_t i = 0; i < count_; ++i) {
    const bool rests = settled_[i] || (is_done_here(i) && statuses_[i] != Status::moving);
    if (i != self_ && rests) ways[i] = Reference{members_[i].anchor};
    if (i != self_ && is_lost(i)) ways[i] = adrift(i);
  }
  return ways;
}

/// Whether it has gone on to the next round.
bool Agreement::is_ahead(std::size_t i) const noexcept {
  const Rounds& rounds = others_.rounds;
  return i != self_ && rounds.heard_in(rounds.groups().vehicle_of(rounds.own_group(), i)) > rounds.round();
}

/// Who departs by no plan of this round any more: it has gone on to the next one, or has gone aside.
bool Agreement::is_done_here(std::size_t i) const noexcept {
  if (others_.rounds.groups().count() == 1) return false;
  return is_ahead(i) || (members_[i].anchor - members_[i].destination).norm() < no_way;
}

/// Somebody of it moves and has not gone on, or has proposed something, as long as proposals are not in vain.
bool Agreement::is_group_busy(double now, double turn_period) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    const bool is_silent = i != self_ && now - last_heard_[i] > silent_for_good * turn_period;
    if (statuses_[i] == Status::moving && !is_silent && !is_ahead(i)) return true;
  }
  return is_pending(now) && plans_ < most_plans;
}

/// Whether others of its group have departed in this round by a plan that did not take it along.
bool Agreement::was_left_out() const noexcept {
  if (!plan_.epoch || plan_.start() < entered_ || plan_.participants[self_]) return false;
  for (std::size_t i = 0; i < count_; ++i)
    if (statuses_[i] == Status::moving && is_ahead(i)) return true;
  return false;
}

void Agreement::take_turns(double now, double period, double turn_period, bool is_free, bool rests) noexcept {
  Rounds& rounds = others_.rounds;
  if (rounds.owns() && (!others_.may_depart() || is_group_busy(now, turn_period))) used_ = now;
  const bool has_use =
      is_free && status_ == Status::held && !is_done_here(self_) && !found_none_ && !was_left_out() &&
      now < std::max(used_, entered_) + std::max(idle_turns * turn_period, idle_decisions * period);
  const bool is_under_way = status_ == Status::moving || status_ == Status::lost;
  if (!rounds.may_go_on(is_under_way || (rests && !has_promised(now) && !has_use))) return;
  rounds.go_on();
  if (search_) ++searches_;  // it came to nothing
  search_.reset();
  entered_ = now;
  found_none_ = false;
  plans_ = 0;
}

}  // namespace fairway::pledge
