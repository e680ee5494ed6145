// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "fairway/cli/numbers.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/cli/runner.hpp"
#include "fairway/core/text.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::cli {
namespace {

/// What a collision is, which the vehicles' radii do not say.
std::string collision_rule(const Scenario& scenario) {
  return "a collision is centres within " + number_text(scenario.exam.safety_distance_m) +
         " m (exam.safety_distance_m), whatever the radii";
}

/// The avoider of each vehicle, with the wrappers that its tracking asks for.
std::vector<std::string> avoiders_of(const Scenario& scenario, const Simulation& simulation,
                                     const Catalog& avoiders) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i)
    names.push_back(avoider_in_force(scenario.vehicles[i], simulation.agents()[i].ship().limits,
                                     scenario.obstacles, avoiders));
  return names;
}

/// The scenario as it is resolved, with the collision rule beside every vehicle's radius, and beside its
/// avoider what comes of it.
std::string annotated(const Scenario& scenario, const std::vector<std::string>& avoiders) {
  std::istringstream lines{to_yaml(scenario)};
  std::string text;
  bool in_vehicles = false;
  std::size_t vehicle = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(' ')) in_vehicles = line == "vehicles:";
    if (in_vehicles && line.starts_with("    avoider:")) {
      if (avoiders[vehicle] != scenario.vehicles[vehicle].avoider->name)
        line += "  # in force: " + avoiders[vehicle];
      ++vehicle;
    }
    if (in_vehicles && line.starts_with("    radius_m: ")) line += "  # " + collision_rule(scenario);
    text += line + "\n";
  }
  return text;
}

}  // namespace

void add_check(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand("check", "Validate scenarios; print each as it is resolved");
  verb->footer("Example: fairway check scenarios/head_on.yaml --set exam.crit_dist_m=7");
  auto files = std::make_shared<std::vector<std::string>>();
  auto settings = std::make_shared<std::vector<std::string>>();
  auto seed = std::make_shared<std::optional<std::uint64_t>>();
  auto json = std::make_shared<bool>(false);
  auto schema = std::make_shared<bool>(false);
  verb->add_option("files", *files, "scenario files")->check(not_empty());
  verb->add_option("--set", *settings, "path=value, over what the file says");
  verb->add_option("--seed", *seed, "instead of the file's")->transform(whole_number<std::uint64_t>());
  verb->add_flag("--schema", *schema, "print the JSON schema of scenario files instead");
  verb->add_flag("--json", *json, "print JSON");
  program.on(*verb, [=, &program] {
    if (*schema) {
      std::cout << scenario_schema();
      return ok;
    }
    if (files->empty()) throw InputError("check: name at least one scenario file");
    nlohmann::json document = nlohmann::json::array();
    for (const std::string& file : *files) {
      const Scenario scenario = load_scenario(file, overrides_of(*settings, *seed), *seed);
      check_expectations(scenario);
      const Simulation simulation{scenario, program.catalogs};  // the catalogs check what they are asked for
      const std::vector<std::string> avoiders = avoiders_of(scenario, simulation, program.catalogs.avoiders);
      warn_of_misfits(scenario, program);
      if (*json) {
        document.push_back({{"file", file},
                            {"name", scenario.name},
                            {"resolved", to_yaml(scenario)},
                            {"avoiders", avoiders},
                            {"collision_rule", collision_rule(scenario)}});
      } else {
        std::cout << (files->size() > 1 ? "# " + file + "\n" : "") << annotated(scenario, avoiders);
      }
    }
    if (*json) std::cout << document.dump(2) << "\n";
    return ok;
  });
}

}  // namespace fairway::cli
