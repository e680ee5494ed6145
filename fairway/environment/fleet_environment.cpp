// SPDX-License-Identifier: Apache-2.0
#include "fairway/environment/fleet_environment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fairway/core/math.hpp"
#include "fairway/experiment/measure_run.hpp"

namespace fairway::environment {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What an avoider has already shortened to the speed limit is not shortened again by a rounding error.
constexpr double speed_tolerance = 1.0 + 1e-12;

/// A request that differs by less is the same [m/s, rad/s].
constexpr double request_tolerance = 1e-6;

double largest_speed(const Limits& limits, std::span<const Leg> mission) {
  double fastest = 0.0;
  for (const Leg& leg : mission) fastest = std::max(fastest, leg.speed_mps);
  return limit_or(limits.max_speed, fastest);
}

/// What an action can say of a command.
Command action_of(const Command& command) {
  return {.velocity = command.mode == Mode::hold ? Vec3{Vec3::Zero()} : command.velocity};
}

BodyRequest request_by(const Agent& agent, const Command& command) {
  Pilot pilot = agent.pilot;
  pilot.obey(command, agent.own, agent.estimated_current());
  return pilot.request(agent.own, agent.estimated_current());
}

/// Whether the vehicle would do the same now without the command's heading and turn rate.
bool velocity_says_all(const Agent& agent, const Command& command) {
  if (!command.turn_rate && (!command.heading || command.mode == Mode::hold)) return true;
  const BodyRequest whole = request_by(agent, command);
  const BodyRequest part = request_by(agent, action_of(command));
  const auto are_near = [](double a, double b) { return std::abs(a - b) <= request_tolerance; };
  return are_near(whole.surge_mps, part.surge_mps) && are_near(whole.sway_mps, part.sway_mps) &&
         are_near(whole.yaw_rate_radps, part.yaw_rate_radps);
}

int checked_count(const char* name, int given, int present, int usual, int most) {
  if (given > most) {
    throw InputError(std::string(name) + " is " + std::to_string(given) + "; it is at most " +
                     std::to_string(most));
  }
  return given >= 0 ? given : std::min(present, usual);
}

}  // namespace

FleetEnvironment::FleetEnvironment(Scenario scenario, DrawScenario draw, const Catalogs& catalogs,
                                   EnvironmentOptions options, FrameSink* guard)
    : draw_{std::move(draw)},
      catalogs_{catalogs},
      options_{std::move(options)},
      scenario_{std::move(scenario)},
      seed_{scenario_.seed} {
  sinks_.assign({nullptr});
  if (guard != nullptr) sinks_.push_back(guard);
  if (options_.action_repeat < 1) {
    throw InputError("action_repeat is " + std::to_string(options_.action_repeat) + "; it is at least 1");
  }
  find_learners();
  count_neighbours();
  advice_.resize(learners_.size());
}

void FleetEnvironment::find_learners() {
  std::vector<std::string_view> known;
  for (const VehicleSpec& spec : scenario_.vehicles) known.push_back(spec.name);
  if (options_.learners.empty()) options_.learners.assign(known.begin(), known.end());
  for (const std::string& name : options_.learners) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end())
      throw InputError("there is no vehicle \"" + name + "\" to learn" + suggestion(name, known));
    const auto index = static_cast<std::size_t>(found - known.begin());
    if (std::ranges::any_of(places_, [&](const Place& place) { return place.agent == index; }))
      throw InputError("the vehicle \"" + name + "\" is named twice among the learners");
    Place place;
    place.agent = index;
    places_.push_back(place);
    Learner learner;
    learner.max_speed = largest_speed(scenario_.vehicles[index].limits, scenario_.vehicles[index].mission);
    learners_.push_back(learner);
  }
}

void FleetEnvironment::count_neighbours() {
  const auto drifting =
      static_cast<int>(std::ranges::count_if(scenario_.obstacles, [](const auto& o) { return o.moves(); }));
  ObservationShape& shape = options_.observation;
  shape.tracks =
      checked_count("tracks", shape.tracks, static_cast<int>(scenario_.vehicles.size()) - 1 + drifting, 8,
                    ObservationShape::most_tracks);
  shape.obstacles =
      checked_count("obstacles", shape.obstacles, static_cast<int>(scenario_.obstacles.size()) - drifting, 4,
                    ObservationShape::most_obstacles);
  double& near = options_.reward.near_m;
  if (near < 0.0) near = 2.0 * scenario_.exam.safety_distance_m;
}

void FleetEnvironment::reset(std::optional<std::uint64_t> seed) {
  const bool is_first = !simulation_;
  if (seed) {
    seed_ = *seed;
    episodes_ = 0;
    begin(seed_);
  } else if (is_first) {
    begin(seed_);
  } else {
    ++episodes_;
    begin(Rng{seed_}.stream("episode", episodes_).next() >> 11U);  // exact in every text and double
  }
}

