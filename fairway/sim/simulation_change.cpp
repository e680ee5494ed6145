// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <sstream>

#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

bool is_same_method(const VehicleSpec& a, const VehicleSpec& b) {
  return is_same(a.avoider, b.avoider) && a.tracking == b.tracking && a.limits == b.limits;
}

/// `changed` with everything that a run may change on its way as it was `before`.
Scenario with_what_may_change(Scenario changed, const Scenario& before) {
  changed.duration_s = before.duration_s;
  changed.exchange = before.exchange;
  changed.expect = before.expect;
  for (std::size_t i = 0; i < std::min(changed.vehicles.size(), before.vehicles.size()); ++i) {
    VehicleSpec& vehicle = changed.vehicles[i];
    const VehicleSpec& was = before.vehicles[i];
    vehicle.avoider = was.avoider;
    vehicle.tracking = was.tracking;
    vehicle.limits = was.limits;
    for (std::size_t k = 0; k < std::min(vehicle.mission.size(), was.mission.size()); ++k)
      if (vehicle.mission[k].kind == was.mission[k].kind) vehicle.mission[k] = was.mission[k];
  }
  return changed;
}

/// What else differs is found where both are written out.
void refuse_what_may_not_change(const Scenario& before, const Scenario& changed) {
  std::istringstream was{to_yaml(before)}, is{to_yaml(with_what_may_change(changed, before))};
  std::string line_before, line;
  while (true) {
    const bool more_before = static_cast<bool>(std::getline(was, line_before));
    const bool more = static_cast<bool>(std::getline(is, line));
    if (!more_before && !more) return;
    if (more_before == more && line_before == line) continue;
    const std::string& shown = more ? line : line_before;
    throw InputError(
        "a run can change methods, limits, goals, the exchange and its duration on its way, and not: " +
        shown.substr(std::min(shown.find_first_not_of(" -"), shown.size())));
  }
}

}  // namespace

void Simulation::change(const Scenario& before, const Scenario& changed, const Catalogs& catalogs) {
  refuse_what_may_not_change(before, changed);
  Simulation fresh{changed, catalogs};
  last_tick_ = fresh.last_tick_;
  if (!is_same(before.exchange, changed.exchange)) {
    exchange_ = std::move(fresh.exchange_);
    movers_ = std::move(fresh.movers_);
    places_ = std::move(fresh.places_);
  }
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    Agent& agent = agents_[i];
    const VehicleSpec &was = before.vehicles[i], &is = changed.vehicles[i];
    // where nothing else limits it, a mission limits who is foreseen
    if (!is_same_method(was, is) || agent.ship().limits != fresh.agents_[i].ship().limits) {
      agent.avoider = std::move(fresh.agents_[i].avoider);
      agent.pilot = std::move(fresh.agents_[i].pilot);
      agent.agrees = false;
      if (!drawings_.empty()) drawings_[i].clear();
    }
    if (was.mission != is.mission) {
      agent.mission.change(is.mission, agent.own, time());
      agent.pilot.ask_at_once();
    }
  }

  // for how many room is made is a matter of the methods
  for (Hand& hand : hands_) hand.near = {};
}

}  // namespace fairway
