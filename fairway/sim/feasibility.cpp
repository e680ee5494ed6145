// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/feasibility.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

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
  refuse_depth(spec.start_where, path + ".start.position_m", info, spec.position.z());
  for (std::size_t i = 0; i < spec.mission.size(); ++i) {
    const Leg& leg = spec.mission[i];
    if (leg.kind == LegKind::rendezvous || leg.kind == LegKind::keep_position) continue;
    const Location& where = i < spec.mission_where.size() ? spec.mission_where[i] : spec.model.where;
    const std::string kind{enum_name(leg.kind)};
    const std::string place = path + ".mission[" + std::to_string(i) + "]." + kind;
    const bool is_section = leg.kind == LegKind::section;
    if (is_section) refuse_depth(where, place + ".from_m", info, leg.from.z());
    refuse_depth(where, place + (is_section ? ".to_m" : ".position_m"), info, leg.position.z());
  }
  if (spec.limits.min_depth <= 0.0 && spec.limits.max_depth >= 0.0) return;
  const bool sunk = spec.limits.min_depth > 0.0;
  refuse(spec.limits_where, path + ".limits." + (sunk ? "min_depth_m" : "max_depth_m"),
         std::string(info.name) + " lives on the surface, at depth 0, which " +
             number_text(sunk ? spec.limits.min_depth : spec.limits.max_depth) + " leaves out");
}

// ---- how long a step may be

/// The largest number of two digits that is not above it.
double rounded_down(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::floor(value / unit * (1.0 + 1e-12)) * unit;
}

[[noreturn]] void refuse_step(const Scenario& scenario, std::size_t index, const std::string& reason,
                              double longest) {
  const VehicleSpec& spec = scenario.vehicles[index];
  const bool is_written = !scenario.step_where.file.empty();
  refuse(is_written ? scenario.step_where : spec.model.where, "step_s",
         number_text(scenario.step_s) + " is too long for " + spec.name + " (" + spec.model.name +
             "): " + reason + "; at most " + number_text(rounded_down(longest)) + " would do");
}

/// Steps are this share of what the linearised motion allows: waves, turns and a hard start quicken it. An
/// otter_by_thrust breaks at 0.82 of it where it is dropped into waves of 0.5 m.
constexpr double margin = 0.75;

void check_motion(const Scenario& scenario, std::size_t index, const Agent& agent, const VehicleState& x,
                  const ActuatorValues& u, const Water& water, std::string_view when) {
  const std::optional<StepLimit> limit = step_limit(agent.vehicle, x, u, water, scenario.step_s / margin);
  if (!limit) return;
  refuse_step(scenario, index,
              "its " + std::string(limit->mode.axis) + " mode " + std::string(when) + ", " +
                  text_of(limit->mode) + ", would grow",
              margin * limit->step_s);
}

/// Of the currents of a scenario together, all but never exceeded [m/s].
double fastest_current(const WaterSpec& water) {
  double speed = water.current_n.norm();
  if (const auto& sheared = water.current.sheared) {
    double fastest = 0.0;
    for (const ProfilePoint& point : sheared->profile)
      fastest = std::fmax(fastest, std::abs(point.speed_mps));
    speed += fastest;
  }
  if (const auto& wandering = water.current.gauss_markov) {
    const double reached = std::abs(wandering->mean_speed_mps) + 3.0 * wandering->deviation_mps;
    speed += std::fmin(reached, std::fmax(std::abs(wandering->min_speed_mps), wandering->max_speed_mps));
  }
  return speed;
}

/// How any vehicle moves now and then, in all directions but ahead: as in a turn, or a small sea.
constexpr double swaying_mps = 0.2;
constexpr double swaying_radps = 0.2;

/// Looks at it at rest, as it sways and turns, and as fast as it can, in still water, and tells how fast that
/// is; infinite where nobody knows.
double check_own_motion(const Scenario& scenario, std::size_t index, const Agent& agent) {
  const Water still{.density = scenario.water.density_kgpm3};
  VehicleState rest;
  rest.p_n.z() = scenario.vehicles[index].position.z();
  check_motion(scenario, index, agent, rest, agent.vehicle.actuator_state(), still, "at rest");

  // what is damped by the square of its motion is not damped at rest
  VehicleState swayed = rest;
  swayed.v_b = {0.0, std::fmax(swaying_mps, fastest_current(scenario.water)), swaying_mps};
  swayed.omega_b = Vec3::Constant(swaying_radps);
  check_motion(scenario, index, agent, swayed, agent.vehicle.actuator_state(), still,
               "as it sways and turns");

  Vehicle vehicle = agent.vehicle;
  Autopilot autopilot = agent.autopilot;
  vehicle.set_actuator_state(
      autopilot.control({.surge_mps = 1e3}, Vec3::Zero(), Vec3::Zero(), scenario.step_s));
  const ActuatorValues& ahead = vehicle.actuator_state();
  const std::optional<VehicleState> steady = steady_state(vehicle, rest, ahead, still);
  if (!steady) return std::numeric_limits<double>::infinity();
  check_motion(scenario, index, agent, *steady, ahead, still, "at full speed");
  return steady->v_b.norm();
}

/// A hull's forces are known about as fast as it goes by itself; far beyond, its model may do anything.
constexpr double model_reach_ratio = 2.0;
constexpr double model_reach_mps = 3.0;  // at least

void check_speed(const Scenario& scenario, std::size_t index, const Agent& agent, double fastest) {
  if (agent.vehicle.propulsion() == nullptr && agent.vehicle.fin_drive() == nullptr) return;
  const VehicleSpec& spec = scenario.vehicles[index];
  const double current = fastest_current(scenario.water);
  const double reach = std::fmax(model_reach_mps, model_reach_ratio * fastest);
  if (std::abs(spec.speed) + current <= reach) return;
  refuse(spec.start_where, vehicle_path(index) + ".start",
         spec.model.name + " starts at " + number_text(spec.speed) + " m/s in currents of up to " +
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

    auto seen = judged.begin();
    while (seen != judged.end() && !same_model(*seen->model, model)) ++seen;
    if (seen == judged.end()) {
      const double fastest = check_own_motion(scenario, i, agent);
      seen = judged.insert(seen, Judged{&model, fastest, 0.0});
    }
    check_speed(scenario, i, agent, seen->fastest);
    if (speed <= seen->speed) continue;
    seen->speed = speed;
    check_motion(scenario, i, agent, x, agent.vehicle.actuator_state(), water, "at its start");
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