void FleetEnvironment::begin(std::uint64_t seed) {
  terminated_ = true;
  truncated_ = false;
  Scenario drawn = draw_(seed);
  simulation_.reset();
  metrics_.reset();
  scenario_ = std::move(drawn);
  simulation_.emplace(scenario_, catalogs_);
  metrics_.emplace(metrics_for(scenario_));
  sinks_.front() = &*metrics_;
  last_tick_ = static_cast<std::int64_t>(std::floor(scenario_.duration_s / scenario_.step_s + 1e-9));
  obstacles_.clear();
  for (const ObstacleSpec& spec : scenario_.obstacles) obstacles_.push_back({spec.view(), spec.velocity});
  advisers_.clear();

  deploy();
  time_ = simulation_->time();
  for (std::size_t row = 0; row < learners_.size(); ++row) {
    Learner& learner = learners_[row];
    const std::size_t index = places_[row].agent;
    places_[row].command.reset();
    places_[row].wanted.setZero();
    learner.max_speed = largest_speed(*agent(row).ship().limits, scenario_.vehicles[index].mission);
    learner.reward = 0.0;
    learner.collided = false;
    learner.phase = agent(row).mission.phase();
    learner.separation = separation_of(index);
    learner.clearance = clearance_of(index);
    places_[row].touching =
        learner.separation <= scenario_.exam.safety_distance_m || learner.clearance <= 0.0;
    turn_to_leg(row);
  }
  terminated_ = false;
  for (std::size_t row = 0; row < learners_.size(); ++row) learners_[row].deciding = is_deciding(row);
}

void FleetEnvironment::deploy() {
  simulation_->look();
  const auto is_under_way = [&](const Place& place) {
    return is_avoiding(simulation_->agents()[place.agent].mission.phase());
  };
  while (options_.skip_deployment && std::ranges::none_of(places_, is_under_way)) {
    if (simulation_->is_done() || count(simulation_->tick()) >= last_tick_) {
      throw InputError("no learner of " + scenario_.name + " is ever under way on a transit");
    }
    pass_tick();
  }
}

void FleetEnvironment::refuse_nonsense(std::span<const double> actions) {
  for (const double part : actions) {
    if (!std::isfinite(part)) throw std::invalid_argument("an action holds NaN or an infinity");
  }
}

void FleetEnvironment::step(std::span<const double> actions) {
  refuse_nonsense(actions);
  for (std::size_t row = 0; row < places_.size(); ++row) {
    Vec3 wanted{actions[3 * row], actions[3 * row + 1], actions[3 * row + 2]};
    if (options_.scaled_actions)
      wanted = learners_[row].max_speed * wanted.cwiseMax(-1.0).cwiseMin(1.0).eval();
    places_[row].wanted = wanted;
    places_[row].command.reset();
  }
  advance();
}

void FleetEnvironment::step(std::span<const Command> commands) {
  for (std::size_t row = 0; row < places_.size(); ++row) places_[row].command = commands[row];
  advance();
}

void FleetEnvironment::advance() {
  if (is_over()) throw std::logic_error("the episode is over: reset() begins the next one");
  for (Learner& learner : learners_) {
    learner.reward = 0.0;
    learner.separation = learner.clearance = infinity;
  }
  const int ticks = scenario_.steps_per_decision * options_.action_repeat;
  for (int i = 0; i < ticks && !is_over(); ++i) {
    give_orders();
    pass_tick();
    for (std::size_t row = 0; row < places_.size(); ++row) judge(row);
    decide_end();
  }
  time_ = simulation_->time();
  for (std::size_t row = 0; row < places_.size(); ++row) learners_[row].deciding = is_deciding(row);
  if (is_over()) simulation_->act(sinks_);  // so that the metrics see the end, as those of a run do
}

void FleetEnvironment::pass_tick() {
  try {
    simulation_->act(sinks_);
    simulation_->refuse_divergence();
  } catch (...) {  // a user's algorithm ended it, or it broke
    terminated_ = true;
    throw;
  }
  simulation_->look();
}

void FleetEnvironment::give_orders() {
  for (const Place& place : places_) {
    if (!simulation_->is_deciding(place.agent)) continue;
    Situation shown = simulation_->situation(place.agent);
    asked_ = place.command
                 ? *place.command
                 : Command{.velocity = from_axes(options_.observation.axes, shown.own.yaw, place.wanted)};
    shown.limits.max_speed *= speed_tolerance;
    simulation_->order(place.agent, limiter_.decide(shown));
  }
}

double FleetEnvironment::separation_of(std::size_t index) const {
  const std::span<const Agent> agents = simulation_->agents();
  const Vec3& own = agents[index].vehicle.state().p_n;
  double nearest2 = infinity;
  for (std::size_t i = 0; i < agents.size(); ++i) {
    if (i == index) continue;
    nearest2 = math::fmin(nearest2, (agents[i].vehicle.state().p_n - own).squaredNorm());
  }
  return std::sqrt(nearest2);
}

