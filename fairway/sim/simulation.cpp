// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "fairway/core/math.hpp"
#include "fairway/core/prefetch.hpp"
#include "fairway/sim/feasibility.hpp"

namespace fairway {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// Of one vehicle, where they are kept, and how many are near: whoever has more takes memory for them.
constexpr std::size_t usual_tracks = 32;
constexpr std::size_t usual_near = 128;
constexpr std::size_t usual_obstacles = 32;  // likewise, of a method that does not look far

/// Apart from the ids of vehicles, which count from 0.
TrackId id_of(const Drifter& drifter) { return TrackId{first_drifter_id + drifter.number}; }

/// Whether one vehicle may have in common with the other what it is built of.
bool is_built_alike(const VehicleSpec& a, const VehicleSpec& b) {
  return is_same(a.model, b.model) && is_same(a.allocation, b.allocation) &&
         is_same(a.autopilot, b.autopilot);
}

bool may_be_silent(const Agent& agent) {
  return !agent.cooperative || agent.failure.kind == FailureKind::silent;
}

/// What does not change of it; where it is stays to be said by `move_to`.
Mover mover_of(const Agent& agent, bool is_silent) {
  return {.id = TrackId{number(agent.ship().id)},
          .radius = agent.ship().radius,
          .reacts = agent.cooperative,
          .silent = is_silent};
}

void move_to(const Agent& agent, Mover& mover) {
  const VehicleState& x = agent.vehicle.state();
  mover.position = x.p_n;
  mover.velocity = x.v_n();
  mover.q_nb = x.q_nb;
  mover.priority = agent.cooperative ? agent.own.priority : first_priority;
}

Mover mover_of(const Drifter& drifter) {
  return {.id = id_of(drifter),
          .position = drifter.position,
          .velocity = drifter.velocity,
          .radius = drifter.radius,
          .priority = first_priority,
          .reacts = false,
          .silent = true,
          .is_vehicle = false};
}

/// Makes `message` what a vehicle says of itself, as it believes to be, or what its method says instead.
void write(const Agent& agent, Tick now, bool is_told, Message& message) {
  const Speech speech = is_told && agent.avoider.speaks() ? agent.avoider.speech() : Speech{};
  if (!speech.empty()) {
    message = {.from = agent.ship().id, .sent = now, .speech = speech};
    return;
  }
  const Leg* leg = agent.mission.leg();
  const bool going =
      leg != nullptr && leg->kind != LegKind::rendezvous && leg->kind != LegKind::keep_position;
  message = {.from = agent.ship().id,
             .sent = now,
             .position = agent.own.position,
             .velocity = agent.own.velocity,
             .yaw = agent.own.yaw,
             .radius = agent.ship().radius,
             .priority = agent.own.priority,
             .destination = going ? std::optional{leg->position} : std::nullopt,
             .told = is_told};
}

/// Of a large fleet hardly anyone is in the cache: what a vehicle points to, once it has come itself.
void fetch_beyond(const Agent& agent) {
  if (const Leg* leg = agent.mission.leg()) prefetch(leg, sizeof *leg);
  __builtin_prefetch(agent.vehicle.actuator_state().data());
  __builtin_prefetch(agent.demand.data());
  agent.avoider.fetch();
}

/// Whoever looks round usually looks at no more than a few, within perception's range.
Vicinity::Lists lists_of(const Scenario& scenario) {
  return {.most = scenario.perception.range_m, .usual_count = 12.0};
}

}  // namespace

