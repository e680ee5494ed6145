// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <initializer_list>
#include <span>
#include <vector>

#include "fairway/metrics/run_metrics.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/catalogs.hpp"

namespace fairway {

/// What is round the vehicles of a scenario, which must outlive it.
Surroundings surroundings_of(const Scenario& scenario, const VehicleCatalog& vehicles = builtin_vehicles());

/// Every metric, with the scenario's counting rules and obstacles, and what its vehicles can do. The scenario
/// must outlive it.
RunMetrics metrics_for(const Scenario& scenario, const VehicleCatalog& vehicles = builtin_vehicles());

/// Runs a scenario into `sinks`, showing its thoughts if one of them wants them. Throws as measure_run().
void run_into(const Scenario& scenario, const Catalogs& catalogs, std::span<FrameSink* const> sinks,
              const std::atomic<bool>* stop);

/// `own` and then `more`.
std::vector<FrameSink*> sinks_of(std::initializer_list<FrameSink*> own, std::span<FrameSink* const> more);

/// Runs a scenario and measures it; `more` sinks see the same frames. Throws RunAbandoned as soon as `stop`
/// is true, RunDiverged if it breaks, InputError for what the catalogs do not accept or cannot be simulated.
std::vector<Measure> measure_run(const Scenario& scenario, const Catalogs& catalogs,
                                 const std::atomic<bool>* stop = nullptr,
                                 std::span<FrameSink* const> more = {});

}  // namespace fairway