double FleetEnvironment::clearance_of(std::size_t index) const {
  const Agent& agent = simulation_->agents()[index];
  double nearest = infinity;
  for (const DriftingObstacle& obstacle : obstacles_) {
    const Obstacle now = obstacle.at(simulation_->time());
    nearest = math::fmin(nearest, nearest_point(now, agent.vehicle.state().p_n).distance);
  }
  return nearest - agent.ship().radius;
}

void FleetEnvironment::turn_to_leg(std::size_t row) {
  const Leg* leg = agent(row).mission.leg();
  if (leg != nullptr) places_[row].leg_end = leg->position;
  learners_[row].goal_distance = (places_[row].leg_end - agent(row).vehicle.state().p_n).norm();
}

void FleetEnvironment::judge(std::size_t row) {
  Learner& learner = learners_[row];
  Place& place = places_[row];
  const RewardWeights& weights = options_.reward;
  const double safety_distance = scenario_.exam.safety_distance_m;
  const double separation = separation_of(place.agent);
  const double clearance = clearance_of(place.agent);
  const bool is_touching = separation <= safety_distance || clearance <= 0.0;

  if (is_avoiding(learner.phase)) {
    const double distance = (place.leg_end - agent(row).vehicle.state().p_n).norm();
    const bool has_arrived = agent(row).mission.phase() == Phase::arrived;
    const bool has_collided = is_touching && !place.touching;
    const double near = nearness(separation, clearance, safety_distance, weights.near_m);
    learner.reward += weights.progress * (learner.goal_distance - distance);
    learner.reward += scenario_.step_s * (weights.time + weights.nearness * near);
    if (has_collided) learner.reward += weights.collision;
    if (has_arrived) learner.reward += weights.arrival;
    learner.collided = learner.collided || has_collided;
  }
  place.touching = is_touching && has_set_out(learner.phase);
  learner.separation = math::fmin(learner.separation, separation);
  learner.clearance = math::fmin(learner.clearance, clearance);
  learner.phase = agent(row).mission.phase();
  turn_to_leg(row);
}

void FleetEnvironment::decide_end() {
  const bool has_collided = options_.end_on_collision &&
                            std::ranges::any_of(learners_, [](const Learner& l) { return l.collided; });
  const bool all_arrived =
      std::ranges::all_of(learners_, [](const Learner& l) { return l.phase == Phase::arrived; });
  const bool none_goes_on = std::ranges::all_of(
      learners_, [](const Learner& l) { return l.phase == Phase::arrived || l.phase == Phase::stuck; });
  const bool time_is_up = simulation_->is_done() || count(simulation_->tick()) >= last_tick_;
  terminated_ = has_collided || all_arrived;
  truncated_ = !terminated_ && (none_goes_on || time_is_up);
}

void FleetEnvironment::observe(std::size_t row, std::span<float> numbers) const {
  const Agent& seen_by = agent(row);
  const Leg* leg = seen_by.mission.leg();
  const bool avoids = is_avoiding(seen_by.mission.phase());
  Sight sight{.own = seen_by.own, .goal = {.position = seen_by.own.position}, .tracks = {}, .obstacles = {}};
  if (leg != nullptr) sight.goal = {.position = leg->position, .cruise_speed = leg->speed_mps};
  if (avoids) {
    const Simulation::Sight& seen = simulation_->sight(places_[row].agent);
    sight.tracks = seen.tracks;
    sight.obstacles = seen.obstacles;
  }
  environment::observe(options_.observation, sight, numbers);
}

std::optional<Situation> FleetEnvironment::situation(std::size_t row) const {
  if (!simulation_ || !is_deciding(row)) return {};
  return simulation_->situation(places_[row].agent);
}

void FleetEnvironment::advise(std::span<Command> commands) {
  if (!has_begun()) throw std::logic_error("no episode has begun: reset() begins one");
  if (advisers_.empty()) {
    for (std::size_t row = 0; row < places_.size(); ++row) advisers_.push_back(agent(row).avoider);
  }
  for (std::size_t row = 0; row < places_.size(); ++row) {
    const std::optional<Situation> shown = situation(row);
    commands[row] = shown ? advisers_[row].decide(*shown) : Command{.mode = Mode::hold};
  }
}

void FleetEnvironment::advise(std::span<double> actions) {
  advise(std::span{advice_});
  for (std::size_t row = 0; row < places_.size(); ++row) {
    const Command& command = advice_[row];
    if (!velocity_says_all(agent(row), command)) {
      throw InputError("the avoider of " + options_.learners[row] + " commands a " +
                       (command.turn_rate ? "turn rate" : "heading") +
                       ", which no action says: take advised_commands() instead");
    }
    Vec3 advised = to_axes(options_.observation.axes, agent(row).own.yaw, action_of(command).velocity);
    const double full = learners_[row].max_speed;
    if (options_.scaled_actions) advised = full > 0.0 ? Vec3{advised / full} : Vec3{Vec3::Zero()};
    for (int axis = 0; axis < 3; ++axis) actions[3 * row + static_cast<std::size_t>(axis)] = advised[axis];
  }
}

}  // namespace fairway::environment
