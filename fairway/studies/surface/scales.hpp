// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fairway/sim/catalogs.hpp"
#include "fairway/studies/run_index.hpp"
#include "fairway/studies/surface/plan.hpp"

/// What the printed times can tell of two things that the paper leaves open, the length of its courses and
/// the speed limit that each method really had: the three courses for which it prints times of AVOA and TEB,
/// each at several scales, sailed under several limits.
namespace fairway::surface {

/// One run of AVOA and of TEB for each course, scale and limit, with Zarco in the waves of Table I. TEB goes
/// at the limit; AVOA wants 0.8 of it, as in the published part.
std::vector<Cell> scale_cells();

/// Runs a scenario under every metric, and tells how far ahead of the other vessel's centre the own one
/// crosses its way (`ahead_of_vessel_m`, astern negative), if it does. Throws RunAbandoned once `stop` is
/// true.
std::vector<Measure> measure_scale(const Scenario& scenario, const Catalogs& catalogs,
                                   const std::atomic<bool>* stop, std::span<FrameSink* const> more);

/// What was measured, by `length_m` and `limit_mps`.
std::vector<StudyRow> scale_rows(const std::vector<Cell>& cells);

/// Under which limits the printed times come out at each length, and what besides the times tells the limits
/// apart, in sentences made from the numbers.
std::vector<std::string> scale_findings(const std::vector<Cell>& cells);

/// A line for each length and limit.
nlohmann::json scale_table(const std::vector<Cell>& cells, const RunIndex& runs);

}  // namespace fairway::surface