Simulation::Simulation(const Scenario& scenario, const Catalogs& catalogs)
    : period_{scenario.step_s},
      last_tick_{static_cast<std::int64_t>(std::floor(scenario.duration_s / scenario.step_s + 1e-9))},
      sea_{scenario.water, Rng{scenario.seed}},
      obstacles_{scenario.obstacles},
      exchange_{make_exchange(scenario)},
      found_at_{lists_of(scenario)},
      stop_when_done_{scenario.stop_when_done} {
  agents_.reserve(scenario.vehicles.size());
  const VehicleSpec* before = nullptr;
  for (const VehicleSpec& spec : scenario.vehicles) {
    const bool alike = before != nullptr && is_built_alike(*before, spec);
    agents_.push_back(make_agent(spec, scenario, catalogs, alike ? &agents_.back() : nullptr));
    before = &spec;
  }
  looked_at_ = std::ranges::any_of(agents_, [](const Agent& agent) { return agent.lookout.has_sensor(); });
  if (looked_at_ || !exchange_.carries_at_once() || std::ranges::any_of(agents_, may_be_silent)) {
    movers_.reserve(agents_.size() + obstacles_.drifters().size());
    for (const Agent& agent : agents_)
      movers_.push_back(mover_of(agent, !agent.cooperative || !exchange_.carries_anything()));
    places_.resize(agents_.size());
  }
  movers_.resize(movers_.size() + obstacles_.drifters().size());
  mailbox_.resize(agents_.size());
  hands_.resize(1);
  frame_.resize(agents_.size());
  check_feasible(scenario, agents_, sea_);
}

void Simulation::step(std::span<FrameSink* const> sinks) {
  showing_all_ = observer_ != nullptr;
  look(std::ranges::any_of(sinks, [](const FrameSink* sink) { return sink->wants_tracks(); }));
  act(sinks);
}

void Simulation::look() {
  showing_all_ = true;
  look(true);
}

void Simulation::share_out(std::size_t threads) {
  crew_ = {};
  if (threads > 1) crew_.emplace(threads);
  hands_.resize(std::max<std::size_t>(threads, 1));
}

DecisionTimes Simulation::decision_times() const {
  DecisionTimes all;
  for (const Hand& hand : hands_) {
    all = {all.count + hand.times.count, all.total_s + hand.times.total_s,
           math::fmax(all.worst_s, hand.times.worst_s)};
  }
  return all;
}

StageTimes Simulation::stage_times() const {
  StageTimes all;
  for (const Hand& hand : hands_) all.add(hand.stages);
  return all;
}

void Simulation::make_room(bool keeping) {
  keeping_ = keeping;
  const std::size_t others = std::max<std::size_t>(agents_.size(), 1) - 1 + obstacles_.drifters().size();
  const std::size_t fixed = obstacles_.fixed().size();
  const auto make = [&](Sight& sight, std::size_t most_tracks, std::size_t most_obstacles) {
    sight.tracks.reserve(std::min(most_tracks, others));
    sight.obstacles.reserve(std::min(most_obstacles, fixed));
  };
  for (Hand& hand : hands_) {
    if (hand.near.capacity() > 0) continue;
    std::size_t most_alone = 0, most_together = 0;
    for (const Agent& agent : agents_) {
      if (agent.avoider.speaks()) words_.reserve(agents_.size());
      std::size_t& most = agent.avoider.decides_for_many() ? most_together : most_alone;
      most = std::max(most, agent.avoider.most_tracks());
    }
    make(hand.passing, std::max(most_alone, most_together), fixed);
    if (!keeping)
      for (Sight& sight : hand.company.sights) make(sight, most_together, fixed);
    hand.near.reserve(std::max(std::min(usual_near, others + 1), most_picked_out(fixed)));
  }
  if (!keeping || !kept_.empty()) return;
  kept_.resize(agents_.size());
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Avoider& avoider = agents_[i].avoider;
    const bool sees_all = viewpoint_of(agents_[i]).farthest_obstacle == endless;
    make(kept_[i], std::min(usual_tracks, avoider.most_tracks()), sees_all ? fixed : usual_obstacles);
  }
}

