// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
#include "fairway/experiment/compare.hpp"
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

constexpr double rounding = 1e-12;  // of a number that is written in decimals, relative

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

/// Whether the end of the run cut off a time that is to be no longer than so much: how long it would have
/// been nobody knows.
bool is_cut_off(const Expectation& expected, const std::vector<Measure>& measures) {
  return std::isfinite(expected.max) && cut_off(measures, expected.metric);
}

/// Names the first that did not arrive.
void tell_cut_off(const Scenario& scenario, const std::vector<Measure>& measures, Judgement& judgement) {
  judgement.worst = std::numeric_limits<double>::infinity();
  const auto arrived = std::ranges::find(measures, "arrived_ratio", &Measure::quantity);
  if (arrived != measures.end()) judgement.vehicle = vehicle_name(scenario, arrived->occasion.vehicle);
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

/// The parameters among `overrides` of the avoider of the vehicle of that index.
void lay_over(Choice& avoider, std::size_t vehicle, const Overrides& overrides) {
  const std::array prefixes{std::string("vehicles[*].avoider."),
                            "vehicles[" + std::to_string(vehicle) + "].avoider."};
  for (const auto& [path, value] : overrides) {
    const auto prefix =
        std::ranges::find_if(prefixes, [&](const std::string& p) { return path.starts_with(p); });
    if (prefix == prefixes.end()) continue;
    const std::string key = path.substr(prefix->size());
    const auto known = std::ranges::find(avoider.params, key, &ParamValues::value_type::first);
    if (known != avoider.params.end()) {
      known->second = parse_value(value);
    } else {
      avoider.params.emplace_back(key, parse_value(value));
      if (!avoider.param_where.empty()) avoider.param_where.emplace_back();
    }
  }
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
    if (is_cut_off(expected, measures)) {
      tell_cut_off(scenario, measures, judgement);
      judgements.push_back(std::move(judgement));
      continue;
    }
    std::optional<double> worst;
    for (const Measure& measure : measures) {
      if (measure.quantity != expected.metric) continue;
      const double off = excess(expected, measure.value);
      if (worst && off <= *worst) continue;
      worst = off;
      judgement.worst = measure.value;
      judgement.kept = off <= rounding * std::abs(measure.value);
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

void set_algorithm(Scenario& scenario, const std::string& name, const Overrides& overrides,
                   const Catalog& methods) {
  const bool is_file = is_algorithm_file(name);
  if (!is_file) refuse_folder(name, methods);
  const Choice avoider =
      is_file ? load_algorithm(name)
              : Choice{.name = name, .params = {}, .path = "--algorithm", .where = {}, .param_where = {}};
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i) {
    VehicleSpec& vehicle = scenario.vehicles[i];
    if (!is_file && vehicle.avoider->name == name) continue;
    vehicle.avoider = avoider;
    lay_over(vehicle.avoider.edit(), i, overrides);
  }
}

}  // namespace fairway::cli
