// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/feasibility.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "fairway/core/math.hpp"
#include "fairway/core/text.hpp"
#include "fairway/sim/stability.hpp"

namespace fairway {
namespace {

std::string vehicle_path(std::size_t index) { return "vehicles[" + std::to_string(index) + "]"; }

/// What was set from the command line names its own path, which is then not said twice.
[[noreturn]] void refuse(const Location& where, const std::string& path, const std::string& message) {
  throw InputError(where, where.file == "--set " + path ? "" : path, message);
}

// ---- where a vehicle may be

void refuse_depth(const Location& where, const std::string& path, const VehicleInfo& info, double depth) {
  if (depth == 0.0) return;
  refuse(where, path,
         std::string(info.name) + " lives on the surface: expected depth 0, got " + number_text(depth));
}

void check_depths(const VehicleSpec& spec, std::size_t index, const VehicleInfo& info) {
  const std::string path = vehicle_path(index);
  refuse_depth(spec.where->start, path + ".start.position_m", info, spec.position.z());
  for (std::size_t i = 0; i < spec.mission.size(); ++i) {
    const Leg& leg = spec.mission[i];
    if (leg.kind == LegKind::rendezvous || leg.kind == LegKind::keep_position) continue;
    const Location& where = i < spec.where->mission.size() ? spec.where->mission[i] : spec.model->where;
    const std::string kind{enum_name(leg.kind)};
    const std::string place = path + ".mission[" + std::to_string(i) + "]." + kind;
    const bool is_section = leg.kind == LegKind::section;
    if (is_section) refuse_depth(where, place + ".from_m", info, leg.from.z());
    refuse_depth(where, place + (is_section ? ".to_m" : ".position_m"), info, leg.position.z());
  }
  if (spec.limits.min_depth <= 0.0 && spec.limits.max_depth >= 0.0) return;
  const bool sunk = spec.limits.min_depth > 0.0;
  refuse(spec.where->limits, path + ".limits." + (sunk ? "min_depth_m" : "max_depth_m"),
         std::string(info.name) + " lives on the surface, at depth 0, which " +
             number_text(sunk ? spec.limits.min_depth : spec.limits.max_depth) + " leaves out");
}

// ---- how long a step may be

/// The largest number of two digits that is not above it.
double rounded_down(double value) {
  double scale = 1.0;
  while (value > 0.0 && value * scale < 10.0) scale *= 10.0;
  while (value * scale >= 100.0 && scale > 0.0) scale /= 10.0;
  return std::floor(value * scale * (1.0 + 1e-12)) / scale;
}

/// Steps are this share of what the linearised motion allows: waves, turns and a hard start quicken it. An
/// otter_by_thrust breaks at 0.82 of it where it is dropped into waves of 0.5 m.
constexpr double margin = 0.75;

/// The shortest of the steps that a vehicle's motions allow, where the scenario's is too long.
class ShortestStep {
 public:
  ShortestStep(const Scenario& scenario, std::size_t index, const Agent& agent)
      : scenario_{scenario}, spec_{scenario.vehicles[index]}, agent_{agent} {}

  void hold_against(const VehicleState& x, const ActuatorValues& u, const Water& water,
                    std::string_view when) {
    const double step = limit_ ? limit_->step_s : scenario_.step_s / margin;
    const std::optional<StepLimit> limit = step_limit(agent_.vehicle, x, u, water, step);
    if (!limit) return;
    limit_ = limit;
    when_ = when;
  }

  void refuse_if_too_long() const {
    if (!limit_) return;
    const bool is_written = !scenario_.step_where.file.empty();
    refuse(is_written ? scenario_.step_where : spec_.model->where, "step_s",
           number_text(scenario_.step_s) + " is too long for " + spec_.name + " (" + spec_.model->name +
               "): its " + std::string(limit_->mode.axis) + " mode " + std::string(when_) + ", " +
               text_of(limit_->mode) + ", would grow; at most " +
               number_text(rounded_down(margin * limit_->step_s)) + " would do");
  }

