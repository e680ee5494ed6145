// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/measures.hpp"

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "fairway/experiment/executor.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/sim/simulation.hpp"
#include "fairway/studies/uuv/timeline.hpp"

namespace fairway::uuv {
namespace {

/// One vehicle's quantities by name.
using Quantities = std::map<std::string_view, double>;

std::vector<Quantities> by_vehicle(const std::vector<Measure>& measures, std::size_t count) {
  std::vector<Quantities> vehicles(count);
  for (const Measure& measure : measures) {
    if (measure.vehicle >= 0)
      vehicles[static_cast<std::size_t>(measure.vehicle)][measure.quantity] = measure.value;
  }
  return vehicles;
}

}  // namespace

std::vector<Measure> measure_encounter(const Scenario& scenario, const Catalogs& catalogs,
                                       const std::atomic<bool>* stop) {
  Simulation simulation{scenario, catalogs};
  RunMetrics metrics = metrics_for(scenario);
  Timeline timeline{scenario};
  const std::array<FrameSink*, 2> sinks{&metrics, &timeline};
  while (!simulation.is_done()) {
    if (stop != nullptr && stop->load(std::memory_order_relaxed)) throw RunAbandoned{};
    simulation.step(sinks);
  }
  std::vector<Measure> measures = metrics.measures();
  timeline.report(measures);
  return measures;
}

std::vector<Measure> measure_fleet(const Scenario& scenario, const Catalogs& catalogs,
                                   const std::atomic<bool>* stop) {
  const std::vector<Measure> all = measure_run(scenario, catalogs, stop);
  std::vector<Measure> kept;
  for (const Measure& measure : all) {
    if (measure.vehicle == Measure::fleet) kept.push_back(measure);
  }

  const std::size_t count = scenario.vehicles.size();
  const std::vector<Quantities> vehicles = by_vehicle(all, count);
  double time = 0.0, ratio = 0.0, turned = 0.0, infeasible = 0.0, arrived = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Quantities& own = vehicles[i];
    turned += own.at("heading_change_rad");
    infeasible += own.at("infeasible_count");
    if (own.at("stuck_count") > 0.0) continue;
    arrived += 1.0;
    time += own.at("navigation_time_s");
    const double straight = own.at("start_distance_m") / scenario.vehicles[i].mission.back().speed_mps;
    ratio += own.at("navigation_time_s") / straight;
  }
  const auto add = [&](const char* quantity, double value) {
    kept.push_back({quantity, Measure::fleet, value});
  };
  if (arrived > 0.0) {
    add("mean_time_s", time / arrived);
    add("time_ratio", ratio / arrived);
  }
  add("mean_heading_change_rad", turned / static_cast<double>(count));
  add("mean_infeasible_count", infeasible / static_cast<double>(count));
  return kept;
}

}  // namespace fairway::uuv
