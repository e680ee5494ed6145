// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "fairway/cli/decide/decide.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/sim/catalogs.hpp"

namespace fairway::cli {

void add_decide(CLI::App& app, Program& program) {
  CLI::App* verb =
      app.add_subcommand("decide", "JSON lines: situations on standard input, commands on standard output");
  verb->footer(
      "Example: echo "
      "'{\"time\":0,\"period\":0.1,\"own\":{\"id\":0,\"position\":[0,0,0],\"velocity\":[0.5,0,0],\"yaw\":0,"
      "\"radius\":1},\"goal\":{\"position\":[50,0,0]},\"limits\":{\"max_speed\":0.5},\"tracks\":[],"
      "\"obstacles\":[]}' "
      "| fairway decide --algorithm orca3d --set time_horizon_s=5");
  auto algorithm = std::make_shared<std::string>();
  auto settings = std::make_shared<std::vector<std::string>>();
  auto keep = std::make_shared<bool>(false);
  auto json = std::make_shared<bool>(false);
  verb->add_option("--algorithm", *algorithm, "as `fairway list algorithms` shows it")->required();
  verb->add_option("--set", *settings, "parameter=value");
  verb->add_flag("--keep-memory", *keep, "each own id keeps its avoider from line to line");
  verb->add_flag("--json", *json, "accepted for symmetry: the output is JSON lines anyway");
  program.on(*verb, [=, &program] {
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    decide_lines(std::cin, std::cout, program.catalogs.avoiders, {*algorithm, settings_of(*settings), *keep});
    return ok;
  });
}

}  // namespace fairway::cli
