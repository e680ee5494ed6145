// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/cli/numbers.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/cli/runner.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::cli {

void add_check(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand("check", "Validate scenarios; print each as it is resolved");
  verb->footer("Example: fairway check scenarios/head_on.yaml --set exam.crit_dist_m=7");
  auto files = std::make_shared<std::vector<std::string>>();
  auto settings = std::make_shared<std::vector<std::string>>();
  auto seed = std::make_shared<std::optional<std::uint64_t>>();
  auto json = std::make_shared<bool>(false);
  auto schema = std::make_shared<bool>(false);
  verb->add_option("files", *files, "scenario files");
  verb->add_option("--set", *settings, "path=value, over what the file says");
  verb->add_option("--seed", *seed, "instead of the file's")->transform(whole_number<std::uint64_t>());
  verb->add_flag("--schema", *schema, "print the JSON schema of scenario files instead");
  verb->add_flag("--json", *json, "print JSON");
  verb->callback([=, &program] {
    program.chosen = [=, &program] {
      if (*schema) {
        std::cout << scenario_schema();
        return ok;
      }
      if (files->empty()) throw InputError("check: name at least one scenario file");
      nlohmann::json document = nlohmann::json::array();
      for (const std::string& file : *files) {
        const Scenario scenario = load_scenario(file, overrides_of(*settings), *seed);
        check_expectations(scenario);
        const Simulation simulation{scenario,
                                    program.catalogs};  // the catalogs check what they are asked for
        if (*json) {
          document.push_back({{"file", file}, {"name", scenario.name}, {"resolved", to_yaml(scenario)}});
        } else {
          std::cout << (files->size() > 1 ? "# " + file + "\n" : "") << to_yaml(scenario);
        }
      }
      if (*json) std::cout << document.dump(2) << "\n";
      return ok;
    };
  });
}

}  // namespace fairway::cli
