// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/agent.hpp"

#include <deque>
#include <mutex>

#include "fairway/control/envelope.hpp"
#include "fairway/control/onboard_model.hpp"
#include "fairway/control/vehicle_limits.hpp"
#include "fairway/core/envelope_numbers.hpp"
#include "fairway/sim/team.hpp"

namespace fairway {
namespace {

enum class AutopilotKind { velocity_controller };

}  // namespace

template <>
struct EnumNames<AutopilotKind> {
  static constexpr std::array names{"velocity_controller"};
};

namespace {

/// The refusal of a catalog, told with the place where the choice was written.
InputError located(const Choice& choice, const InputError& error) {
  const std::string message = error.what();
  for (std::size_t i = 0; i < choice.params.size(); ++i) {
    const std::string& param = choice.params[i].first;
    if (!message.starts_with(param + ":")) continue;
    const Location& where = i < choice.param_where.size() ? choice.param_where[i] : choice.where;
    return InputError(where, choice.path + "." + param, message.substr(param.size() + 2));
  }
  return InputError(choice.where, choice.path, message);
}

template <class Make>
auto made(const Choice& choice, Make make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw located(choice, error);
  }
}

/// `params` as chosen: the choice's name sets `name_param`, and its parameters set theirs.
template <Reflected P>
P chosen(const Choice& choice, std::string_view name_param, P params) {
  return made(choice, [&] {
    if (!choice.name.empty()) set_param(params, name_param, choice.name);
    return params_of(choice.params, params);
  });
}

struct AllocationParams {
  AllocationMethod method = AllocationMethod::bounded;
  static consteval auto fields() {
    return std::tuple{field<&AllocationParams::method>("how forces are shared out among the thrusters")};
  }
};

struct AutopilotParams : VelocityController::Params {
  AutopilotKind kind = AutopilotKind::velocity_controller;
  static consteval auto fields() {
    return std::tuple_cat(
        VelocityController::Params::fields(),
        std::tuple{field<&AutopilotParams::kind>("what drives the thrusters to a velocity")});
  }
};

/// Bandwidths are those of thrusters: whoever gives them to a vehicle without any is told so.
AutopilotParams autopilot_of(const VehicleSpec& spec, const Vehicle& vehicle) {
  const Choice& choice = spec.autopilot;
  const bool given = !choice.name.empty() || !choice.params.empty();
  if (given && vehicle.propulsion() == nullptr) {
    throw InputError(choice.where, choice.path,
                     spec.model->name + " has no thrusters that it could drive: leave it out");
  }
  return chosen(choice, "kind", AutopilotParams{});
}

SteeringParams steering_of(const VehicleSpec& spec, const Vehicle& vehicle) {
  SteeringParams params;
  const Propulsion* propulsion = vehicle.propulsion();
  if (const FinDrive* drive = vehicle.fin_drive()) {
    const FinAutopilot autopilot{*drive, vehicle.actuators()};
    params.kind = SteeringKind::crab;
    params.turn_gain_hz = autopilot.turn_gain();
    params.min_speed_mps = autopilot.steerage_way();
    params.circle_radius_m = 3.0 * autopilot.turning_radius(autopilot.steerage_way());
  } else if (propulsion == nullptr) {
    params.kind = SteeringKind::proportional;
  } else if (can_sway(*propulsion)) {
    params.kind = SteeringKind::holonomic;
    params.heading_rad = spec.yaw;
  }
  return chosen(spec.steering, "kind", params);
}

/// What the envelope of a vehicle depends on.
struct EnvelopeKey {
  const VehicleInfo* kind;  ///< a model's own: catalogs may have different ones under one name
  Choice model, autopilot, allocation;
  Limits limits;
  double step;

