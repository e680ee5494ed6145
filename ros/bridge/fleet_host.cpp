// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/fleet_host.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <sstream>

#include "fairway/cli/outcome.hpp"
#include "fairway/core/math.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/recording_info.hpp"
#include "fairway/record/recording_writer.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"
#include "fairway/view/film_events.hpp"
#include "fairway/view/scene_hull.hpp"
#include "ros/bridge/avoider_parts.hpp"

namespace fairway::bridge {
namespace {

Motion motion_of(const VehicleState& x, double time) {
  return {time,
          triple_of(x.p_n),
          {x.q_nb.w(), x.q_nb.x(), x.q_nb.y(), x.q_nb.z()},
          triple_of(x.v_b),
          triple_of(x.omega_b)};
}

/// Below everything that a vehicle is sent to, so that a wall is seen beside all of them. [m]
double depth_of(const Scenario& scenario) {
  double depth = 0.0;
  for (const VehicleSpec& vehicle : scenario.vehicles) {
    depth = math::fmax(depth, vehicle.position.z());
    for (const Leg& leg : vehicle.mission) depth = math::fmax(depth, leg.position.z());
  }
  return depth + 2.0;
}

/// The side of a prism between two points of its outline, as two triangles.
void add_wall(std::vector<Triple>& triangles, const Vec3& a, const Vec3& b, double depth) {
  const Triple upper_a{a.x(), a.y(), 0.0}, upper_b{b.x(), b.y(), 0.0};
  const Triple lower_a{a.x(), a.y(), depth}, lower_b{b.x(), b.y(), depth};
  triangles.insert(triangles.end(), {upper_a, upper_b, lower_b, upper_a, lower_b, lower_a});
}

Mark mark_of(const ObstacleSpec& spec, double time, double depth) {
  Mark mark;
  mark.meaning = spec.charted ? "obstacle" : "obstacle that is not charted";
  mark.colour = {0.45F, 0.42F, 0.38F, spec.charted ? 1.0F : 0.6F};
  switch (spec.kind) {
    case Obstacle::Kind::sphere:
      mark.kind = Mark::Kind::sphere;
      mark.points = {triple_of(spec.position + time * spec.velocity)};
      mark.radius = spec.radius;
      break;
    case Obstacle::Kind::segment:
      mark.kind = Mark::Kind::triangles;
      add_wall(mark.points, spec.from, spec.to, depth);
      break;
    case Obstacle::Kind::polygon:
      mark.kind = Mark::Kind::triangles;
      for (std::size_t i = 0; i < spec.vertices.size(); ++i)
        add_wall(mark.points, spec.vertices[i], spec.vertices[(i + 1) % spec.vertices.size()], depth);
      break;
  }
  return mark;
}

Scenario accepted(const FleetOptions& options) {
  Scenario scenario = load_scenario(options.scenario, options.overrides, options.seed);
  cli::check_expectations(scenario);
  if (!(options.command_timeout_s > 0.0)) {
    throw InputError(
        fmt::format("command_timeout_s: {}: expected a number above 0 [s]", options.command_timeout_s));
  }
  return scenario;
}

}  // namespace

struct FleetHost::Self {
  explicit Self(const FleetOptions& options)
      : scenario{accepted(options)},
        simulation{scenario, builtin_catalogs()},
        metrics{metrics_for(scenario)},
        events{{scenario.exam.crit_dist_m, scenario.exam.safety_distance_m}, scenario.vehicles.size()},
        sinks{&metrics, &events.sink},
        told(scenario.vehicles.size()),
        vehicles(scenario.vehicles.size()),
        timeout{options.command_timeout_s},
        depth{depth_of(scenario)},
        autonomous{options.autonomous} {
    const RecordingInfo info = recording_info(scenario);
    check_outputs(std::array{Output{"record", options.record, recording_file}}, std::array{options.scenario},
                  false);
    if (!options.record.empty()) {
      writer = std::make_unique<RecordingWriter>(options.record, info);
      sinks.push_back(writer.get());
    }
    const std::vector<std::string> topics = topic_names(info.vehicles);
    for (std::size_t i = 0; i < vehicles.size(); ++i) {
      const VehicleSpec& spec = scenario.vehicles[i];
      const Hull hull = hull_of(spec);
      FleetVehicle& vehicle = vehicles[i];
      vehicle.name = spec.name;
      vehicle.topic = topics[i];
      vehicle.shape = hull.shape;
      vehicle.length_m = hull.length;
      vehicle.beam_m = hull.beam;
    }
    if (autonomous) simulation.time_decisions();
    done = simulation.is_done();
    look();
  }

  void look();
  void watch(std::size_t index);
  void hold(std::size_t index) { simulation.order(index, Command{.mode = Mode::hold}); }
  cli::RunOutcome outcome(double wall_s) const;
  std::vector<cli::Judgement> judgements() const { return cli::judge(scenario, outcome(0.0).measures); }

  /// The film's events as a sink of frames.
  struct Events {
    Events(EncounterRules rules, std::size_t vehicles) : film{rules, vehicles}, sink{film} {}
    FilmEvents film;
    struct Sink final : FrameSink {
      explicit Sink(FilmEvents& its_film) : film{its_film} {}
      void write(const fairway::Frame& frame) override { film.see(frame); }
      FilmEvents& film;
    } sink;
  };