/// The stages that a vehicle goes through by itself, for a part of the fleet at a time, so that what one
/// stage leaves in the cache the next one finds there. Each reads of the others only what stood still before,
/// so that parts may be gone through in any order, and at the same time.
template <class... Works>
void Simulation::in_parts(Works... /*in this order*/) {
  constexpr std::size_t many = 1500;  // so few stay in a cache; of 1000 it gains nothing, of 2000 a little
  constexpr std::size_t ahead = 4;    // are fetched, while the first stage is at another
  constexpr std::size_t soon = 2;     // and what they point to
  const auto go_through_stages = [&](std::size_t part, std::size_t number) {
    Hand& hand = hands_[number];
    const std::size_t first = part * part_size, end = std::min(first + part_size, agents_.size());
    if (timing_stages_) hand.stages.begin();
    std::size_t fetched = agents_.size() > many ? first : end, beyond = fetched;
    const auto go =
        [&]<Stage stage, void (Simulation::*work)(std::size_t, Hand&), void (Simulation::*together)(Hand&)>(
            Work<stage, work, together>) {
          for (std::size_t i = first; i < end; ++i) {
            for (; fetched < std::min(i + ahead, end); ++fetched) prefetch(&agents_[fetched], sizeof(Agent));
            for (; beyond < std::min(i + soon, fetched); ++beyond) fetch_beyond(agents_[beyond]);
            (this->*work)(i, hand);
          }
          if constexpr (together != nullptr) (this->*together)(hand);
          if (timing_stages_) hand.stages.finish(stage);
        };
    (go(Works{}), ...);
  };
  const bool one_at_a_time = observer_ != nullptr;
  go_through(one_at_a_time ? nullptr : crew_.get(), parts_of(agents_.size()), go_through_stages);

  // each hand keeps that of the first part in which it found one, so that the first of all is one of them
  for (Hand& hand : hands_) {
    if (hand.divergence &&
        (!divergence_ || hand.divergence->vehicle / part_size < divergence_->vehicle / part_size))
      divergence_ = hand.divergence;
    hand.divergence.reset();
  }
}

void Simulation::look(bool keeping) {
  if (divergence_) return;
  make_room(keeping);
  for (Hand& hand : hands_) {
    hand.rendezvous_reached = std::numeric_limits<int>::max();
    hand.anyone_speaks = false;
  }
  in_parts(Work<Stage::locate, &Simulation::locate>{}, Work<Stage::deliver, &Simulation::tell>{});
  if (timing_stages_) hands_[0].stages.begin();
  deliver();
  if (timing_stages_) hands_[0].stages.finish(Stage::deliver);
  if (keeping) in_parts(Work<Stage::perceive, &Simulation::perceive>{});
}

void Simulation::act(std::span<FrameSink* const> sinks) {
  if (divergence_) return;
  watched_ = !sinks.empty();
  constexpr Work<Stage::perceive, &Simulation::perceive> perceiving;
  constexpr Work<Stage::decide, &Simulation::decide, &Simulation::decide_together> deciding;
  constexpr Work<Stage::control, &Simulation::control> controlling;
  constexpr Work<Stage::record, &Simulation::record> recording;
  if (keeping_) {
    in_parts(deciding, controlling, recording);
  } else {
    in_parts(perceiving, deciding, controlling, recording);
  }
  if (divergence_) return;
  show(sinks);
  in_parts(Work<Stage::move, &Simulation::move, &Simulation::move_together>{});
  sea_.advance(period_);
  tick_ = next(tick_);
}

void Simulation::notice(std::size_t index, std::string_view impossible, Tick when, Hand& hand) {
  if (impossible.empty()) return;
  if (hand.divergence && hand.divergence->vehicle / part_size <= index / part_size) return;
  hand.divergence = {.vehicle = index, .tick = when, .time = seconds(when, period_), .why = impossible};
}

void Simulation::refuse_divergence() const {
  if (divergence_) throw RunDiverged{*divergence_, agents_[divergence_->vehicle].ship().name};
}

void Simulation::run(std::span<FrameSink* const> sinks) {
  while (!is_done()) step(sinks);
  refuse_divergence();
}

bool Simulation::is_done() const {
  if (divergence_ || count(tick_) > count(last_tick_)) return true;
  const auto is_finished = [](const Agent& agent) {
    return agent.mission.phase() == Phase::arrived || agent.mission.phase() == Phase::stuck;
  };
  return stop_when_done_ && std::ranges::all_of(agents_, is_finished);
}

