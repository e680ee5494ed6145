// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/cli/outcome.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/cli/runner.hpp"

namespace fairway::cli {
namespace {

std::vector<std::string> scenario_files(const std::string& directory) {
  if (!std::filesystem::is_directory(directory)) throw InputError(directory + ": not a folder of scenarios");
  std::vector<std::string> files;
  for (const auto& file : std::filesystem::recursive_directory_iterator(directory)) {
    if (file.path().extension() == ".yaml") files.push_back(file.path().string());
  }
  if (files.empty()) throw InputError(directory + ": holds no scenario (*.yaml)");
  std::ranges::sort(files);
  return files;
}

int test(const std::string& directory, bool as_json, const Program& program) {
  nlohmann::json document = nlohmann::json::array();
  int passed = 0, failed = 0;
  for (const std::string& file : scenario_files(directory)) {
    const Scenario scenario = load_scenario(file);
    check_expectations(scenario);
    const RunOutcome outcome = run_scenario(scenario, {}, program);
    if (!outcome.complete) return interrupted;
    if (outcome.divergence) {
      ++failed;
      const std::string text = divergence_text(scenario, outcome);
      if (!as_json) std::cout << fmt::format("FAILED {:<36} {}\n", file, text);
      document.push_back({{"file", file}, {"metric", "outcome"}, {"diverged", text}, {"kept", false}});
    }
    for (const Judgement& judgement : judge(scenario, outcome.measures)) {
      ++(judgement.kept ? passed : failed);
      if (!as_json)
        std::cout << fmt::format("{} {:<36} {}\n", judgement.kept ? "kept  " : "FAILED", file,
                                 text_of(judgement));
      document.push_back(document_of(judgement));
      document.back()["file"] = file;
    }
  }
  if (as_json) {
    std::cout << document.dump(2) << "\n";
  } else {
    std::cout << fmt::format("{} kept, {} failed\n", passed, failed);
  }
  return failed == 0 ? ok : expectation_failed;
}

}  // namespace

void add_test(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand("test", "Run every scenario of a folder and hold it to its `expect:`");
  verb->footer("Example: fairway test scenarios");
  auto directory = std::make_shared<std::string>(shipped("scenarios"));
  auto as_json = std::make_shared<bool>(false);
  verb->add_option("directory", *directory, "folder")->check(not_empty())->capture_default_str();
  verb->add_flag("--json", *as_json, "print JSON");
  program.on(*verb, [=, &program] { return test(*directory, *as_json, program); });
}

}  // namespace fairway::cli
