// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/exam_playbacks.hpp"

#include <tuple>
#include <vector>

#include "fairway/cli/paths.hpp"
#include "fairway/cli/study_run.hpp"
#include "fairway/exam/worst_runs.hpp"
#include "fairway/experiment/executor.hpp"
#include "fairway/record/recording.hpp"
#include "fairway/sim/simulation.hpp"
#include "fairway/view/explain/explain_recording.hpp"

namespace fairway::cli {
namespace {

/// What tells a run of an exam from all others.
using RunIdentity = std::tuple<std::string, std::string, std::string, bool, std::string, std::uint64_t>;

RunIdentity identity_of(const ExamRun& run) {
  return {run.family, run.condition, run.method, run.tuned, run.ground, run.seed};
}

/// A file that goes with its owner.
class PassingFile {
 public:
  explicit PassingFile(std::filesystem::path path) : path_{std::move(path)} {}
  ~PassingFile() {
    std::error_code gone;
    std::filesystem::remove(path_, gone);
  }
  PassingFile(const PassingFile&) = delete;
  PassingFile& operator=(const PassingFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A run that is to be played, and its place in the plan.
struct Played {
  const ExamRun* run{};
  std::size_t at{};
};

std::vector<Played> of_the_plan(const std::vector<WorstRun>& worst, const ExamPlan& plan) {
  std::map<RunIdentity, std::size_t> places;
  for (std::size_t i = 0; i < plan.campaign.specs.size(); ++i)
    places.emplace(identity_of(exam_run_of({.spec = plan.campaign.specs[i], .measures = {}, .failure = {}})),
                   i);
  std::vector<Played> played;
  for (const WorstRun& each : worst)
    if (const auto found = places.find(identity_of(*each.run)); found != places.end())
      played.push_back({each.run, found->second});
  return played;
}

void simulate(const Scenario& scenario, const Program& program, std::span<FrameSink* const> sinks) {
  Simulation simulation{scenario, program.catalogs};
  simulation.show_thoughts(true);
  while (!simulation.is_done()) {
    if (program.stop->load(std::memory_order_relaxed)) throw RunAbandoned{};
    simulation.step(sinks);
  }
  simulation.refuse_divergence();
}

/// Makes the run again, and its page.
void play(const ExamRun& run, const RunSpec& spec, const Scenario& scenario,
          const std::filesystem::path& page, const Program& program) {
  const ShownRun shown{.name = {},
                       .spec = spec,
                       .scenario = scenario,
                       .make = [&](std::span<FrameSink* const> sinks) -> std::vector<Measure> {
                         simulate(scenario, program, sinks);
                         return {};
                       }};
  const Catalog& avoiders = program.catalogs.avoiders;
  if (run.outcome.is_safe() || !has_instant(run.outcome)) {
    make_shown(shown, {.recording = {}, .playback = page}, avoiders);
    return;
  }
  const PassingFile recording{page.string() + ".mcap"};
  make_shown(shown, {.recording = recording.path(), .playback = {}}, avoiders);
  const std::string file = recording.path().string();
  const std::string vehicle = std::to_string(static_cast<int>(run.outcome.worst_vehicle));
  if (!explain_recording(Recording::read(file),
                         {file, vehicle, run.outcome.worst_time_s, page.string(), command_of(spec)},
                         program.catalogs, program.stop))
    throw RunAbandoned{};
}

/// False if stopped.
bool make_missing(std::span<const Played> all, const ExamPlan& plan, const std::filesystem::path& folder,
                  unsigned jobs, const Program& program) {
  std::vector<Played> missing;
  std::vector<RunSpec> specs;
  for (const Played& each : all) {
    const RunSpec& spec = plan.campaign.specs[each.at];
    if (std::filesystem::exists(folder / playback_path(spec))) continue;
    missing.push_back(each);
    specs.push_back(spec);
  }
  if (missing.empty()) return true;
  make_folder((folder / "runs").string(), "--out");
  Store results = Store::in_memory();
  Progress progress{"playbacks"};
  const auto make = [&](std::size_t i) -> std::vector<Measure> {
    play(*missing[i].run, specs[i], plan.campaign.scenario_of(missing[i].at),
         folder / playback_path(specs[i]), program);
    return {};
  };
  if (run_missing(specs, make, results, {.jobs = jobs, .progress = &progress, .stop = program.stop}).stopped)
    return false;
  for (const RunRecord& record : results.all())
    if (!record.failure.empty()) throw InputError(playback_path(record.spec) + ": " + record.failure);
  return true;
}

}  // namespace

std::string page_of(const ExamPlaybacks& playbacks, const ExamRun& run) {
  const auto found = playbacks.find(&run);
  return found == playbacks.end() ? "" : found->second;
}

std::optional<ExamPlaybacks> exam_playbacks(const ExamTable& table, const ExamPlan& plan,
                                            const std::filesystem::path& folder, bool are_asked,
                                            unsigned jobs, const Program& program) {
  const std::vector<Played> all = of_the_plan(worst_runs(table), plan);
  if (are_asked && !make_missing(all, plan, folder, jobs, program)) return {};
  ExamPlaybacks pages;
  for (const Played& each : all)
    if (std::string page = playback_path(plan.campaign.specs[each.at]);
        std::filesystem::exists(folder / page))
      pages.emplace(each.run, std::move(page));
  return pages;
}

}  // namespace fairway::cli
