// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>

#include "fairway/core/math.hpp"
#include "fairway/core/names.hpp"
#include "fairway/core/text.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/recording_info.hpp"
#include "fairway/record/recording_writer.hpp"
#include "fairway/scenario/algorithm_file.hpp"
#include "fairway/sim/misfits.hpp"

namespace fairway::cli {
namespace {

RecordingInfo info_of(const Scenario& scenario, const RecordingChoice& choice, const Program& program) {
  RecordingInfo info = recording_info(scenario);
  info.program = program.name;
  info.perception = choice.perception;
  info.sketches = choice.sketches;
  return info;
}

/// Waits for its turn where somebody sets the pace. False if the run is to stop.
bool may_go_on(double time, const Watch* watch, const std::atomic<bool>* stop) {
  static const std::atomic<bool> never{false};
  const std::atomic<bool>& stopped = stop == nullptr ? never : *stop;
  return watch == nullptr ? !stopped.load(std::memory_order_relaxed) : watch->run.await_turn(time, stopped);
}

/// How far `value` is outside the bounds; negative inside, by the way to the nearer one.
double excess(const Expectation& expected, double value) {
  if (std::isnan(value)) return std::numeric_limits<double>::infinity();
  return math::fmax(value - expected.max, expected.min - value);
}

std::string vehicle_name(const Scenario& scenario, int index) {
  return index < 0 ? std::string() : scenario.vehicles[static_cast<std::size_t>(index)].name;
}

/// Name of another vehicle, or obstacles[i] of the scenario; empty if nobody is known.
std::string name_of_other(const Scenario& scenario, const Occasion& occasion) {
  if (occasion.obstacle == Occasion::none) return vehicle_name(scenario, occasion.other);
  return "obstacles[" + std::to_string(occasion.obstacle) + "]";
}

/// Names whom `measure` is of, and says with whom and when it came about.
void tell_occasion(const Scenario& scenario, const Measure& measure, Judgement& judgement) {
  const Occasion& occasion = measure.occasion;
  judgement.vehicle =
      vehicle_name(scenario, measure.vehicle == Measure::fleet ? occasion.vehicle : measure.vehicle);
  judgement.with = name_of_other(scenario, occasion);
  judgement.time.reset();
  if (!std::isnan(occasion.time)) judgement.time = occasion.time;
}

/// " (robot1, with robot2, at 31.5 s)"; empty if nothing of it is known.
std::string occasion_text(const Judgement& judgement) {
  std::string text = judgement.vehicle;
  const auto append = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (!judgement.with.empty()) append("with " + judgement.with);
  if (judgement.time)
    append(fmt::format("at {:.10g} s", *judgement.time));  // without the last digits of tick * period
  return text.empty() ? text : " (" + text + ")";
}

/// Whoever names a folder that is no method's name means a file in it.
void refuse_folder(const std::string& name, const Catalog& methods) {
  const auto is_known = [&](std::string_view layer) { return methods.has(layer); };
  if (!std::filesystem::is_directory(name) || std::ranges::all_of(layer_names(name), is_known)) return;
  throw InputError("--algorithm " + name +
                   ": is a folder; expected a method, or a file of an avoider such as " +
                   (std::filesystem::path(name) / "best.yaml").string());
}

}  // namespace

RunOutcome run_scenario(const Scenario& scenario, const RecordingChoice& recording, const Program& program,
                        const Watch* watch, std::size_t threads) {
  Simulation simulation{scenario, program.catalogs};
  simulation.share_out(threads);
  simulation.time_decisions();
  simulation.show_thoughts(recording.sketches);
  RunMetrics metrics = metrics_for(scenario, program.catalogs.vehicles);
  metrics.share_out(threads);
  std::vector<FrameSink*> sinks{&metrics};
  std::unique_ptr<RecordingWriter> writer;
  if (!recording.file.empty()) {
    writer = std::make_unique<RecordingWriter>(recording.file, info_of(scenario, recording, program));
    sinks.push_back(writer.get());
  }
  if (watch != nullptr) {
    simulation.show_thoughts(true);
    sinks.push_back(&watch->run);
    watch->ready();
  }

  const auto begin = std::chrono::steady_clock::now();
  RunOutcome outcome;
  while (outcome.complete && !simulation.is_done()) {
    outcome.complete = may_go_on(simulation.time(), watch, program.stop);
    if (outcome.complete) simulation.step(sinks);
  }
  outcome.divergence = simulation.divergence();
  if (writer) writer->close({.divergence = divergence_text(scenario, outcome), .stopped = !outcome.complete});
  outcome.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!outcome.divergence) outcome.measures = metrics.measures();
  outcome.decisions = simulation.decision_times();
  outcome.messages = simulation.message_counts();
  for (const Agent& agent : simulation.agents()) {
    if (!agent.note.empty()) outcome.notes.emplace_back(agent.ship().name, std::string(agent.note));
  }
  outcome.simulated_s = simulation.time();
  if (!outcome.divergence && outcome.simulated_s > 0.0)
    outcome.no_progress = no_progress_at_end(scenario, metrics.progress());
  return outcome;
}

