// SPDX-License-Identifier: Apache-2.0
// How vehicles decide: as they are told from outside, those whose method can decide for many together, the
// others one by one.
#include <chrono>

#include "fairway/core/math.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {

void Simulation::order(std::size_t index, const Command& command, const std::optional<BodyRequest>& request) {
  orders_.resize(agents_.size());
  orders_[index] = {command, request};
}

void Simulation::release(std::size_t index) {
  if (!orders_.empty()) orders_[index] = {};
}

/// In force; null where the vehicle goes by itself.
const Simulation::Order* Simulation::order_of(std::size_t index) const {
  return !orders_.empty() && orders_[index].command ? &orders_[index] : nullptr;
}

bool Simulation::is_deciding(const Agent& agent) const {
  return is_avoiding(agent.mission.phase()) && agent.pilot.is_due(time(), period_);
}

Command Simulation::decided(std::size_t index, Hand& hand) {
  Agent& agent = agents_[index];
  const Leg* leg = agent.mission.leg();
  if (leg == nullptr || time() < agent.start_delay) return {.mode = Mode::hold};
  switch (leg->kind) {
    case LegKind::rendezvous:
    case LegKind::keep_position:
      return {.mode = Mode::hold};
    case LegKind::go_to:
      return go_to(*leg, agent.own, period_);
    case LegKind::section:
      return follow_section(*leg, agent.own);
    case LegKind::transit:
      break;
  }
  return ask(index, hand);
}

/// Whether all have come to the rendezvous that it has come to, or will come to next.
bool Simulation::everyone_is_at(const Agent& agent) const {
  return rendezvous_reached_ >= agent.mission.rendezvous_reached();
}

bool Simulation::waits_for_method(const Agent& agent) {
  const Leg* leg = agent.mission.leg();
  return leg != nullptr && leg->kind == LegKind::rendezvous && leg->agreed && agent.avoider.speaks();
}

/// Has a method that speaks hear and say what it will while its mission waits, or is over. Nothing of what it
/// decides is carried out then but how to stay.
std::optional<Command> Simulation::attend(std::size_t index, Hand& hand) {
  Agent& agent = agents_[index];
  const Phase phase = agent.mission.phase();
  if (!agent.avoider.speaks() || !exchange_.carries_anything() ||
      (phase != Phase::waiting && phase != Phase::arrived))
    return {};
  const Leg here{.kind = LegKind::transit, .position = agent.own.position};
  const Leg* leg = phase == Phase::waiting ? agent.mission.next_transit() : &here;
  if (leg == nullptr) return {};
  Situation shown = agent.pilot.situation(time(), agent.own, *leg, {}, obstacles_.fixed());
  listen(index, hand, shown);
  shown.current = agent.estimated_current();
  shown.attendance = phase == Phase::arrived                            ? Attendance::arrived
                     : waits_for_method(agent) && everyone_is_at(agent) ? Attendance::ready
                                                                        : Attendance::waiting;
  const Command command = agent.avoider.decide(shown);
  const bool stays = command.mode == Mode::hold;
  agent.agrees = !stays && shown.attendance == Attendance::ready;
  return stays ? std::optional{command} : std::nullopt;
}

/// What of all that was said has come in, and when its own turns are; all times are those of the clocks on
/// board.
void Simulation::listen(std::size_t index, Hand& hand, Situation& shown) {
  hear(index, hand.heard);
  hand.ranges.clear();
  const std::span<const std::optional<AcousticRange>> ranges = exchange_.ranges_by(index);
  for (std::size_t to = 0; to < ranges.size(); ++to) {
    if (!ranges[to]) continue;
    hand.ranges.push_back(*ranges[to]);
    hand.ranges.back().to = agents_[to].ship().id;
  }
  const double ahead = exchange_.clock_ahead(index, tick_);
  hand.link = {hand.heard, exchange_.turn_period(), exchange_.next_turn(index, tick_) + ahead, hand.ranges};
  shown.link = &hand.link;
  shown.time += ahead;
}

void Simulation::hear(std::size_t index, std::vector<Heard>& heard) const {
  heard.clear();
  const std::span<const Message> all = exchange_.heard_by(index, mailbox_);
  for (std::size_t from = 0; from < all.size(); ++from) {
    const Message& message = all[from];
    if (!message.told || message.speech.empty() || message.from == agents_[index].ship().id) continue;
    const double sent = seconds(message.sent, period_) + exchange_.clock_ahead(from, message.sent);
    heard.push_back({message.from, sent, message.speech});
  }
}

