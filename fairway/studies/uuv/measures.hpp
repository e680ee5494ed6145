// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <span>
#include <vector>

#include "fairway/metrics/measure.hpp"
#include "fairway/record/frame.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/catalogs.hpp"

namespace fairway::uuv {

/// Runs an encounter under every metric and the timeline; `more` sinks see the same frames. Throws
/// RunAbandoned once `stop` is true.
std::vector<Measure> measure_encounter(const Scenario& scenario, const Catalogs& catalogs,
                                       const std::atomic<bool>* stop, std::span<FrameSink* const> more = {});

/// Runs a scenario of many and keeps what is the fleet's, with means over the vehicles: `mean_time_s` and
/// `time_ratio` (to the straight way at the leg's speed) over those that arrived, `mean_course_change_rad`
/// (of the way made, not of the hull) and `mean_infeasible_count` over all. Throws likewise.
std::vector<Measure> measure_fleet(const Scenario& scenario, const Catalogs& catalogs,
                                   const std::atomic<bool>* stop, std::span<FrameSink* const> more = {});

}  // namespace fairway::uuv