std::vector<NoProgress> no_progress_at_end(const Scenario& scenario, const ProgressMetric& progress) {
  std::vector<NoProgress> all;
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i) {
    const ProgressReport& report = progress.state(i);
    if (note_of(report.state).empty()) continue;
    all.push_back({scenario.vehicles[i].name, report, name_of_other(scenario, progress.occasion(i))});
  }
  return all;
}

std::string divergence_text(const Scenario& scenario, const RunOutcome& outcome) {
  if (!outcome.divergence) return {};
  return text_of(*outcome.divergence, scenario.vehicles[outcome.divergence->vehicle].name);
}

void check_expectations(const Scenario& scenario) {
  const std::vector<QuantityInfo> quantities = all_quantities();
  std::vector<std::string_view> known;
  for (const QuantityInfo& quantity : quantities) known.push_back(quantity.name);
  for (const Expectation& expected : scenario.expect) {
    if (std::ranges::find(known, expected.metric) != known.end()) continue;
    throw InputError(expected.where, "expect." + expected.metric,
                     "unknown metric" + suggestion(expected.metric, known));
  }
}

std::vector<Judgement> judge(const Scenario& scenario, const std::vector<Measure>& measures) {
  std::vector<Judgement> judgements;
  for (const Expectation& expected : scenario.expect) {
    Judgement judgement{expected, std::numeric_limits<double>::quiet_NaN(), false, {}, {}, {}};
    std::optional<double> worst;
    for (const Measure& measure : measures) {
      if (measure.quantity != expected.metric) continue;
      const double off = excess(expected, measure.value);
      if (worst && off <= *worst) continue;
      worst = off;
      judgement.worst = measure.value;
      judgement.kept = off <= 0.0;
      tell_occasion(scenario, measure, judgement);
    }
    judgements.push_back(std::move(judgement));
  }
  return judgements;
}

std::string text_of(const Judgement& judgement) {
  const Expectation& expected = judgement.expectation;
  std::string bounds;
  if (expected.min == expected.max) {
    bounds = number_text(expected.min);
  } else {
    if (std::isfinite(expected.min)) bounds += "at least " + number_text(expected.min);
    if (std::isfinite(expected.max))
      bounds += (bounds.empty() ? "" : " and ") + ("at most " + number_text(expected.max));
  }
  return expected.metric + " = " + number_text(judgement.worst) + ", expected " + bounds +
         (judgement.kept ? "" : occasion_text(judgement));
}

void warn_of_misfits(const Scenario& scenario, const Program& program) {
  for (const std::string& line : misfits(scenario, program.catalogs))
    std::cerr << "fairway: warning: " << line << "\n";
}

void set_algorithm(Scenario& scenario, const std::string& name, const Catalog& methods) {
  if (is_algorithm_file(name)) {
    const Choice avoider = load_algorithm(name);
    for (VehicleSpec& vehicle : scenario.vehicles) vehicle.avoider = avoider;
    return;
  }
  refuse_folder(name, methods);
  for (VehicleSpec& vehicle : scenario.vehicles) {
    if (vehicle.avoider->name == name) continue;
    vehicle.avoider =
        Choice{.name = name, .params = {}, .path = "--algorithm", .where = {}, .param_where = {}};
  }
}

}  // namespace fairway::cli
