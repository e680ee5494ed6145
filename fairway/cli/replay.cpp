// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/cli/outputs.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/cli/runner.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/recording_info.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/metrics/run_metrics.hpp"
#include "fairway/record/csv.hpp"
#include "fairway/record/hash_checker.hpp"
#include "fairway/record/output_file.hpp"
#include "fairway/record/recording.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::cli {
namespace {

struct ReplayFlags {
  std::string recording;
  std::string csv;
  std::string tracks;
  std::string echoes;
  bool verify{false};
  bool json{false};
};

/// Whether the run was whole, as `fairway run --json` says it, or was stopped; "diverged" is here a line.
void add_outcome(const Recording& recording, nlohmann::json& document) {
  constexpr std::string_view prefix = "diverged: ";
  const std::string& broke = recording.divergence();
  document["outcome"] = !broke.empty() ? "diverged" : recording.stopped() ? "stopped" : "finished";
  if (!broke.empty()) document["diverged"] = broke.substr(broke.starts_with(prefix) ? prefix.size() : 0);
}

/// What came of a run that was made again.
struct Verdict {
  bool same{};
  std::string text;
};

/// `now` is how it broke, in a line; empty if it is whole.
Verdict verdict_on(const Recording& recording, const HashChecker& checker, const std::string& now) {
  if (!checker.same() || now == recording.divergence()) return {checker.same(), checker.describe()};
  const auto told = [](const std::string& broke) { return broke.empty() ? "whole" : broke; };
  return {false,
          "ends otherwise: \"" + told(recording.divergence()) + "\" was recorded, now \"" + told(now) + "\""};
}

/// Simulates the recorded scenario again beside the recording.
int verify(const Recording& recording, const std::string& name, bool as_json, const Catalogs& catalogs) {
  const Scenario scenario = recorded_scenario(recording, name);
  check_methods(recording, scenario, catalogs, name);
  HashChecker checker{recording};
  const std::array<FrameSink*, 1> sinks{&checker};
  Simulation simulation{scenario, catalogs};
  simulation.show_thoughts(recording.info().sketches);
  while (!simulation.is_done() && !checker.is_over()) simulation.step(sinks);
  const std::string& broke = recording.divergence();
  RunOutcome now;
  now.divergence = simulation.divergence();
  const Verdict verdict = verdict_on(recording, checker, divergence_text(scenario, now));
  const std::string& machine = recording.info().machine;
  const bool elsewhere = !machine.empty() && machine != fairway_machine;
  if (as_json) {
    nlohmann::json document{{"recording", name}, {"same", verdict.same}, {"verdict", verdict.text}};
    if (!machine.empty()) document["recorded_on"] = machine;
    document["verified_on"] = fairway_machine;
    add_outcome(recording, document);
    std::cout << document.dump(2) << "\n";
  } else {
    std::cout << name << ": " << verdict.text
              << (elsewhere ? "; recorded on " + machine + ", verified on " + std::string(fairway_machine)
                            : "")
              << (broke.empty() ? "" : "; " + broke) << "\n";
  }
  return verdict.same ? ok : expectation_failed;
}

using Export = void (*)(const Recording&, std::ostream&);

/// One thing goes to standard output.
void refuse_two_answers(const ReplayFlags& flags) {
  const std::pair<const char*, const std::string*> exports[] = {
      {"--csv", &flags.csv}, {"--tracks", &flags.tracks}, {"--echoes", &flags.echoes}};
  std::string first = flags.json ? "--json" : flags.verify ? "--verify" : "";
  for (const auto& [flag, file] : exports) {
    if (flags.json && !flags.verify && !file->empty() && *file != "-")
      throw InputError(std::string("--json: ") + flag +
                       " is written instead of a summary; expected one of the two");
    if (*file != "-") continue;
    if (!first.empty())
      throw InputError(std::string(flag) + " -: " + first + " goes to standard output, too; expected a file");
    first = flag;
  }
}

void export_to(const std::string& file, const Recording& recording, Export write) {
  if (file.empty()) return;
  if (file == "-") {
    write(recording, std::cout);
    return;
  }
  OutputFile out{file};
  write(recording, out.stream());
  out.commit();
}

/// What is in the recording, from its frames alone; of a run that broke no measures.
int summarise(const Recording& recording, const std::string& name, bool as_json,
              const VehicleCatalog& vehicles) {
  const RecordingInfo& info = recording.info();
  const Scenario scenario = recorded_scenario(recording, name);
  const std::string& broke = recording.divergence();
  RunMetrics metrics = metrics_for(scenario, vehicles);
  if (broke.empty()) recording.play(metrics);
  nlohmann::json document{
      {"recording", name},          {"scenario", info.scenario_name},
      {"seed", info.seed},          {"version", info.version},
      {"frames", recording.size()}, {"vehicles", info.vehicles.size()},
      {"period_s", info.period},    {"perception", info.perception},
      {"sketches", info.sketches},  {"stopped", recording.stopped()},
      {"machine", info.machine},    {"run_hash", fmt::format("{:016x}", recording.run_hash())}};
  add_outcome(recording, document);
  if (broke.empty()) {
    for (const Measure& m : metrics.measures()) {
      if (m.vehicle == Measure::fleet && std::isfinite(m.value)) document[m.quantity] = m.value;
    }
  }
  const int code = broke.empty() ? ok : expectation_failed;
  if (as_json) {
    std::cout << document.dump(2) << "\n";
    return code;
  }
  for (const auto& [key, value] : document.items())
    std::cout << key << ": " << (value.is_string() ? value.get<std::string>() : value.dump()) << "\n";
  return code;
}

}  // namespace

void add_replay(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand(
      "replay", "What a recording holds; --verify simulates it again and compares every frame");
  verb->footer("Example: fairway replay cube.mcap --verify");
  auto flags = std::make_shared<ReplayFlags>();
  verb->add_option("recording", flags->recording, "MCAP file written by `fairway run --out`")
      ->check(not_empty())
      ->required();
  verb->add_flag("--verify", flags->verify, "run it again: same bits, or exit code 1");
  auto outputs = std::make_shared<Outputs>(*verb);
  outputs->add("--csv", flags->csv, recording_table, "write the frames as CSV; - for standard output");
  outputs->add("--tracks", flags->tracks, recording_table, "write what was perceived of others as CSV");
  outputs->add("--echoes", flags->echoes, recording_table, "write the echoes of sonars as CSV");
  verb->add_flag("--json", flags->json, "print JSON");
  program.on(*verb, [=, &program] {
    refuse_two_answers(*flags);
    outputs->judge({flags->recording});
    const Recording recording = Recording::read(flags->recording);
    export_to(flags->csv, recording, export_csv);
    export_to(flags->tracks, recording, export_tracks_csv);
    export_to(flags->echoes, recording, export_echoes_csv);
    if (flags->verify) return verify(recording, flags->recording, flags->json, program.catalogs);
    const bool exported = !(flags->csv + flags->tracks + flags->echoes).empty();
    return exported ? ok : summarise(recording, flags->recording, flags->json, program.catalogs.vehicles);
  });
}

}  // namespace fairway::cli
