// SPDX-License-Identifier: Apache-2.0
// What a helm is told of others, and what it tells.
#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/onboard/helm.hpp"

namespace fairway {
namespace {

constexpr double no_clock = 1e12;  // farther from 0 than any that counts seconds [s]

Fix fix_of(const Message& message, double record_period) {
  Fix fix{.time = seconds(message.sent, record_period)};
  fix.state.p_n = message.position;
  fix.state.q_nb = quaternion_of({.yaw = message.yaw});
  fix.state.v_b = fix.state.q_nb.conjugate() * message.velocity;
  return fix;
}

}  // namespace

FixVerdict Helm::own_fix(const Fix& fix, double now) noexcept {
  see_clock(now);
  const FixVerdict verdict = own_watch_.see(fix, now_, setup_.policy);
  if (verdict == FixVerdict::accepted) {
    see_current(fix);
    set_back_ = false;
  }
  see_lead(fix, verdict);
  return verdict;
}

/// A simulation that pauses stops its navigation too: a clock by which that is ahead, and goes on, is dead.
void Helm::see_lead(const Fix& fix, FixVerdict verdict) noexcept {
  if (verdict == FixVerdict::accepted) ahead_from_.reset();
  if (verdict != FixVerdict::ahead) return;
  ahead_by_ = fix.time - now_;
  if (!ahead_from_) ahead_from_ = ahead_by_;
}

void Helm::see_current(const Fix& fix) noexcept {
  if (!fix.through_water_b) return;
  const Vec3 told = fix.state.q_nb * (fix.state.v_b - *fix.through_water_b);
  const double since = current_time_ ? fix.time - *current_time_ : std::numeric_limits<double>::infinity();
  current_ += (1.0 - math::exp(-since / setup_.policy.current_time_constant_s)) * (told - current_);
  current_time_ = fix.time;
}

std::optional<std::size_t> Helm::index_of(std::uint32_t id, std::uint32_t modulus) const noexcept {
  for (std::size_t i = 0; i < setup_.team.size(); ++i) {
    const std::uint32_t mate = number(setup_.team[i].id);
    if ((modulus == 0 ? mate : mate % modulus) == id) return i;
  }
  return std::nullopt;
}

FixVerdict Helm::neighbour_fix(VehicleId id, const Fix& fix, double now) noexcept {
  see_clock(now);
  const std::optional<std::size_t> index = index_of(number(id), 0);
  return index ? see_neighbour(*index, fix) : FixVerdict::invalid;
}

FixVerdict Helm::see_neighbour(std::size_t index, const Fix& fix) noexcept {
  see_arrival_of(index);
  const FixVerdict verdict = neighbours_[index].watch.see(fix, now_, setup_.policy);
  if (verdict == FixVerdict::accepted) see_departure_of(index);
  return verdict;
}

void Helm::see_arrival_of(std::size_t index) noexcept {
  // whoever had come to its goal by its last fix is there, and gives way to everyone
  Neighbour& neighbour = neighbours_[index];
  const std::optional<Fix>& last = neighbour.watch.last();
  if (last && neighbour.goal && (last->state.p_n - *neighbour.goal).norm() <= setup_.team[index].arrival)
    neighbour.arrived_at = neighbour.goal;
}

/// Whoever has left the goal that it had come to is on its way again, and nobody has said where to.
void Helm::see_departure_of(std::size_t index) noexcept {
  constexpr double outside = 2.0;  // of the distance at which it had arrived: nobody holds quite still
  Neighbour& neighbour = neighbours_[index];
  if (!neighbour.arrived_at) return;
  const double off = (neighbour.watch.last()->state.p_n - *neighbour.arrived_at).norm();
  if (off <= outside * setup_.team[index].arrival) return;
  if (neighbour.goal == neighbour.arrived_at) neighbour.goal.reset();
  neighbour.arrived_at.reset();
}

void Helm::neighbour_goal(VehicleId id, const std::optional<Vec3>& goal) noexcept {
  const std::optional<std::size_t> index = index_of(number(id), 0);
  if (!index) return;
  Neighbour& neighbour = neighbours_[*index];
  const std::optional<Vec3> told = goal && is_finite(*goal) ? goal : std::nullopt;
  see_arrival_of(*index);  // it may fall silent about its goal because it is there
  if (told && told != neighbour.goal) neighbour.arrived_at.reset();
  neighbour.goal = told;
}

bool Helm::speech(VehicleId from, std::span<const std::uint8_t> bytes, double sent, double now) noexcept {
  see_clock(now);
  const bool is_time = sent <= now_ + setup_.policy.max_ahead_s && std::isfinite(sent);
  if (!index_of(number(from), 0) || bytes.size() > Speech::most_bytes || !is_time) {
    ++records_refused_;
    return false;
  }
  const auto place =
      std::ranges::lower_bound(heard_, number(from), {}, [](const Heard& h) { return number(h.from); });
  const bool is_known = place != heard_.end() && place->from == from;
  if (is_known && place->sent > sent) return true;  // it comes too late
  Heard heard{.from = from, .sent = sent, .speech = {.size = static_cast<std::uint8_t>(bytes.size())}};
  std::ranges::copy(bytes, heard.speech.bytes.begin());
  if (is_known) {
    *place = heard;
  } else {
    heard_.insert(place, heard);
  }
  return true;
}

void Helm::turns(double next, double period) noexcept {
  next_turn_ = next;
  turn_period_ = period;
}

Speech Helm::own_speech() const noexcept {
  const bool was_asked = order_.state == HelmState::under_way || order_.state == HelmState::arrived ||
                         order_.state == HelmState::keeping || order_.state == HelmState::holding;
  return was_asked && avoider_.speaks() ? avoider_.speech() : Speech{};
}

FixVerdict Helm::team_record(std::span<const std::uint8_t> bytes, double now) noexcept {
  see_clock(now);
  TeamRecord record{};
  const bool fits = bytes.size() == record.size();
  if (fits) std::ranges::copy(bytes, record.begin());

  // by a clock that is ahead a record is of the future, and not a whole cycle old
  const double latest = now_ + 0.5 * record_cycle_s;
  const bool has_clock = std::fabs(latest) < no_clock;
  const Tick latest_tick{has_clock ? std::llround(latest / setup_.record_period) : 0};
  const Message message = decode(record, latest_tick, setup_.record_period);
  const std::optional<std::size_t> index = index_of(number(message.from), record_ids);
  if (!fits || !has_clock || !index || !can_be_told(message.position)) {
    ++records_refused_;
    return FixVerdict::invalid;
  }

  const FixVerdict verdict = see_neighbour(*index, fix_of(message, setup_.record_period));
  if (verdict == FixVerdict::accepted) {
    Neighbour& neighbour = neighbours_[*index];
    neighbour.radius = message.radius < most_told_radius_m
                           ? message.radius
                           : math::fmax(message.radius, setup_.team[*index].radius);
    neighbour.priority = message.priority;
    neighbour_goal(setup_.team[*index].id, message.destination);
  }
  return verdict;
}

double Helm::common_time() const noexcept {
  constexpr double never = -std::numeric_limits<double>::infinity();
  const auto time_of = [](const FixWatch& watch) { return watch.last() ? watch.last()->time : never; };
  double oldest = time_of(own_watch_);
  for (const Neighbour& neighbour : neighbours_) oldest = math::fmin(oldest, time_of(neighbour.watch));
  return oldest;
}

std::optional<TeamRecord> Helm::own_record(double now) const noexcept {
  const std::optional<Fix>& fix = own_watch_.last();
  if (!fix || own_watch_.age(now) > setup_.policy.own_lost_s || std::fabs(fix->time) > no_clock) return {};
  const Tick sent{std::llround(fix->time / setup_.record_period)};
  const Ownship own = pilot_.own_ship(fix->state, fix->position_sigma, arrived_);
  const double since = seconds(sent, setup_.record_period) - fix->time;
  if (!can_be_told(own.position)) return {};
  const Message message{.from = own.id,
                        .sent = sent,
                        .position = own.position + since * own.velocity,
                        .velocity = own.velocity,
                        .yaw = own.yaw,
                        .radius = own.radius,
                        .priority = own.priority,
                        .destination = goal()};
  return encode(message, setup_.record_period);
}

HelmReport Helm::report(double now) const {
  const auto counts_of = [](const FixWatch& watch) {
    decltype(HelmReport::own_counts) counts{};
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = watch.count(static_cast<FixVerdict>(i));
    return counts;
  };
  HelmReport report{.order = order_,
                    .own_age = own_watch_.age(now),
                    .own_verdict = own_watch_.verdict(),
                    .own_position_sigma = own_watch_.last() ? own_watch_.last()->position_sigma : 0.0,
                    .own_counts = counts_of(own_watch_),
                    .decisions = decisions_,
                    .infeasible = infeasible_,
                    .clock_restarts = clock_restarts_,
                    .records_refused = records_refused_,
                    .refused_at = own_watch_.refused_at(),
                    .neighbours = {}};
  for (std::size_t i = 0; i < neighbours_.size(); ++i) {
    const Neighbour& neighbour = neighbours_[i];
    HelmReport::Neighbour line{
        .mate = &setup_.team[i], .verdict = neighbour.watch.verdict(), .counts = counts_of(neighbour.watch)};
    if (neighbour.watch.last()) {
      line.age = neighbour.watch.age(now);
      line.distance = (track_of(i).position - own_.position).norm();
      line.growth = growth_of(line.age);
      line.heard = true;
      line.stale = line.age > setup_.policy.neighbour_stale_s;
      line.lost = is_lost(neighbour);
      line.shown = neighbour.shown;
    }
    report.refused_at = math::fmax(report.refused_at, neighbour.watch.refused_at());
    report.neighbours.push_back(line);
  }
  return report;
}

}  // namespace fairway
