// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/trial.hpp"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "fairway/cli/outputs.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/record/output_file.hpp"

namespace fairway::cli {
namespace {

struct TrialFlags {
  std::string vehicle, inputs, out;
  std::vector<std::string> settings;
  bool json{false};
};

int trial(const TrialFlags& flags, const Outputs& outputs, const VehicleCatalog& vehicles) {
  if (flags.json && flags.out == "-")
    throw InputError("--json: --out - goes to standard output, too; expected a file, or no --json");
  outputs.judge({flags.inputs});
  std::istringstream inputs{read_text(flags.inputs)};
  std::ostringstream states;
  run_trial(vehicles, flags.vehicle, inputs, flags.inputs, states, settings_of(flags.settings));
  if (flags.out == "-") {
    std::cout << states.str();
    return ok;
  }
  write_file(flags.out, states.str());
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
  verb->add_option("--inputs", flags->inputs, "CSV; - for standard input")->check(not_empty())->required();
  auto outputs = std::make_shared<Outputs>(*verb);
  outputs->add("--out", flags->out, trial_table, "write the states as CSV; - for standard output")
      ->required();
  verb->add_option("--set", flags->settings,
                   "state.*, current.*, actuator_dynamics, step_s or a vehicle's parameter");
  verb->add_flag("--json", flags->json, "print JSON");
  program.on(*verb, [=, &program] { return trial(*flags, *outputs, program.catalogs.vehicles); });
}

}  // namespace fairway::cli
