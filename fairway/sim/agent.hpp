// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/control/autopilot.hpp"
#include "fairway/control/guidance.hpp"
#include "fairway/control/mission.hpp"
#include "fairway/control/onboard_model.hpp"
#include "fairway/control/steering.hpp"
#include "fairway/core/tick.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/catalogs.hpp"

namespace fairway {

/// One simulated vehicle with all that is on board. A value: a copy is a snapshot.
struct Agent {
  // constants
  VehicleId id{};
  std::string name;
  double radius{};
  double start_delay{};
  std::int32_t own_priority{};
  Limits limits;
  SteeringParams steering;
  std::optional<OnboardModel> model;  ///< of its dynamics, as known on board

  // what moves and remembers
  Vehicle vehicle;
  Autopilot autopilot;
  Mission mission;
  Avoider avoider;

  Tick next_decision{0};  ///< of the avoider

  // this tick's values
  Ownship own;
  std::vector<Track> tracks;
  std::vector<Obstacle> obstacles;  ///< as far as it knows of them
  Command command;
  HoldPoint hold;
  bool holding{false};
  std::string_view note;  ///< of the last command that had one
  ActuatorValues demand;
};

/// An agent as its spec describes it, its avoider's randomness drawn from `rng`. Throws InputError,
/// with the place in the file, where a catalog does not know a name or refuses a parameter.
Agent make_agent(const VehicleSpec& spec, const Scenario& scenario, const Catalogs& catalogs, Rng rng);

}  // namespace fairway
