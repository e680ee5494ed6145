// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>

#include "fairway/cli/live.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/cli/runner.hpp"

namespace fairway::cli {
namespace {

using nlohmann::json;

struct RunOptions {
  std::string file;
  std::string algorithm;
  std::vector<std::string> settings;
  std::optional<std::uint64_t> seed;
  RecordingChoice recording;
  LiveChoice live;
  bool json{false};
};

json number(double value) { return std::isfinite(value) ? json(value) : json(); }

json document_of(const Scenario& scenario, const RunOutcome& outcome,
                 const std::vector<Judgement>& judgements) {
  json document{{"scenario", scenario.name}, {"seed", scenario.seed}, {"simulated_s", outcome.simulated_s}};
  for (const VehicleSpec& vehicle : scenario.vehicles)
    document["vehicles"].push_back({{"name", vehicle.name}});
  for (const Measure& measure : outcome.measures) {
    if (measure.vehicle == Measure::fleet) {
      document["fleet"][measure.quantity] = number(measure.value);
    } else {
      document["vehicles"][static_cast<std::size_t>(measure.vehicle)][measure.quantity] =
          number(measure.value);
    }
  }
  for (const auto& [vehicle, note] : outcome.notes) document["notes"][vehicle] = note;
  document["expect"] = json::array();
  for (const Judgement& judgement : judgements) {
    document["expect"].push_back({{"metric", judgement.expectation.metric},
                                  {"worst", number(judgement.worst)},
                                  {"kept", judgement.kept}});
  }
  return document;
}

/// One line a quantity, one column a vehicle; for many vehicles their least, mean and greatest.
void print_vehicles(const Scenario& scenario, const std::vector<Measure>& measures) {
  constexpr std::size_t most_columns = 8;
  const bool each = scenario.vehicles.size() <= most_columns;
  std::cout << fmt::format("  {:<24}", each ? "of each vehicle" : "of the vehicles");
  if (each) {
    for (const VehicleSpec& vehicle : scenario.vehicles) std::cout << fmt::format(" {:>12}", vehicle.name);
  } else {
    std::cout << fmt::format(" {:>12} {:>12} {:>12}", "least", "mean", "greatest");
  }
  std::cout << "\n";

  std::vector<std::string> quantities;
  for (const Measure& m : measures) {
    if (m.vehicle == 0) quantities.push_back(m.quantity);
  }
  for (const std::string& quantity : quantities) {
    std::vector<double> values;
    for (const Measure& m : measures) {
      if (m.vehicle != Measure::fleet && m.quantity == quantity) values.push_back(m.value);
    }
    if (!each) {
      const auto [least, greatest] = std::ranges::minmax(values);
      values = {least, std::reduce(values.begin(), values.end()) / static_cast<double>(values.size()),
                greatest};
    }
    std::cout << fmt::format("  {:<24}", quantity);
    for (const double value : values) std::cout << fmt::format(" {:>12.6g}", value);
    std::cout << "\n";
  }
}

void print(const Scenario& scenario, const RunOutcome& outcome, const std::vector<Judgement>& judgements) {
  std::cout << fmt::format("{}: {} vehicles, {:.1f} s simulated in {:.2f} s\n", scenario.name,
                           scenario.vehicles.size(), outcome.simulated_s, outcome.wall_s);
  for (const Measure& m : outcome.measures) {
    if (m.vehicle == Measure::fleet) std::cout << fmt::format("  {:<24} {:.6g}\n", m.quantity, m.value);
  }
  print_vehicles(scenario, outcome.measures);
  for (const auto& [vehicle, note] : outcome.notes) std::cout << "  " << vehicle << ": " << note << "\n";
  if (outcome.decisions.count > 0) {
    std::cout << fmt::format("  decisions: {}, mean {:.2f} us, worst {:.1f} us (on this machine)\n",
                             outcome.decisions.count,
                             1e6 * outcome.decisions.total_s / static_cast<double>(outcome.decisions.count),
                             1e6 * outcome.decisions.worst_s);
  }
  for (const Judgement& judgement : judgements) {
    std::cout << "  " << (judgement.kept ? "kept    " : "FAILED  ") << text_of(judgement) << "\n";
  }
}

int run(const RunOptions& options, const Program& program) {
  Scenario scenario = load_scenario(options.file, overrides_of(options.settings), options.seed);
  if (!options.algorithm.empty()) set_algorithm(scenario, options.algorithm);
  check_expectations(scenario);
  const RunOutcome outcome = options.live.asked
                                 ? run_live(scenario, options.recording, options.live, program.typed,
                                            options.json ? std::cerr : std::cout, program.stop)
                                 : run_scenario(scenario, options.recording, program.stop);
  if (!outcome.complete) {
    std::cerr << "fairway: interrupted\n";
    return interrupted;
  }
  const std::vector<Judgement> judgements = judge(scenario, outcome.measures);
  if (options.json) {
    std::cout << document_of(scenario, outcome, judgements).dump(2) << "\n";
  } else {
    print(scenario, outcome, judgements);
  }
  const bool all_kept = std::ranges::all_of(judgements, &Judgement::kept);
  return all_kept ? ok : expectation_failed;
}

void add_live(CLI::App& verb, LiveChoice& choice) {
  CLI::Option* live = verb.add_flag("--live", choice.asked,
                                    "show it in a browser on this machine as it is made, until Ctrl-C");
  verb.add_option("--port", choice.port, "of that page; 0: any that is free")
      ->check(CLI::Range(0, 65535))
      ->needs(live);
  verb.add_option("--speed", choice.speed, "of the clock, 1 by default; 0: as fast as it can")->needs(live);
  verb.add_flag("--paused", choice.paused, "begin paused")->needs(live);
  verb.add_flag("--until-done", choice.until_done, "end with the run")->needs(live);
}

}  // namespace

void add_run(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand("run", "Run one scenario; record it if asked");
  verb->footer("Example: fairway run scenarios/cube20_8.yaml --algorithm orca3d --seed 3 --out cube.mcap");
  auto options = std::make_shared<RunOptions>();
  verb->add_option("scenario", options->file, "scenario file")->required();
  verb->add_option("--algorithm", options->algorithm, "for every vehicle, instead of the file's");
  verb->add_option("--set", options->settings, "path=value, over what the file says");
  verb->add_option("--seed", options->seed, "instead of the file's");
  CLI::Option* out = verb->add_option("--out", options->recording.file, "record the run to this MCAP file");
  verb->add_flag("--perception", options->recording.perception,
                 "record what each vehicle perceived too: tracks and echoes")
      ->needs(out);
  verb->add_flag("--sketch", options->recording.sketches,
                 "record what each method draws of its thinking, and the messages under way")
      ->needs(out);
  add_live(*verb, options->live);
  verb->add_flag("--json", options->json, "print JSON");
  verb->callback([=, &program] { program.chosen = [=, &program] { return run(*options, program); }; });
}

}  // namespace fairway::cli
