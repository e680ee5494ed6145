// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/diff.hpp"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"

namespace fairway::cli {
namespace {

nlohmann::json document_of(const Difference& difference) {
  nlohmann::json document{{"same", difference.same()},
                          {"setup", difference.setup},
                          {"compared_frames", difference.compared},
                          {"only_in_a", difference.only_in_a},
                          {"only_in_b", difference.only_in_b}};
  if (difference.first) {
    document["first"] = {{"tick", count(difference.first->tick)},
                         {"time_s", difference.first->time},
                         {"vehicle", difference.first->vehicle},
                         {"quantity", difference.first->quantity},
                         {"a", difference.first->a},
                         {"b", difference.first->b}};
  }
  if (difference.farthest) {
    document["farthest"] = {{"distance_m", difference.farthest->distance},
                            {"time_s", difference.farthest->time},
                            {"vehicle", difference.farthest->vehicle}};
  }
  return document;
}

}  // namespace

void add_diff(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand("diff", "Where two recordings part; exit code 1 if they do");
  verb->footer("Example: fairway diff before.mcap after.mcap");
  auto files = std::make_shared<std::vector<std::string>>();
  auto json = std::make_shared<bool>(false);
  verb->add_option("recordings", *files, "two MCAP files")->check(not_empty())->required()->expected(2);
  verb->add_flag("--json", *json, "print JSON");
  program.on(*verb, [=] {
    const Difference difference = diff(Recording::read((*files)[0]), Recording::read((*files)[1]));
    std::cout << (*json ? document_of(difference).dump(2) + "\n" : difference.describe());
    return difference.same() ? ok : expectation_failed;
  });
}

}  // namespace fairway::cli
