// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "fairway/sim/feasibility.hpp"

namespace fairway {
namespace {

/// Of one vehicle, where they are kept: whoever has more takes memory for them.
constexpr std::size_t usual_tracks = 32;

/// Apart from the ids of vehicles, which count from 0.
TrackId id_of(const Drifter& drifter) { return TrackId{first_drifter_id + drifter.number}; }

Mover mover_of(const Agent& agent, bool is_silent) {
  const VehicleState& x = agent.vehicle.state();
  return {.id = TrackId{number(agent.ship().id)},
          .position = x.p_n,
          .velocity = x.v_n(),
          .q_nb = x.q_nb,
          .radius = agent.ship().radius,
          .priority = agent.cooperative ? agent.own.priority : first_priority,
          .reacts = agent.cooperative,
          .silent = is_silent};
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

/// What a vehicle says of itself, as it believes to be.
Message message_of(const Agent& agent, Tick now) {
  const Leg* leg = agent.mission.leg();
  const bool going =
      leg != nullptr && leg->kind != LegKind::rendezvous && leg->kind != LegKind::keep_position;
  return {.from = agent.ship().id,
          .sent = now,
          .position = agent.own.position,
          .velocity = agent.own.velocity,
          .yaw = agent.own.yaw,
          .radius = agent.ship().radius,
          .priority = agent.own.priority,
          .destination = going ? std::optional{leg->position} : std::nullopt,
          .told = agent.cooperative};
}

Viewpoint viewpoint_of(const Agent& agent) {
  return {agent.vehicle.state(), agent.estimate, agent.ship().radius, agent.avoider.most_tracks()};
}

/// The wrench of the actuators at their present state; zero where they do not push.
Wrench wrench_of(const Vehicle& vehicle) {
  const Propulsion* propulsion = vehicle.propulsion();
  if (propulsion == nullptr) return Wrench::Zero();
  return propulsion->effectiveness * vehicle.actuator_state();
}

/// What a request over ground is through the water.
BodyRequest through_water(const BodyRequest& over_ground, const Vec3& current_b) {
  return {.surge_mps = over_ground.surge_mps - current_b.x(),
          .sway_mps = over_ground.sway_mps - current_b.y(),
          .heave_mps = over_ground.heave_mps - current_b.z(),
          .yaw_rate_radps = over_ground.yaw_rate_radps,
          .through_water = true};
}

}  // namespace

Simulation::Simulation(const Scenario& scenario, const Catalogs& catalogs)
    : period_{scenario.step_s},
      last_tick_{static_cast<std::int64_t>(std::floor(scenario.duration_s / scenario.step_s + 1e-9))},
      sea_{scenario.water, Rng{scenario.seed}},
      obstacles_{scenario.obstacles},
      exchange_{make_exchange(scenario)},
      range_{scenario.perception.range_m},
      stop_when_done_{scenario.stop_when_done} {
  agents_.reserve(scenario.vehicles.size());
  for (const VehicleSpec& spec : scenario.vehicles) agents_.push_back(make_agent(spec, scenario, catalogs));
  movers_.resize(agents_.size() + obstacles_.drifters().size());
  places_.resize(agents_.size());
  mailbox_.resize(agents_.size());
  near_.reserve(movers_.size());
  frame_.resize(agents_.size());
  drawings_.resize(agents_.size());
  check_feasible(scenario, agents_, sea_);
}

void Simulation::step(std::span<FrameSink* const> sinks) {
  look(std::ranges::any_of(sinks, [](const FrameSink* sink) { return sink->wants_tracks(); }));
  act(sinks);
}

void Simulation::look() { look(true); }

void Simulation::make_room(bool keeping) {
  keeping_ = keeping;
  const auto make = [&](Sight& sight, std::size_t most_tracks) {
    sight.tracks.reserve(std::min(most_tracks, movers_.size()));
    sight.obstacles.reserve(obstacles_.fixed().size());
  };
  if (!keeping && passing_.tracks.capacity() == 0) {
    std::size_t most = 1;
    for (const Agent& agent : agents_) most = std::max(most, agent.avoider.most_tracks());
    make(passing_, most);
  }
  if (!keeping || !kept_.empty()) return;
  kept_.resize(agents_.size());
  for (std::size_t i = 0; i < agents_.size(); ++i)
    make(kept_[i], std::min(usual_tracks, agents_[i].avoider.most_tracks()));
}

/// The stages that a vehicle goes through by itself, for a part of the fleet at a time, so that what one
/// stage leaves in the cache the next one finds there. Each reads of the others only what stood still before.
template <Stage... stages, void (Simulation::*... works)(std::size_t index)>
void Simulation::in_parts(Work<stages, works>... /*in this order*/) {
  constexpr std::size_t part = 32;
  for (std::size_t first = 0; first < agents_.size(); first += part) {
    const std::size_t end = std::min(first + part, agents_.size());
    const auto go_through = [&]<Stage stage, void (Simulation::*work)(std::size_t)>(Work<stage, work>) {
      for (std::size_t i = first; i < end; ++i) (this->*work)(i);
      stages_.finish(stage);
    };
    (go_through(Work<stages, works>{}), ...);
  }
}

void Simulation::look(bool keeping) {
  if (divergence_) return;
  make_room(keeping);
  stages_.begin();
  in_parts(Work<Stage::locate, &Simulation::locate>{}, Work<Stage::deliver, &Simulation::tell>{});
  deliver();
  stages_.finish(Stage::deliver);
  if (keeping) in_parts(Work<Stage::perceive, &Simulation::perceive>{});
}

void Simulation::act(std::span<FrameSink* const> sinks) {
  if (divergence_) return;
  stages_.begin();
  if (!keeping_) {
    in_parts(Work<Stage::perceive, &Simulation::perceive>{}, Work<Stage::decide, &Simulation::decide>{},
             Work<Stage::control, &Simulation::control>{});
  } else {
    in_parts(Work<Stage::decide, &Simulation::decide>{}, Work<Stage::control, &Simulation::control>{});
  }
  if (divergence_) return;
  show(sinks);
  stages_.finish(Stage::record);
  in_parts(Work<Stage::move, &Simulation::move>{});
  sea_.advance(period_);
  tick_ = next(tick_);
}

void Simulation::notice(std::size_t index, std::string_view impossible, Tick when) {
  if (impossible.empty() || divergence_) return;
  divergence_ = {.vehicle = index, .tick = when, .time = seconds(when, period_), .why = impossible};
}

void Simulation::refuse_divergence() const {
  if (divergence_) throw RunDiverged{*divergence_, agents_[divergence_->vehicle].ship().name};
}

void Simulation::order(std::size_t index, const Command& command, const std::optional<BodyRequest>& request) {
  agents_[index].order = command;
  agents_[index].request = request;
}

void Simulation::release(std::size_t index) {
  agents_[index].order.reset();
  agents_[index].request.reset();
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

void Simulation::locate(std::size_t index) {
  Agent& agent = agents_[index];
  const VehicleState& truth = agent.vehicle.state();
  agent.current = sea_.water_at(truth.p_n, time()).current_n;
  agent.estimated_current = agent.navigation.current(agent.current);
  agent.estimate = agent.navigation.estimate(truth, period_);
  agent.own = agent.pilot.own_ship(agent.estimate, agent.mission.phase() == Phase::arrived);
}

void Simulation::tell(std::size_t index) {
  const Agent& agent = agents_[index];
  mailbox_[index] = message_of(agent, tick_);
  places_[index] = agent.vehicle.state().p_n;
  movers_[index] = mover_of(agent, !agent.cooperative || !exchange_.carries_anything());
  const int reached = agent.mission.rendezvous_reached();
  rendezvous_reached_ = index == 0 ? reached : std::min(rendezvous_reached_, reached);
}

void Simulation::deliver() {
  exchange_.pass_on(tick_, mailbox_, places_);
  sort_places();
  obstacles_.move_to(time());
  std::ranges::transform(obstacles_.drifters(), movers_.begin() + static_cast<std::ptrdiff_t>(agents_.size()),
                         [](const Drifter& drifter) { return mover_of(drifter); });
}

void Simulation::sort_places() {
  const Vec3 nowhere = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  const bool told_at_once = exchange_.carries_at_once();
  found_at_.rebuild(agents_.size(), range_, [&](std::size_t i) -> Vec3 {
    if (movers_[i].silent) return places_[i];
    return told_at_once ? mailbox_[i].position : nowhere;
  });
}

Scene Simulation::scene_of(std::size_t index) const {
  return {.time = time(),
          .period = period_,
          .own_index = index,
          .movers = movers_,
          .obstacles = obstacles_.fixed(),
          .heard = exchange_.heard_by(index),
          .places = &found_at_,
          .heard_at_once = exchange_.carries_at_once(),
          .unforeseen_acceleration = exchange_.unforeseen_acceleration()};
}

void Simulation::perceive(std::size_t index) {
  Agent& agent = agents_[index];
  const bool everyone_ready = rendezvous_reached_ >= agent.mission.rendezvous_reached();
  if (time() >= agent.start_delay) agent.mission.advance(agent.own, time(), everyone_ready);
  if (agent.lookout.has_sensor()) agent.lookout.sense(scene_of(index), viewpoint_of(agent));
  if (keeping_ && is_deciding(agent)) look_round(index);
}

void Simulation::look_round(std::size_t index) {
  Agent& agent = agents_[index];
  Sight& sight = keeping_ ? kept_[index] : passing_;
  agent.lookout.report(scene_of(index), viewpoint_of(agent), near_, sight.tracks, sight.obstacles);
}

bool Simulation::is_deciding(const Agent& agent) const {
  return is_avoiding(agent.mission.phase()) && agent.pilot.is_due(time(), period_);
}

Command Simulation::decided(std::size_t index) {
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
  return ask(index);
}

Situation Simulation::situation(std::size_t index) const {
  const Agent& agent = agents_[index];
  const Sight& sight = keeping_ ? kept_[index] : passing_;
  return agent.pilot.situation(time(), agent.own, *agent.mission.leg(), sight.tracks, sight.obstacles);
}

Command Simulation::ask(std::size_t index) {
  Agent& agent = agents_[index];
  const Situation shown = situation(index);
  Command command =
      agent.order ? *agent.order : agent.avoider.decide(shown, showing_ ? &drawings_[index] : nullptr);
  if (observer_ != nullptr) observer_->see(index, shown, command);
  return command;
}

void Simulation::decide(std::size_t index) {
  Agent& agent = agents_[index];
  const bool deciding = is_deciding(agent);
  if (is_avoiding(agent.mission.phase()) && !deciding) return;
  drawings_[index].clear();
  if (deciding && !keeping_) look_round(index);
  using Clock = std::chrono::steady_clock;
  const bool timed = timing_ && deciding;
  const Clock::time_point begin = timed ? Clock::now() : Clock::time_point{};
  const Command command = decided(index);
  if (timed) {
    const double took = std::chrono::duration<double>(Clock::now() - begin).count();
    times_ = {times_.count + 1, times_.total_s + took, std::fmax(times_.worst_s, took)};
  }
  agent.pilot.obey(command, {agent.own.position, agent.own.yaw});
  if (deciding) agent.pilot.note_decision(time());
  if (!deciding) agent.pilot.ask_at_once();
}

void Simulation::control(std::size_t index) {
  Agent& agent = agents_[index];
  const Command& command = agent.pilot.command();
  notice(index, why_impossible(command), tick_);
  if (!command.note.empty()) agent.note = command.note;
  agent.demand = demanded(index);
  notice(index, why_impossible(agent.demand), tick_);
}

ActuatorValues Simulation::demanded(std::size_t index) {
  Agent& agent = agents_[index];
  const bool avoids = is_avoiding(agent.mission.phase());
  const bool steered_from_outside = avoids && agent.request;
  const Command& command = agent.pilot.command();
  if (command.wrench && !steered_from_outside) {
    if (const std::optional<ActuatorValues> pushed = agent.autopilot.push(*command.wrench)) {
      agent.pilot.end_hold();
      return *pushed;
    }
  }
  const BodyRequest request =
      steered_from_outside ? *agent.request : agent.pilot.request(agent.own, agent.estimated_current, avoids);
  notice(index, why_impossible(request), tick_);

  // the vehicle's own controller works on velocities through the water
  const VehicleState& x = agent.vehicle.state();
  const Vec3 current_b = x.q_nb.conjugate() * agent.current;
  return agent.autopilot.control(request.through_water ? request : through_water(request, current_b),
                                 x.v_b - current_b, x.omega_b, period_, x.q_nb);
}

void Simulation::record(std::size_t index) {
  const Agent& agent = agents_[index];
  const Leg* leg = agent.mission.leg();
  const ActuatorValues& actuators = agent.vehicle.actuator_state();
  frame_[index] = {
      .id = agent.ship().id,
      .state = agent.vehicle.state(),
      .command = agent.pilot.command(),
      .phase = agent.mission.phase(),
      .goal = leg != nullptr ? leg->position : agent.own.position,
      .goal_speed = leg != nullptr ? leg->speed_mps : 0.0,
      .actuators = {actuators.data(), static_cast<std::size_t>(actuators.size())},
      .power = agent.vehicle.power(),
      .wrench = wrench_of(agent.vehicle),
      .tracks = keeping_ ? std::span<const Track>{kept_[index].tracks} : std::span<const Track>{},
      .echoes = agent.lookout.echoes(),
      .strokes = drawings_[index].strokes()};
}

void Simulation::show(std::span<FrameSink* const> sinks) {
  if (sinks.empty()) return;
  in_parts(Work<Stage::record, &Simulation::record>{});
  flights_.clear();
  if (showing_) exchange_.add_under_way(flights_);
  const Frame frame{tick_, time(), period_, frame_, flights_};
  for (FrameSink* sink : sinks) sink->write(frame);
}

void Simulation::move(std::size_t index) {
  Agent& agent = agents_[index];
  const VehicleState& x = agent.vehicle.state();
  agent.vehicle.step(agent.demand, sea_.water_halfway(x.p_n, x.v_n(), time(), period_), period_);
  notice(index, why_impossible(x), next(tick_));
}

}  // namespace fairway
