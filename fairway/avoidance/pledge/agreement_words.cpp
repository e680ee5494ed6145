// SPDX-License-Identifier: Apache-2.0
// What a member hears, and what it says.
#include <algorithm>
#include <cmath>

#include "fairway/avoidance/pledge/agreement.hpp"

namespace fairway::pledge {
namespace {

constexpr double long_unheard = 6.0;         // turns after which a state is passed on to who has not heard it
constexpr double longest_kept = 100.0;       // an older word is not passed on [s]
constexpr double longest_under_way = 200.0;  // an older one is not heard [s]
constexpr std::int64_t passes_each = 3;      // turns, of which one is for passing on

}  // namespace

Hearing Agreement::hear(const Speech& speech, double sent, double now) noexcept {
  if (sent < now - longest_under_way) return Hearing::taken;
  const std::optional<Word> word = decode(speech, terms_.datum, sent);
  if (!word) return Hearing::unreadable;
  const Header& header = header_of(*word);
  if (header.sent > now + 1.0) return Hearing::early;
  const Groups& groups = others_.rounds.groups();
  if (header.sender >= groups.vehicles || header.sender == vehicle_) return Hearing::taken;
  if (groups.group_of(header.sender) != groups.group_of(vehicle_)) {
    others_.hear(*word, speech);
    return Hearing::taken;
  }
  const std::size_t from = groups.member_of(header.sender);
  if (header.sent <= last_heard_[from]) return Hearing::taken;
  others_.rounds.hear(header.sender, header.round, false);
  if (const auto* state = std::get_if<StateWord>(&*word)) {
    if (is_alarm(from, *state)) alarmed_[from] = now;
    members_[from] = state->member;
    members_[from].turns_before = groups.count() == 1;
    if (header.status == Status::lost) members_[from].radius += wandering;
    if (!known_[from]) known_since_[from] = now;
    known_.set(from);
    said_[from] = {speech, header.sent};
    settled_[from] = header.status == Status::arrived;
  } else {
    learn(std::get<PlanWord>(*word));
  }
  learn(header);
  return Hearing::taken;
}

/// Whether it tells that somebody is lost, or is held elsewhere than before while somebody is.
bool Agreement::is_alarm(std::size_t from, const StateWord& word) const noexcept {
  if (word.header.status == Status::lost) return statuses_[from] != Status::lost;
  const bool is_elsewhere = known_[from] && members_[from].version != word.member.version;
  return word.header.status == Status::held && is_elsewhere &&
         std::ranges::count(statuses_, Status::lost) > 0;
}

void Agreement::learn(const Header& header) noexcept {
  const std::size_t from = others_.rounds.groups().member_of(header.sender);
  last_heard_[from] = header.sent;
  statuses_[from] = header.status;
  heard_by_[from] = header.heard;
  newest_epoch_ = std::max(newest_epoch_, header.epoch);
  if (header.epoch == plan_.epoch) {
    acknowledged_ |= header.acknowledged;
    departed_ |= header.departed;
    left_ |= header.departed;
  }
  const bool has_gone = header.status == Status::moving || header.status == Status::arrived;
  if (has_gone && header.sent > plan_.start()) left_.set(from);
  if (header.status == Status::held || header.status == Status::lost) gone_[from] = {};
  if (header.status == Status::moving && departed_[from] && plan_.participants[from] &&
      gone_[from].by != plan_.epoch)
    learn_way_of(from);
}

/// Another has departed by the newest plan. Nothing but a gate can stop it any more.
void Agreement::learn_way_of(std::size_t other) noexcept {
  const Reference way = reference_of(members_[other], plan_, plan_.codes[other]);
  const Clearance::Gates gates =
      Clearance{members_, plan_.participants, terms_.tubes, plan_.start()}.gates_of(other, way);
  gone_[other] = {plan_.epoch, way, *std::ranges::min_element(gates) < never};
}

void Agreement::learn(const PlanWord& word) noexcept {
  if (word.plan.epoch <= plan_.epoch) return;
  plan_ = word.plan;
  ++plans_;
  acknowledged_ = departed_ = {};
  search_.reset();
}

/// The state of somebody, in the very bytes that it said: of who is lost in every other turn, as long as own
/// ship is on its way or has arrived, in the turn after an alarm that, and in some turns that of whom another
/// has not heard for long. For all who hear it that is a word that took longer.
const Speech* Agreement::passed_on(double now, double turn_period) const noexcept {
  const auto turn = static_cast<std::int64_t>(std::floor(now / turn_period));
  const bool has_time = status_ != Status::held && !is_pending(now);
  if (has_time && (turn + static_cast<std::int64_t>(self_)) % 2 == 0) {
    for (std::size_t i = 0; i < count_; ++i)
      if (i != self_ && is_lost(i) && now < last_heard_[i] + turn_period) return &said_[i].speech;
  }
  const auto alarm = std::ranges::max_element(alarmed_);
  if (now < *alarm + turn_period) return &said_[static_cast<std::size_t>(alarm - alarmed_.begin())].speech;
  if (const Speech* other = passed_on_in_turn(now, turn_period)) return other;
  if (turn % passes_each != 0) return nullptr;
  for (std::size_t k = 0; k < count_; ++k) {
    const std::size_t of = (static_cast<std::size_t>(turn / passes_each) + k) % count_;
    if (of == self_ || !known_[of] || said_[of].sent < now - longest_kept ||
        now < known_since_[of] + long_unheard * turn_period)
      continue;
    for (std::size_t to = 0; to < count_; ++to)
      if (to != self_ && to != of && known_[to] && !heard_by_[to][of]) return &said_[of].speech;
  }
  return nullptr;
}

/// The last word of one vehicle after the other, of its own group the last state, in every other turn of who
/// has no round and has told its own: it may be out of the reach of who waits for it.
const Speech* Agreement::passed_on_in_turn(double now, double turn_period) const noexcept {
  const Groups& groups = others_.rounds.groups();
  if (others_.rounds.owns() || status_ == Status::moving || now < entered_ + turn_period) return nullptr;
  const std::size_t turn = static_cast<std::size_t>(std::floor(now / turn_period)) + vehicle_;
  if (turn % 2 != 0) return nullptr;
  for (std::size_t i = 0; i < groups.vehicles; ++i) {
    const std::size_t of = (turn / 2 + vehicle_ + i) % groups.vehicles;
    const bool is_mate = groups.group_of(of) == others_.rounds.own_group();
    const Said& said = is_mate ? said_[groups.member_of(of)] : others_.bystanders()[of].said;
    if (of != vehicle_ && said.sent > now - longest_kept) return &said.speech;
  }
  return nullptr;
}

Speech Agreement::say(double now, double turn_period) const noexcept {
  if (status_ != Status::lost && !is_news(now, turn_period)) {
    if (const Speech* other = passed_on(now, turn_period)) return *other;
  }
  const bool is_forgotten = now > plan_.start() + soonest_forgotten;
  // of somebody whom the plan takes along it does not have the state that the plan was made from
  const bool is_mistaken = is_pending(now) && !is_as_told();
  const Header header{.sender = static_cast<std::uint8_t>(vehicle_),
                      .round = others_.rounds.told(),
                      .epoch = is_forgotten ? Epoch{} : plan_.epoch,
                      .sent = now,
                      .status = status_,
                      .acknowledged = acknowledged_,
                      .departed = departed_,
                      .heard = is_mistaken ? known_ & ~plan_.participants : known_};
  // whose group has no round tells where it is held, which the others wait for, or, of who is on its way, now
  // the plan and now the state that it was made from
  const bool owns = others_.rounds.owns(), goes = status_ == Status::moving && header.epoch;
  const bool tells_plan =
      status_ != Status::lost && !is_news(now, turn_period) && (owns ? is_pending(now) || goes : goes);
  // a plan that it cannot acknowledge comes to nothing, and may have been made from an older state of its
  // own; of who has arrived no acknowledgement is needed once that is known
  const bool is_missing = status_ != Status::moving && acknowledged_epoch_ != plan_.epoch;
  Members without_me;
  for (std::size_t i = 0; i < count_; ++i)
    if (i != self_ && !heard_by_[i][self_]) without_me.set(i);
  const bool is_odd_turn = std::fmod(std::floor(now / turn_period), 2.0) != 0.0;
  const bool is_known = without_me.none() && !is_missing && owns;
  if (tells_plan && !(is_missing && status_ == Status::held) && (is_known || is_odd_turn))
    return encode(PlanWord{header, plan_}, terms_.datum);
  return encode(StateWord{header, members_[self_]}, terms_.datum);
}

std::string_view Agreement::reason(double now) const noexcept {
  if (status_ == Status::moving) return "goes by a plan that everybody has acknowledged";
  if (status_ == Status::arrived) return "has arrived, and is held for ever";
  if (status_ == Status::lost) return "is off its promised way, holds and says so";
  if (known_ != everyone()) return "waits for the state of another member";
  if (!others_.rounds.owns()) return "waits until it is its group's turn";
  if (!others_.may_depart()) return "waits to hear where the other groups are held, or go";
  if (search_) return "looks for a plan";
  if (is_pending(now))
    return acknowledged_[self_] ? "waits for acknowledgements, and for the start"
                                : "cannot acknowledge the plan";
  return "waits for a plan";
}

}  // namespace fairway::pledge
