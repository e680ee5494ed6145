// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/trial.hpp"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "fairway/cli/program.hpp"

namespace fairway::cli {
namespace {

struct TrialFlags {
  std::string vehicle, inputs, out;
  std::vector<std::string> settings;
  bool json{false};
};

int trial(const TrialFlags& flags, const VehicleCatalog& vehicles) {
  std::istringstream inputs{read_text(flags.inputs)};
  std::ostringstream states;
  run_trial(vehicles, flags.vehicle, inputs, flags.inputs, states, settings_of(flags.settings));
  if (flags.out == "-") {
    std::cout << states.str();
    return ok;
  }
  std::ofstream file{flags.out, std::ios::binary};
  file << states.str();
  file.close();
  if (!file) throw InputError(flags.out + ": cannot be written");
  if (flags.json) std::cout << nlohmann::json{{"vehicle", flags.vehicle}, {"out", flags.out}}.dump() << "\n";
  return ok;
}

}  // namespace

void add_trial(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand("trial", "Open-loop manoeuvre of a vehicle: actuators in, states out");
  verb->footer(
      "Example: fairway trial sparus2 --inputs in.csv --out out.csv --set state.u_mps=0.5 --set "
      "current.north_mps=0.2\n"
      "Inputs: columns time_s and the actuators that `fairway describe VEHICLE` shows.");
  auto flags = std::make_shared<TrialFlags>();
  verb->add_option("vehicle", flags->vehicle, "as `fairway list vehicles` shows it")->required();
  verb->add_option("--inputs", flags->inputs, "CSV; - for standard input")->required();
  verb->add_option("--out", flags->out, "CSV to write; - for standard output")->required();
  verb->add_option("--set", flags->settings,
                   "state.*, current.*, actuator_dynamics, step_s or a vehicle's parameter");
  verb->add_flag("--json", flags->json, "print JSON");
  verb->callback(
      [=, &program] { program.chosen = [=, &program] { return trial(*flags, program.catalogs.vehicles); }; });
}

}  // namespace fairway::cli
