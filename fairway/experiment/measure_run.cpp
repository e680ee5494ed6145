// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/measure_run.hpp"

#include <algorithm>

#include "fairway/experiment/executor.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

bool keeps_pace(const VehicleSpec& spec, const Limits& limits, const WaterSpec& water) {
  const auto is_fast = [&](const Leg& leg) { return leg.speed_mps >= limits.max_speed; };
  return water.still() && std::ranges::all_of(spec.mission, is_fast);
}

}  // namespace

Surroundings surroundings_of(const Scenario& scenario, const VehicleCatalog& vehicles) {
  Surroundings surroundings;
  for (const ObstacleSpec& spec : scenario.obstacles)
    surroundings.obstacles.push_back({spec.view(), spec.velocity});
  surroundings.radii.reserve(scenario.vehicles.size());
  for (const VehicleSpec& spec : scenario.vehicles) surroundings.radii.push_back(spec.radius_m);
  surroundings.limits = limits_in_force(scenario, vehicles);
  surroundings.keeps_pace.reserve(scenario.vehicles.size());
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i)
    surroundings.keeps_pace.push_back(
        keeps_pace(scenario.vehicles[i], *surroundings.limits[i], scenario.water));
  return surroundings;
}

RunMetrics metrics_for(const Scenario& scenario, const VehicleCatalog& vehicles) {
  return RunMetrics{{scenario.exam.crit_dist_m, scenario.exam.safety_distance_m},
                    surroundings_of(scenario, vehicles),
                    scenario.exam.progress_window_s};
}

void run_into(const Scenario& scenario, const Catalogs& catalogs, std::span<FrameSink* const> sinks,
              const std::atomic<bool>* stop) {
  Simulation simulation{scenario, catalogs};
  simulation.show_thoughts(
      std::ranges::any_of(sinks, [](const FrameSink* sink) { return sink->wants_thoughts(); }));
  while (!simulation.is_done()) {
    if (stop != nullptr && stop->load(std::memory_order_relaxed)) throw RunAbandoned{};
    simulation.step(sinks);
  }
  simulation.refuse_divergence();
}

std::vector<FrameSink*> sinks_of(std::initializer_list<FrameSink*> own, std::span<FrameSink* const> more) {
  std::vector<FrameSink*> sinks{own};
  sinks.insert(sinks.end(), more.begin(), more.end());
  return sinks;
}

std::vector<Measure> measure_run(const Scenario& scenario, const Catalogs& catalogs,
                                 const std::atomic<bool>* stop, std::span<FrameSink* const> more) {
  RunMetrics metrics = metrics_for(scenario, catalogs.vehicles);
  run_into(scenario, catalogs, sinks_of({&metrics}, more), stop);
  return metrics.measures();
}

}  // namespace fairway
