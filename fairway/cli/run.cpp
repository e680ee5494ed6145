// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

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
  std::string out;
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
  document["expect"] = json::array();
  for (const Judgement& judgement : judgements) {
    document["expect"].push_back({{"metric", judgement.expectation.metric},
                                  {"worst", number(judgement.worst)},
                                  {"kept", judgement.kept}});
  }
  return document;
}

void print(const Scenario& scenario, const RunOutcome& outcome, const std::vector<Judgement>& judgements) {
  std::cout << fmt::format("{}: {} vehicles, {:.1f} s simulated in {:.2f} s\n", scenario.name,
                           scenario.vehicles.size(), outcome.simulated_s, outcome.wall_s);
  for (const Measure& m : outcome.measures) {
    if (m.vehicle == Measure::fleet) std::cout << fmt::format("  {:<24} {:.6g}\n", m.quantity, m.value);
  }
  std::cout << fmt::format("  {:<14}", "vehicle");
  std::vector<std::string> quantities;
  for (const Measure& m : outcome.measures) {
    if (m.vehicle == 0) quantities.push_back(m.quantity);
  }
  for (const std::string& quantity : quantities) std::cout << fmt::format(" {:>17}", quantity);
  std::cout << "\n";
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i) {
    std::cout << fmt::format("  {:<14}", scenario.vehicles[i].name);
    for (const std::string& quantity : quantities) {
      for (const Measure& m : outcome.measures) {
        if (m.vehicle == static_cast<int>(i) && m.quantity == quantity)
          std::cout << fmt::format(" {:>17.6g}", m.value);
      }
    }
    std::cout << "\n";
  }
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

int run(const RunOptions& options, const std::atomic<bool>* stop) {
  Scenario scenario = load_scenario(options.file, overrides_of(options.settings), options.seed);
  if (!options.algorithm.empty()) set_algorithm(scenario, options.algorithm);
  check_expectations(scenario);
  const RunOutcome outcome = run_scenario(scenario, options.out, stop);
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

}  // namespace

void add_run(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand("run", "Run one scenario; record it if asked");
  verb->footer("Example: fairway run scenarios/cube20_8.yaml --algorithm orca3d --seed 3 --out cube.mcap");
  auto options = std::make_shared<RunOptions>();
  verb->add_option("scenario", options->file, "scenario file")->required();
  verb->add_option("--algorithm", options->algorithm, "for every vehicle, instead of the file's");
  verb->add_option("--set", options->settings, "path=value, over what the file says");
  verb->add_option("--seed", options->seed, "instead of the file's");
  verb->add_option("--out", options->out, "record the run to this MCAP file");
  verb->add_flag("--json", options->json, "print JSON");
  verb->callback([=, &program] { program.chosen = [=, &program] { return run(*options, program.stop); }; });
}

}  // namespace fairway::cli