  bool operator==(const EnvelopeKey& other) const {
    return kind == other.kind && is_same(model, other.model) && is_same(autopilot, other.autopilot) &&
           is_same(allocation, other.allocation) && limits == other.limits && step == other.step;
  }
};

/// The envelope, measured once for all vehicles that are alike, in every run of a campaign.
std::optional<Envelope> known_envelope(const VehicleSpec& spec, const Vehicle& vehicle,
                                       const Autopilot& autopilot, const Limits& limits, double step) {
  static std::mutex one_at_a_time;
  static std::deque<std::pair<EnvelopeKey, std::optional<Envelope>>> known;
  constexpr std::size_t most_known = 64;
  const std::lock_guard lock{one_at_a_time};
  const EnvelopeKey key{&vehicle.info(), spec.model, spec.autopilot, spec.allocation, limits, step};
  const auto found =
      std::ranges::find(known, key, [](const auto& entry) -> const EnvelopeKey& { return entry.first; });
  if (found != known.end()) return found->second;
  if (known.size() == most_known) known.pop_front();
  return known.emplace_back(key, measured_envelope(vehicle, autopilot, limits, step)).second;
}

/// Nothing of an envelope that no method can reckon with. Throws InputError for a vehicle that would have to.
std::optional<Envelope> usable(const std::optional<Envelope>& measured, const VehicleSpec& spec,
                               const Limits& limits, const std::string& avoider) {
  if (!measured) return {};
  const std::string_view why = why_unusable(*measured);
  if (why.empty()) return measured;
  if (limits.sway) return {};
  throw InputError(spec.model->where, spec.model->path,
                   avoider + " cannot reckon with what it does within its limits: " + std::string(why));
}

/// Of a vehicle whose method foresees what it does: without a limit no faster than the fastest leg, with one
/// no faster than twice that. What a hull can do at several times its speed says nothing of what it does.
Limits limited_to(const std::vector<Leg>& mission, Limits limits) {
  double fastest = 0.0;
  for (const Leg& leg : mission)
    if (leg.kind != LegKind::keep_position) fastest = math::fmax(fastest, leg.speed_mps);
  if (fastest > 0.0)
    limits.max_speed = limits.max_speed < Limits::none ? std::min(limits.max_speed, 2.0 * fastest) : fastest;
  return limits;
}

Autopilot make_autopilot(const VehicleSpec& spec, const Vehicle& vehicle) {
  const AutopilotParams controller = autopilot_of(spec, vehicle);
  const AllocationMethod allocation = chosen(spec.allocation, "method", AllocationParams{}).method;
  return made(spec.model, [&] { return Autopilot{vehicle, controller, allocation}; });
}

VehicleState start_of(const VehicleSpec& spec) {
  VehicleState state;
  state.p_n = spec.position;
  state.q_nb = quaternion_of({.yaw = spec.yaw});
  state.v_b.x() = spec.speed;
  return state;
}

}  // namespace

Exchange make_exchange(const Scenario& scenario) {
  const Choice& exchange = scenario.exchange;
  return made(exchange, [&] {
    return Exchange{exchange.name, exchange.params, scenario.vehicles.size(), scenario.step_s,
                    Rng{scenario.seed}.stream("exchange")};
  });
}

Vehicle make_vehicle(const VehicleSpec& spec, const VehicleCatalog& vehicles) {
  return made(spec.model, [&] { return vehicles.make(spec.model->name, spec.model->params); });
}

std::string avoider_in_force(const VehicleSpec& spec, const Limits& limits,
                             std::span<const ObstacleSpec> obstacles, const Catalog& avoiders) {
  const std::string& name = spec.avoider->name;
  const bool is_automatic = spec.tracking == Tracking::automatic && !limits.sway;
  if (!is_automatic && spec.tracking != Tracking::trackable) return name;
  const bool is_guided = is_automatic && !std::ranges::all_of(obstacles, &ObstacleSpec::moves);
  return made(spec.avoider, [&] { return avoiders.tracked(is_guided ? avoiders.guided(name) : name); });
}

Avoider make_avoider(const VehicleSpec& spec, const Limits& limits, const Scenario& scenario,
                     const Catalog& avoiders) {
  const std::string name = avoider_in_force(spec, limits, scenario.obstacles, avoiders);
  return made(spec.avoider, [&] {
    return avoiders.make(name, avoider_params(spec, scenario, avoiders),
                         Rng{scenario.seed}.stream("avoider", spec.id));
  });
}

