// SPDX-License-Identifier: Apache-2.0
// How a member comes to a plan, and proposes it.
#include <algorithm>
#include <cmath>

#include "fairway/avoidance/pledge/agreement.hpp"
#include "fairway/core/math.hpp"

namespace fairway::pledge {
namespace {

constexpr int codes_at_once = 200;         // of the search, in one decision, for its 1 ms
constexpr int charted_codes_at_once = 80;  // likewise, where something stands
constexpr int crowded_codes_at_once = 40;  // likewise, where there are vehicles of other groups
constexpr double search_decisions = 30.0;  // before a turn in which a search begins, for all its codes
constexpr double search_turns = 1.5;       // that it goes on for more to go, where others are held
constexpr double last_decisions = 1.5;     // before a turn in which a proposal is made
constexpr double silent_turns = 3.0;       // after so many the next member may propose
constexpr double most_patience = 9.0;      // turns from a plan's word to its start

/// Turns beyond one from a plan's word until everybody has heard everybody's acknowledgement, where nothing
/// is lost. Who speaks right after that word may have chosen its own before it had come in, and then
/// acknowledges a turn later; its word takes as long as a slot.
double two_slots(std::size_t count) { return 2.0 / static_cast<double>(count); }

int codes_in_one_decision(const Chart& chart) {
  if (chart.has_others()) return crowded_codes_at_once;
  return chart.empty() ? codes_at_once : charted_codes_at_once;
}

}  // namespace

/// Whether anybody has own state, without which nobody can acknowledge a plan.
bool Agreement::is_known() const noexcept {
  return std::ranges::any_of(heard_by_, [&](const Members& heard) { return heard[self_]; });
}

/// Of the first plan of a round, whoever's turn comes first; of later ones the smallest of the held that is
/// not silent.
bool Agreement::may_propose(double now, double turn_period) const noexcept {
  const bool is_settling = plan_.epoch && now < plan_.start() + turn_period;
  if (status_ != Status::held || is_settling || known_ != everyone() || is_news(now, turn_period) ||
      !others_.may_depart())
    return false;
  if (!newest_epoch_) return is_known();
  if (start_of(newest_epoch_) < entered_) return true;
  const Members waiting = held();
  for (std::size_t i = 0; i < self_; ++i)
    if (waiting[i] && now - last_heard_[i] < silent_turns * turn_period) return false;
  return true;
}

/// How long before a plan's start somebody begins to turn to its way at the latest [s].
double Agreement::slowest_turn() const noexcept {
  double slowest = 0.0;
  for (std::size_t i = 0; i < count_; ++i) slowest = math::fmax(slowest, turns_ahead_by(members_[i]));
  return slowest;
}

/// The soonest at which a plan may start that is told in the next turn: so late that all can acknowledge it
/// before they have to turn to their ways.
Epoch Agreement::soonest_plan(const Link& link, double patience) const noexcept {
  const double turns = std::min(a_turn + two_slots(terms_.count) + patience + attempts_, most_patience);
  const double turning = math::fmax(slowest_turn() - a_turn * link.turn_period, 0.0);
  const double start = std::ceil((link.next_turn + turns * link.turn_period + turning) / 0.1);
  const std::int64_t after_all = newest_epoch_ ? newest_epoch_.tenths + 1 : Epoch::none;
  return {std::max(static_cast<std::int64_t>(start), after_all), static_cast<std::uint8_t>(self_)};
}

/// When a plan would start that is found beside those who are on their ways: by then the search has ended.
Epoch Agreement::start_beside_others(const Link& link, double patience, const Chart& chart) const noexcept {
  Epoch start = soonest_plan(link, patience);
  if (!chart.empty()) start.tenths += static_cast<std::int64_t>(search_turns * link.turn_period / 0.1);
  return start;
}

void Agreement::begin_search(double now, const Link& link, double patience, const Chart& chart,
                             const Headway& headway) noexcept {
  search_began_ = now;
  std::array<Reference, most_members> others = ways_of_others();
  bool it_matters_when = !chart.passing().empty();
  for (std::size_t i = 0; i < count_; ++i) {
    if (i == self_ || statuses_[i] != Status::moving) continue;
    others[i] = whereabouts(i);
    it_matters_when = it_matters_when || !others[i].empty();
  }
  const Epoch start = it_matters_when ? start_beside_others(link, patience, chart) : Search::at_zero;
  if (!it_matters_when)
    for (Reference& other : others) other = other.later(-(now + 2.0 * link.turn_period));
  search_.emplace(members_, held(), others, terms_, searches_ % 2 == 0 ? 0 : (searches_ + 1) / 2, chart,
                  chart.empty() ? headway : Headway{}, start);
}

/// When the plan that was found may start: as soon as may be, or when it was looked for.
std::optional<Epoch> Agreement::start_of_found(const Link& link, double patience,
                                               const Chart& chart) const noexcept {
  const Epoch soonest = soonest_plan(link, patience), looked_for = search_->start();
  if (looked_for == Search::at_zero || search_->holds_from(soonest, chart.passing())) return soonest;
  if (looked_for < soonest || !search_->holds_from(looked_for, chart.passing())) return {};
  return looked_for;
}

/// It searches before its turn, and proposes at the last decision before it what it has found by then, unless
/// it hears of another plan first.
void Agreement::propose(double now, double period, const Link& link, double patience, const Chart& chart,
                        const Headway& headway) noexcept {
  if (!may_propose(now, link.turn_period)) {
    search_.reset();
    return;
  }
  const double ahead = link.next_turn - now;
  if (!search_) {
    const double parts = chart.empty() ? 1.0 : 2.0 * static_cast<double>(Search::most_hubs);
    if (ahead > parts * search_decisions * period) return;
    begin_search(now, link, patience, chart, headway);
  }
  const bool has_ended = search_->go_on(codes_in_one_decision(chart), chart);
  // who cannot go while others are held may go later
  const double enough = std::max(search_turns * link.turn_period, search_decisions * period);
  const bool is_beside_others = chart.has_others() || search_->start() != Search::at_zero;
  const bool is_enough = is_beside_others && now > search_began_ + enough;
  const bool is_best = chart.empty() || has_ended || is_enough || search_->found_all();
  const bool is_due = search_->found() && is_best && ahead <= last_decisions * period;
  const std::optional<Epoch> start = is_due ? start_of_found(link, patience, chart) : std::nullopt;
  if (start) {
    plan_ = search_->best();
    plan_.epoch = *start;
    plan_.digest = digest_of(members_, plan_.participants, terms_.datum);
    newest_epoch_ = plan_.epoch;
    ++plans_;
    acknowledged_ = departed_ = {};
    search_.reset();
    ++searches_;
    acknowledge(now, 0.0, chart);
  } else if (is_due || (has_ended && !search_->found())) {
    found_none_ = !search_->found();
    search_.reset();
    ++searches_;
  }
}

}  // namespace fairway::pledge
