// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fairway/experiment/run.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/studies/study.hpp"

namespace fairway {

/// One run of a study: what tells it from the others, and what is run.
struct StudyRun {
  RunSpec spec;
  std::function<Scenario()> scenario;  ///< called by several threads at once
};

/// What a run is measured by; called by several threads at once, throws RunAbandoned once `stop` is true.
using MeasureRun = std::function<std::vector<Measure>(const Scenario&, const std::atomic<bool>* stop)>;

/// The scenario under the overrides. Throws InputError naming the override that does not fit it.
Scenario under(const Overrides& overrides, Scenario scenario);

/// Makes the runs, under the options' overrides, that the store lacks (of the options; else of memory) and
/// gives the measures of all, in the order of `runs`. Runs under other overrides have other keys. Nothing if
/// stopped before all were made. Throws InputError for a run that failed, or if an override does not fit.
std::optional<std::vector<std::vector<Measure>>> make_runs(std::span<const StudyRun> runs,
                                                           const MeasureRun& measure,
                                                           const StudyOptions& options);

}  // namespace fairway
