// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/experiment/run.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/catalogs.hpp"
#include "fairway/studies/study.hpp"

namespace fairway {

/// What a run is measured by, with sinks that see its frames too; called by several threads at once, throws
/// RunAbandoned once `stop` is true.
using MeasureRun = std::function<std::vector<Measure>(const Scenario&, const std::atomic<bool>* stop,
                                                      std::span<FrameSink* const> more)>;

/// `measure` with these catalogs, which must outlive what is made.
template <class Measured>
MeasureRun measured_with(const Catalogs& catalogs, const Measured& measure) {
  return [&catalogs, measure](const Scenario& scenario, const std::atomic<bool>* stop,
                              std::span<FrameSink* const> more) {
    return measure(scenario, catalogs, stop, more);
  };
}

/// One run of a study: what tells it from the others, what is run, and how it is measured.
struct StudyRun {
  RunSpec spec;                        ///< its key begins with the study's name and a '/'
  std::function<Scenario()> scenario;  ///< called by several threads at once
  MeasureRun measure;
};

/// "cube20_8/apf/corrected/": what the names of runs share that differ in their seeds alone.
std::string cell_name(const Labels& labels);

/// "cube20_8/apf/corrected/3": case, method, mode, what else is varied, and the seed. Within one study no two
/// runs have the same.
std::string name_of(const RunSpec& spec);

/// The run as the store keeps it: under overrides it has another key; with the command that makes it alone.
RunSpec spec_under(const StudyOptions& options, RunSpec spec);

/// The scenario under the overrides. Throws InputError naming the override that does not fit it.
Scenario under(const Overrides& overrides, Scenario scenario);

/// The run that is called so: by its name, its key, or the beginning of one of these. Throws InputError with
/// the nearest name if there is none, with a few of them if there are several.
const StudyRun& find_run(std::span<const StudyRun> runs, std::string_view called);

/// Hands a run to whoever wants to see it (`show` of the options), if anybody does.
void show_run(const StudyRun& run, const StudyOptions& options);

/// Makes the runs, under the options' overrides, that the store lacks (of the options; else of memory) and
/// gives the measures of all, in the order of `runs`. Runs under other overrides have other keys. Nothing if
/// stopped before all were made, or if one of them, or a shard, was wanted alone. Throws InputError for a run
/// that failed, if an override does not fit, or as find_run().
std::optional<std::vector<std::vector<Measure>>> make_runs(std::span<const StudyRun> runs,
                                                           const StudyOptions& options);

}  // namespace fairway
