// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fairway/cli/program.hpp"
#include "fairway/metrics/run_metrics.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/simulation.hpp"
#include "fairway/view/live/live_run.hpp"

namespace fairway::cli {

/// A vehicle that is still under way where a run ends, and makes no progress.
struct NoProgress {
  std::string name;
  ProgressReport report;
  std::string with;  ///< name of another vehicle, or obstacles[i] of the scenario; empty if nobody
};

/// What one run came to.
struct RunOutcome {
  std::vector<Measure> measures;
  DecisionTimes decisions;
  std::vector<std::pair<std::string, std::string>> notes;  ///< what an avoider said last, by vehicle
  std::vector<NoProgress> no_progress;                     ///< whoever made no progress at the end
  std::optional<AcousticCounts> messages;                  ///< what became of them, where telling takes time
  double simulated_s{};
  double wall_s{};
  bool complete{true};                   ///< false if stopped
  std::optional<Divergence> divergence;  ///< how the run broke: there are no measures then
};

/// Where a run is recorded, and what of it.
struct RecordingChoice {
  std::string file;        ///< nowhere if empty
  bool perception{false};  ///< tracks and echoes too
  bool sketches{false};    ///< what methods draw and the messages under way too
};

/// Whoever watches a run: sees its frames, thoughts and all, and sets its pace. The results are the same.
struct Watch {
  LiveRun& run;
  std::function<void()>
      ready;  ///< called before the first step, when nothing of the input can be wrong any more
};

/// Runs a scenario on so many threads, and records it, up to where it is stopped.
RunOutcome run_scenario(const Scenario& scenario, const RecordingChoice& recording, const Program& program,
                        const Watch* watch = nullptr, std::size_t threads = 1);

/// Whoever made no progress as of the last of at least one frame.
std::vector<NoProgress> no_progress_at_end(const Scenario& scenario, const ProgressMetric& progress);

/// "diverged: otter0 at 3.2 s: its speed is beyond 200 m/s", or empty for a run that is whole.
std::string divergence_text(const Scenario& scenario, const RunOutcome& outcome);

/// An expectation and what came of it.
struct Judgement {
  Expectation expectation;
  double worst{};  ///< of all vehicles, for a quantity that each has: farthest outside the bounds, or nearest
                   ///< to one
  bool kept{};

  // where `worst` comes from, as far as the metric knows; empty otherwise
  std::string vehicle;         ///< its name
  std::string with;            ///< name of another vehicle, or obstacles[i] of the scenario
  std::optional<double> time;  ///< [s]
};

/// Throws InputError for a metric that does not exist.
void check_expectations(const Scenario& scenario);

/// Holds a run to what its scenario expects. What was not measured is not kept.
std::vector<Judgement> judge(const Scenario& scenario, const std::vector<Measure>& measures);

/// "collision_count = 2, expected 0", and of a failed one where it comes from: " (robot1, with robot2,
/// at 31.5 s)".
std::string text_of(const Judgement& judgement);

/// Tells on standard error where a method is not meant for its vehicle or for what it meets.
void warn_of_misfits(const Scenario& scenario, const Program& program);

/// All vehicles of a scenario get the same algorithm, by its name or from a file `name.yaml`; whoever has it
/// already keeps its parameters. Parameters among `overrides`, `vehicles[*].avoider.KEY`, are laid over it.
/// Throws InputError for a file that cannot be read, and for a folder.
void set_algorithm(Scenario& scenario, const std::string& name, const Overrides& overrides,
                   const Catalog& methods);

}  // namespace fairway::cli