void Simulation::locate(std::size_t index, Hand& /*hand*/) {
  Agent& agent = agents_[index];
  const VehicleState& truth = agent.vehicle.state();
  agent.current = sea_.water_at(truth.p_n, time()).current_n;
  agent.own =
      agent.pilot.own_ship(agent.navigation.estimate(truth, period_), agent.navigation.position_sigma(),
                           agent.mission.phase() == Phase::arrived);
}

void Simulation::tell(std::size_t index, Hand& hand) {
  const Agent& agent = agents_[index];
  const bool is_silent = agent.has_failed(FailureKind::silent, time());
  const bool is_told = agent.cooperative && !is_silent && exchange_.may_take(index, tick_);
  write(agent, tick_, is_told, mailbox_[index]);
  hand.anyone_speaks = hand.anyone_speaks || !mailbox_[index].speech.empty();
  if (!everyone_tells()) {
    // of who told all at once nothing is left to go by but what is seen
    if (is_silent && exchange_.carries_at_once()) movers_[index].silent = true;
    places_[index] = agent.vehicle.state().p_n;
    if (looked_at_ || movers_[index].silent) move_to(agent, movers_[index]);
  }
  hand.rendezvous_reached = std::min(hand.rendezvous_reached, agent.mission.rendezvous_reached());
}

void Simulation::deliver() {
  rendezvous_reached_ = std::numeric_limits<int>::max();
  for (const Hand& hand : hands_)
    rendezvous_reached_ = std::min(rendezvous_reached_, hand.rendezvous_reached);
  exchange_.pass_on(tick_, mailbox_, places_, obstacles_.fixed());
  sort_places();
  obstacles_.move_to(time());
  std::ranges::transform(obstacles_.drifters(),
                         movers_.end() - static_cast<std::ptrdiff_t>(obstacles_.drifters().size()),
                         [](const Drifter& drifter) { return mover_of(drifter); });
}

void Simulation::sort_places() {
  const Vec3 nowhere = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  const bool told_at_once = exchange_.carries_at_once();
  const auto place_of = [&](std::size_t i) -> Vec3 {
    if (!everyone_tells() && movers_[i].silent) return places_[i];
    return told_at_once && mailbox_[i].tells_place() ? mailbox_[i].position : nowhere;
  };
  found_at_.update(agents_.size(), place_of, crew_.get());
}

Scene Simulation::scene_of(std::size_t index) const {
  return {.time = time(),
          .period = period_,
          .own_index = index,
          .movers = movers_,
          .obstacles = obstacles_.fixed(),
          .heard = exchange_.heard_by(index, mailbox_),
          .places = &found_at_,
          .heard_at_once = exchange_.carries_at_once(),
          .unforeseen_acceleration = exchange_.unforeseen_acceleration(),
          .indexes = obstacles_.indexes()};
}

Viewpoint Simulation::viewpoint_of(const Agent& agent) const {
  return {agent.vehicle.state(), agent.estimate(), agent.ship().radius, agent.avoider.most_tracks(),
          showing_all_ ? endless : agent.avoider.farthest_obstacle()};
}

void Simulation::perceive(std::size_t index, Hand& hand) {
  Agent& agent = agents_[index];
  const bool is_free = !waits_for_method(agent) || agent.agrees;
  if (time() >= agent.start_delay) agent.mission.advance(agent.own, time(), everyone_is_at(agent) && is_free);
  if (agent.mission.phase() == Phase::under_way) agent.set_out = math::fmin(agent.set_out, time());
  if (agent.lookout.has_sensor()) agent.lookout.sense(scene_of(index), viewpoint_of(agent));
  if (keeping_ && is_deciding(agent)) look_round(index, hand.near, kept_[index]);
}

void Simulation::look_round(std::size_t index, std::vector<Near>& near, Sight& sight) {
  Agent& agent = agents_[index];
  agent.lookout.report(scene_of(index), viewpoint_of(agent), near, sight.tracks, sight.obstacles);
}

}  // namespace fairway