std::vector<Heard> Simulation::heard_by(std::size_t index) const {
  std::vector<Heard> heard;
  hear(index, heard);
  return heard;
}

Situation Simulation::situation(std::size_t index) const { return situation(index, kept_[index]); }

Situation Simulation::situation(std::size_t index, const Sight& sight) const {
  const Agent& agent = agents_[index];
  Situation shown =
      agent.pilot.situation(time(), agent.own, *agent.mission.leg(), sight.tracks, sight.obstacles);
  shown.current = agent.estimated_current();
  return shown;
}

Command Simulation::ask(std::size_t index, Hand& hand) {
  Agent& agent = agents_[index];
  Situation shown = situation(index, keeping_ ? kept_[index] : hand.passing);
  if (agent.avoider.speaks() && exchange_.carries_anything()) {
    listen(index, hand, shown);
  }
  const Order* order = order_of(index);
  Command command = order != nullptr ? *order->command
                                     : agent.avoider.decide(shown, showing_ ? &drawings_[index] : nullptr);
  if (observer_ != nullptr) observer_->see(index, shown, command);
  return command;
}

void Simulation::decide(std::size_t index, Hand& hand) {
  Agent& agent = agents_[index];
  const bool deciding = is_deciding(agent);
  if (is_avoiding(agent.mission.phase()) && !deciding) return;
  if (!drawings_.empty()) drawings_[index].clear();
  if (deciding && joins(index)) return join(index, hand);
  if (!deciding) {
    const std::optional<Command> stay = attend(index, hand);
    obey(agent, stay ? *stay : decided(index, hand));
    return agent.pilot.ask_at_once();
  }
  if (!keeping_) look_round(index, hand.near, hand.passing);
  Command command;
  timed(1, hand, [&] { command = decided(index, hand); });
  obey(agent, command);
  agent.pilot.note_decision(time());
}

/// Whether it decides together with others: nobody looks over its shoulder or tells it what to do.
bool Simulation::joins(std::size_t index) const {
  return !showing_ && observer_ == nullptr && order_of(index) == nullptr &&
         agents_[index].avoider.decides_for_many();
}

void Simulation::join(std::size_t index, Hand& hand) {
  Company& company = hand.company;
  const std::size_t place = company.count++;
  const Sight& sight = keeping_ ? kept_[index] : company.sights[place];
  if (!keeping_) look_round(index, hand.near, company.sights[place]);
  company.members[place] = index;
  company.avoiders[place] = &agents_[index].avoider;
  company.situations[place] = situation(index, sight);
  if (company.count == Company::most) decide_together(hand);
}

void Simulation::decide_together(Hand& hand) {
  Company& company = hand.company;
  const std::size_t count = company.count;
  if (count == 0) return;
  timed(count, hand, [&] {
    Avoider::decide_many(std::span{company.avoiders}.first(count), std::span{company.situations}.first(count),
                         std::span{company.commands}.first(count));
  });
  for (std::size_t i = 0; i < count; ++i) {
    Agent& agent = agents_[company.members[i]];
    obey(agent, company.commands[i]);
    agent.pilot.note_decision(time());
  }
  company.count = 0;
}

/// Does what `decide` does, `count` decisions, and takes the time of it if somebody wants to know.
template <class Decide>
void Simulation::timed(std::size_t count, Hand& hand, const Decide& decide) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = timing_ ? Clock::now() : Clock::time_point{};
  decide();
  if (!timing_) return;
  const double took = std::chrono::duration<double>(Clock::now() - begin).count();
  DecisionTimes& times = hand.times;
  times = {times.count + static_cast<std::int64_t>(count), times.total_s + took,
           math::fmax(times.worst_s, took / static_cast<double>(count))};
}

/// Who is beyond control goes on as it went when that began, and says what its method still says. What a
/// method that speaks waits for is over once it does not say so any more.
void Simulation::obey(Agent& agent, const Command& command) {
  if (!command.note.empty() || agent.avoider.speaks()) agent.note = command.note;
  if (agent.beyond_control) return;
  agent.beyond_control = agent.has_failed(FailureKind::leaves, time());
  const Command carried_out = agent.beyond_control ? Command{.velocity = agent.own.velocity} : command;
  agent.pilot.obey(carried_out, agent.own, agent.estimated_current());
}

}  // namespace fairway