Particulars particulars_of(const VehicleSpec& spec, const Vehicle& vehicle, const Scenario& scenario,
                           const Catalog& avoiders) {
  Particulars ship{.id = VehicleId{spec.id},
                   .name = spec.name,
                   .radius = spec.radius_m,
                   .priority = spec.priority,
                   .limits = narrowed(spec.limits, vehicle),
                   .steering = steering_of(spec, vehicle),
                   .model = onboard_model(vehicle)};
  const std::string avoider = avoider_in_force(spec, ship.limits, scenario.obstacles, avoiders);
  const auto needs = [&](bool AlgorithmInfo::*what) {
    return made(spec.avoider, [&] { return avoiders.needs(avoider, what); });
  };
  if (!ship.limits->sway && needs(&AlgorithmInfo::follows) && !needs(&AlgorithmInfo::needs_link))
    ship.limits = limited_to(spec.mission, ship.limits);
  if (needs(&AlgorithmInfo::needs_envelope)) {
    const Autopilot autopilot = make_autopilot(spec, vehicle);
    ship.envelope = usable(known_envelope(spec, vehicle, autopilot, ship.limits, scenario.step_s), spec,
                           ship.limits, avoider);
  }
  return ship;
}

std::vector<Shared<Limits>> limits_in_force(const Scenario& scenario, const VehicleCatalog& vehicles) {
  std::vector<Shared<Limits>> limits;
  limits.reserve(scenario.vehicles.size());
  for (const VehicleSpec& spec : scenario.vehicles) {
    try {
      limits.push_back(narrowed(spec.limits, vehicles.make(spec.model->name, spec.model->params)));
    } catch (const InputError&) {
      limits.push_back(spec.limits);
    }
    if (limits.size() > 1) share_if_same(limits.back(), limits[limits.size() - 2]);
  }
  return limits;
}

bool is_same(const Choice& a, const Choice& b) { return a.name == b.name && a.params == b.params; }

Agent make_agent(const VehicleSpec& spec, const Scenario& scenario, const Catalogs& catalogs,
                 const Agent* alike) {
  const Rng rng{scenario.seed};
  const auto drawn_for = [&](std::string_view user) { return rng.stream(user, spec.id); };
  const PerceptionSpec& perception = scenario.perception;
  const std::size_t track_count = scenario.vehicles.size() + scenario.obstacles.size();
  Vehicle vehicle = alike != nullptr ? alike->vehicle : make_vehicle(spec, catalogs.vehicles);
  vehicle.prepare(scenario.step_s);
  vehicle.set_state(start_of(spec));
  Autopilot autopilot = alike != nullptr ? alike->autopilot : make_autopilot(spec, vehicle);
  Navigation navigation = made(scenario.navigation, [&] {
    return Navigation{scenario.navigation.name, scenario.navigation.params, drawn_for("navigation")};
  });
  Particulars ship = particulars_of(spec, vehicle, scenario, catalogs.avoiders);
  if (alike != nullptr) {
    share_if_same(ship.limits, alike->ship().limits);
    share_if_same(ship.steering, alike->ship().steering);
  }
  Avoider avoider = make_avoider(spec, ship.limits, scenario, catalogs.avoiders);
  Eigen::VectorXd demand = vehicle.actuator_state();

  return {.start_delay = spec.start_delay_s,
          .cooperative = spec.cooperative,
          .failure = spec.failure,
          .vehicle = vehicle,
          .pilot = Pilot{std::move(ship), scenario.steps_per_decision * scenario.step_s},
          .autopilot = std::move(autopilot),
          .mission = Mission{spec.mission, scenario.exam.time_coefficient_ratio},
          .avoider = std::move(avoider),
          .navigation = std::move(navigation),
          .lookout = made(perception.kind,
                          [&] {
                            return Lookout{perception.kind.name,
                                           perception.kind.params,
                                           {perception.range_m, perception.obstacle_range_m},
                                           track_count,
                                           drawn_for("perception")};
                          }),
          .demand = std::move(demand)};
}

}  // namespace fairway
