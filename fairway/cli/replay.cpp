// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/cli/program.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/recording_info.hpp"
#include "fairway/metrics/run_metrics.hpp"
#include "fairway/record/csv.hpp"
#include "fairway/record/hash_checker.hpp"
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

/// Simulates the recorded scenario again beside the recording.
int verify(const Recording& recording, const std::string& name, bool as_json, const Catalogs& catalogs) {
  const Scenario scenario = recorded_scenario(recording, name);
  check_methods(recording, scenario, catalogs, name);
  HashChecker checker{recording};
  const std::array<FrameSink*, 1> sinks{&checker};
  Simulation simulation{scenario, catalogs};
  simulation.show_thoughts(recording.info().sketches);
  simulation.run(sinks);
  if (as_json) {
    std::cout << nlohmann::json{{"recording", name},
                                {"same", checker.same()},
                                {"verdict", checker.describe()}}
                     .dump(2)
              << "\n";
  } else {
    std::cout << name << ": " << checker.describe() << "\n";
  }
  return checker.same() ? ok : expectation_failed;
}

using Export = void (*)(const Recording&, std::ostream&);

void export_to(const std::string& file, const Recording& recording, Export write) {
  if (file.empty()) return;
  if (file == "-") {
    write(recording, std::cout);
    return;
  }
  std::ofstream out{file, std::ios::binary};
  write(recording, out);
  out.close();
  if (!out) throw InputError(file + ": cannot be written");
}

/// What is in the recording, from its frames alone.
void summarise(const Recording& recording, const std::string& name, bool as_json) {
  const RecordingInfo& info = recording.info();
  const Scenario scenario = recorded_scenario(recording, name);
  RunMetrics metrics = metrics_for(scenario);
  recording.play(metrics);
  nlohmann::json document{
      {"recording", name},       {"scenario", info.scenario_name}, {"seed", info.seed},
      {"version", info.version}, {"frames", recording.size()},     {"vehicles", info.vehicles.size()},
      {"period_s", info.period}, {"perception", info.perception},  {"sketches", info.sketches}};
  for (const Measure& m : metrics.measures()) {
    if (m.vehicle == Measure::fleet && std::isfinite(m.value)) document[m.quantity] = m.value;
  }
  if (as_json) {
    std::cout << document.dump(2) << "\n";
    return;
  }
  for (const auto& [key, value] : document.items())
    std::cout << key << ": " << (value.is_string() ? value.get<std::string>() : value.dump()) << "\n";
}

}  // namespace

void add_replay(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand(
      "replay", "What a recording holds; --verify simulates it again and compares every frame");
  verb->footer("Example: fairway replay cube.mcap --verify");
  auto flags = std::make_shared<ReplayFlags>();
  verb->add_option("recording", flags->recording, "MCAP file written by `fairway run --out`")->required();
  verb->add_flag("--verify", flags->verify, "run it again: same bits, or exit code 1");
  verb->add_option("--csv", flags->csv, "export the frames to this file; - for standard output");
  verb->add_option("--tracks", flags->tracks, "export what was perceived of others to this file");
  verb->add_option("--echoes", flags->echoes, "export the echoes of sonars to this file");
  verb->add_flag("--json", flags->json, "print JSON");
  verb->callback([=, &program] {
    program.chosen = [=, &program] {
      const Recording recording = Recording::read(flags->recording);
      export_to(flags->csv, recording, export_csv);
      export_to(flags->tracks, recording, export_tracks_csv);
      export_to(flags->echoes, recording, export_echoes_csv);
      if (flags->verify) return verify(recording, flags->recording, flags->json, program.catalogs);
      const bool exported = !(flags->csv + flags->tracks + flags->echoes).empty();
      if (!exported) summarise(recording, flags->recording, flags->json);
      return ok;
    };
  });
}

}  // namespace fairway::cli
