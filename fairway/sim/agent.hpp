// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/comms/exchange.hpp"
#include "fairway/control/autopilot.hpp"
#include "fairway/control/mission.hpp"
#include "fairway/control/pilot.hpp"
#include "fairway/perception/lookout.hpp"
#include "fairway/perception/navigation.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/catalogs.hpp"

namespace fairway {

/// One simulated vehicle with all that is on board. A value: a copy is a snapshot.
struct Agent {
  double start_delay{};
  bool cooperative{true};
  bool beyond_control{false};  ///< it goes on as it went
  bool agrees{false};          ///< its method would set out, at a rendezvous that asks it
  FailureSpec failure;
  double set_out{std::numeric_limits<double>::infinity()};  ///< on its first transit [s]

  // what moves and remembers
  Vehicle vehicle;
  Pilot pilot;
  Autopilot autopilot;
  Mission mission;
  Avoider avoider;
  Navigation navigation;
  Lookout lookout;

  // this tick's values
  Vec3 current = Vec3::Zero();  ///< of the water round it [m/s, NED]
  Ownship own;
  std::string_view note;   ///< of the last command that had one, or of the last one of a method that speaks
  Eigen::VectorXd demand;  ///< of the actuators

  const Particulars& ship() const { return pilot.ship(); }

  /// Where it believes to be. Valid until it moves.
  const VehicleState& estimate() const { return navigation.believed(vehicle.state()); }
  /// What it believes the current round it to be [m/s, NED].
  Vec3 estimated_current() const { return navigation.current(current); }

  /// Whether this has broken on board by `time` [s].
  bool has_failed(FailureKind kind, double time) const {
    return failure.kind == kind && time >= set_out + failure.under_way_s;
  }
};

/// The name of the avoider that a vehicle with these limits has among these obstacles: that of its spec, with
/// the wrappers that `VehicleSpec::tracking` asks for. Throws InputError for a name that the catalog does not
/// know. O(obstacles).
std::string avoider_in_force(const VehicleSpec& spec, const Limits& limits,
                             std::span<const ObstacleSpec> obstacles, const Catalog& avoiders);

/// The vehicle, the avoider and the particulars of a spec, each alone. `limits` are the particulars'. They
/// throw as `make_agent` does. The avoider's parameters are `avoider_params`.
Vehicle make_vehicle(const VehicleSpec& spec, const VehicleCatalog& vehicles);
Avoider make_avoider(const VehicleSpec& spec, const Limits& limits, const Scenario& scenario,
                     const Catalog& avoiders);
Particulars particulars_of(const VehicleSpec& spec, const Vehicle& vehicle, const Scenario& scenario,
                           const Catalog& avoiders);

/// Whether two choices make the same, wherever they were written.
bool is_same(const Choice& a, const Choice& b);

/// An agent as its spec describes it, everything random on board drawn from streams of the scenario's seed.
/// What it has in common with `alike`, if there is one, of the same model, allocation and autopilot, is in
/// memory once.
/// Throws InputError, with the place in the file, where a catalog does not know a name or refuses a
/// parameter, and where a method would have to reckon with a vehicle that can neither go sideways nor turn.
Agent make_agent(const VehicleSpec& spec, const Scenario& scenario, const Catalogs& catalogs,
                 const Agent* alike = nullptr);

/// What each vehicle of a scenario may and can do, as its agent is told. A model that the catalog does not
/// know or refuses is taken to be able to do anything: whoever simulates it refuses it.
std::vector<Shared<Limits>> limits_in_force(const Scenario& scenario, const VehicleCatalog& vehicles);

/// What the vehicles of a scenario hear of each other. Throws InputError likewise.
Exchange make_exchange(const Scenario& scenario);

}  // namespace fairway