  Scenario scenario;
  Simulation simulation;
  RunMetrics metrics;
  Events events;
  std::unique_ptr<RecordingWriter> writer;
  std::vector<FrameSink*> sinks;
  std::vector<std::optional<double>> told;  // when each was last commanded; none: it holds
  std::vector<FleetVehicle> vehicles;
  double timeout;
  double depth;
  bool autonomous;
  bool done{};
};

void FleetHost::Self::look() {
  if (simulation.divergence()) return;  // the last instant that was whole stays to be seen
  simulation.look();
  for (std::size_t i = 0; i < vehicles.size(); ++i) watch(i);
}

void FleetHost::Self::watch(std::size_t index) {
  const Agent& agent = simulation.agents()[index];
  const Phase phase = agent.mission.phase();
  const Leg* leg = agent.mission.leg();
  FleetVehicle& vehicle = vehicles[index];
  vehicle.truth = motion_of(agent.vehicle.state(), simulation.time());
  vehicle.estimate = motion_of(agent.estimate(), simulation.time());
  vehicle.estimate.position_sigma = agent.own.position_sigma;
  vehicle.phase = enum_name(phase);
  vehicle.wants_command = is_avoiding(phase);
  vehicle.alert = static_cast<Alert>(events.film.alerts()[index]);
  vehicle.goal_n.reset();
  if (vehicle.wants_command) vehicle.goal_n = triple_of(leg->position);
  if (autonomous) return;

  // a tick late is late; rounding is not
  const double tolerance = 0.01 * scenario.step_s;
  std::optional<double>& last = told[index];
  if (!vehicle.wants_command || (last && simulation.time() - *last > timeout + tolerance)) last.reset();
  if (!last) hold(index);
  vehicle.holding = vehicle.wants_command && !last;
}

cli::RunOutcome FleetHost::Self::outcome(double wall_s) const {
  cli::RunOutcome outcome;
  outcome.divergence = simulation.divergence();
  if (!outcome.divergence) outcome.measures = metrics.measures();
  if (autonomous) outcome.decisions = simulation.decision_times();
  for (const Agent& agent : simulation.agents()) {
    if (!agent.note.empty()) outcome.notes.emplace_back(agent.ship().name, std::string(agent.note));
  }
  outcome.simulated_s = simulation.time();
  if (!outcome.divergence && outcome.simulated_s > 0.0)
    outcome.no_progress = cli::no_progress_at_end(scenario, metrics.progress());
  outcome.wall_s = wall_s;
  return outcome;
}

FleetHost::FleetHost(const FleetOptions& options) : self_{std::make_unique<Self>(options)} {}
FleetHost::FleetHost(FleetHost&&) noexcept = default;
FleetHost& FleetHost::operator=(FleetHost&&) noexcept = default;
FleetHost::~FleetHost() = default;

std::size_t FleetHost::size() const { return self_->vehicles.size(); }
double FleetHost::step_period() const { return self_->scenario.step_s; }
double FleetHost::time() const { return self_->simulation.time(); }
double FleetHost::duration() const { return self_->scenario.duration_s; }
bool FleetHost::is_done() const { return self_->done; }
std::string FleetHost::name() const { return self_->scenario.name; }
double FleetHost::crit_dist_m() const { return self_->scenario.exam.crit_dist_m; }
double FleetHost::safety_distance_m() const { return self_->scenario.exam.safety_distance_m; }
const FleetVehicle& FleetHost::vehicle(std::size_t index) const { return self_->vehicles[index]; }

bool FleetHost::command(std::size_t index, const BodyVelocity& over_ground) {
  Self& self = *self_;
  FleetVehicle& vehicle = self.vehicles[index];
  if (self.autonomous || !vehicle.wants_command || !is_finite(over_ground)) return false;
  const BodyRequest request{.surge_mps = over_ground.surge_mps,
                            .sway_mps = over_ground.sway_mps,
                            .heave_mps = over_ground.heave_mps,
                            .yaw_rate_radps = over_ground.yaw_rate_radps};
  Vec3 velocity{request.surge_mps, request.sway_mps, request.heave_mps};
  velocity.head<2>() = turned(velocity.head<2>(), self.simulation.agents()[index].own.yaw);
  self.simulation.order(index, {.velocity = velocity}, request);
  self.told[index] = time();
  vehicle.holding = false;
  return true;
}

void FleetHost::step() {
  Self& self = *self_;
  self.simulation.act(self.sinks);
  self.done = self.simulation.is_done();
  self.look();
}

std::vector<Mark> FleetHost::obstacles() const {
  std::vector<Mark> marks;
  for (const ObstacleSpec& spec : self_->scenario.obstacles)
    marks.push_back(mark_of(spec, time(), self_->depth));
  return marks;
}

std::string FleetHost::summary_json() const {
  return cli::document_of(self_->scenario, self_->outcome(0.0), self_->judgements()).dump(2);
}

std::string FleetHost::summary(double wall_s) const {
  std::ostringstream text;
  cli::print(self_->scenario, self_->outcome(wall_s), self_->judgements(), text);
  return text.str();
}

int FleetHost::collisions() const {
  const std::vector<Measure> measures = self_->metrics.measures();
  const auto count = std::ranges::find(measures, "pair_collision_count", &Measure::quantity);
  return count == measures.end() ? 0 : static_cast<int>(count->value);
}

bool FleetHost::expectations_kept() const {
  return !self_->simulation.divergence() && std::ranges::all_of(self_->judgements(), &cli::Judgement::kept);
}

void FleetHost::finish() {
  if (!self_->writer) return;
  const cli::RunOutcome outcome = self_->outcome(0.0);
  self_->writer->close(
      {.divergence = cli::divergence_text(self_->scenario, outcome), .stopped = !self_->done});
}

}  // namespace fairway::bridge