 private:
  const Scenario& scenario_;
  const VehicleSpec& spec_;
  const Agent& agent_;
  std::optional<StepLimit> limit_;
  std::string_view when_;
};

/// A speed that the currents of a scenario together hardly ever exceed [m/s].
double fastest_current(const WaterSpec& water) {
  double speed = water.current_n.norm();
  if (const auto& sheared = water.current.sheared) {
    double fastest = 0.0;
    for (const ProfilePoint& point : sheared->profile)
      fastest = math::fmax(fastest, std::abs(point.speed_mps));
    speed += fastest;
  }
  if (const auto& wandering = water.current.gauss_markov) {
    const double reached = std::abs(wandering->mean_speed_mps) + 3.0 * wandering->deviation_mps;
    speed += math::fmin(reached, math::fmax(std::abs(wandering->min_speed_mps), wandering->max_speed_mps));
  }
  return speed;
}

/// How any vehicle moves now and then, in all directions but ahead: as in a turn, or a small sea.
constexpr double swaying_mps = 0.2;
constexpr double swaying_radps = 0.2;

/// Looks at it at rest, as it sways and turns, and as fast as it can, in still water, and tells how fast that
/// is; infinite where nobody knows.
double look_at_own_motion(const Scenario& scenario, const Agent& agent, ShortestStep& shortest) {
  const Water still{.density = scenario.water.density_kgpm3};
  VehicleState rest;
  rest.p_n.z() = agent.vehicle.state().p_n.z();
  shortest.hold_against(rest, agent.vehicle.actuator_state(), still, "at rest");

  // what is damped by the square of its motion is not damped at rest
  VehicleState swayed = rest;
  swayed.v_b = {0.0, math::fmax(swaying_mps, fastest_current(scenario.water)), swaying_mps};
  swayed.omega_b = Vec3::Constant(swaying_radps);
  shortest.hold_against(swayed, agent.vehicle.actuator_state(), still, "as it sways and turns");

  Vehicle vehicle = agent.vehicle;
  Autopilot autopilot = agent.autopilot;
  vehicle.set_actuator_state(
      autopilot.control({.surge_mps = 1e3}, Vec3::Zero(), Vec3::Zero(), scenario.step_s));
  const ActuatorValues ahead = vehicle.actuator_state();
  const std::optional<VehicleState> steady = steady_state(vehicle, rest, ahead, still);
  if (!steady) return std::numeric_limits<double>::infinity();
  shortest.hold_against(*steady, ahead, still, "at full speed");
  return steady->v_b.norm();
}

/// A hull's forces are known about as fast as it goes by itself; far beyond, its model may do anything.
constexpr double model_reach_ratio = 2.0;
constexpr double model_reach_mps = 3.0;  // at least

void check_speed(const Scenario& scenario, std::size_t index, const Agent& agent, double fastest) {
  if (agent.vehicle.propulsion() == nullptr && agent.vehicle.fin_drive() == nullptr) return;
  const VehicleSpec& spec = scenario.vehicles[index];
  const double current = fastest_current(scenario.water);
  const double reach = math::fmax(model_reach_mps, model_reach_ratio * fastest);
  if (std::abs(spec.speed) + current <= reach) return;
  refuse(spec.where->start, vehicle_path(index) + ".start",
         spec.model->name + " starts at " + number_text(spec.speed) + " m/s in currents of up to " +
             number_text(current) + " m/s; its model holds up to " + number_text(rounded_down(reach)) +
             " m/s through the water together");
}

/// What was looked at already.
struct Judged {
  const Choice* model{};
  double fastest{};  // ahead through the water
  double speed{};    // through the water, at the start
};

bool same_model(const Choice& a, const Choice& b) { return a.name == b.name && a.params == b.params; }

void check_steps(const Scenario& scenario, std::span<const Agent> agents, const Sea& sea) {
  std::vector<Judged> judged;
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const Agent& agent = agents[i];
    const Choice& model = scenario.vehicles[i].model;
    const VehicleState& x = agent.vehicle.state();
    const Water water = sea.water_at(x.p_n, 0.0);
    const double speed = (x.v_n() - water.current_n).norm();

    ShortestStep shortest{scenario, i, agent};
    auto seen = judged.begin();
    while (seen != judged.end() && !same_model(*seen->model, model)) ++seen;
    if (seen == judged.end()) {
      const double fastest = look_at_own_motion(scenario, agent, shortest);
      seen = judged.insert(seen, Judged{&model, fastest, 0.0});
    }
    check_speed(scenario, i, agent, seen->fastest);
    if (speed > seen->speed) shortest.hold_against(x, agent.vehicle.actuator_state(), water, "at its start");
    seen->speed = math::fmax(seen->speed, speed);
    shortest.refuse_if_too_long();
  }
}

}  // namespace

void check_feasible(const Scenario& scenario, std::span<const Agent> agents, const Sea& sea) {
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const VehicleInfo& info = agents[i].vehicle.info();
    if (info.floats) check_depths(scenario.vehicles[i], i, info);
  }
  check_steps(scenario, agents, sea);
}

}  // namespace fairway
