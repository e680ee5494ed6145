// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/cli/live.hpp"
#include "fairway/cli/numbers.hpp"
#include "fairway/cli/outcome.hpp"
#include "fairway/cli/outputs.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/cli/runner.hpp"
#include "fairway/record/recording_writer.hpp"

namespace fairway::cli {
namespace {

struct RunOptions {
  std::string file;
  std::string algorithm;
  std::vector<std::string> settings;
  std::optional<std::uint64_t> seed;
  RecordingChoice recording;
  LiveChoice live;
  std::size_t threads{1};
  bool json{false};
};

void print_interrupted(const RunOptions& options, double time) {
  std::cerr << fmt::format("fairway: interrupted at {:.6g} s", time);
  if (!options.recording.file.empty())
    std::cerr << "; " << options.recording.file << " holds the run until then";
  std::cerr << "\n";
}

/// --algorithm replaces what --set would have said of it, but for parameters of single vehicles, or of all.
void refuse_two_algorithms(const RunOptions& options, const Overrides& overrides) {
  for (const auto& [path, value] : overrides) {
    if (options.algorithm.empty()) return;
    if (names_avoider(path))
      throw InputError("--set " + path + ": --algorithm sets it, too; expected one of the two");
    if (path.starts_with("defaults.avoider."))
      throw InputError("--set " + path +
                       ": --algorithm sets the avoider of every vehicle; did you mean vehicles[*]" +
                       path.substr(path.find('.')) + "?");
  }
}

int run(const RunOptions& options, const Outputs& outputs, const Program& program) {
  outputs.judge({options.file, options.algorithm});
  const Overrides overrides = overrides_of(options.settings, options.seed);
  refuse_two_algorithms(options, overrides);
  Scenario scenario = load_scenario(options.file, overrides, options.seed);
  if (!options.algorithm.empty())
    set_algorithm(scenario, options.algorithm, overrides, program.catalogs.avoiders);
  check_expectations(scenario);
  const RunOutcome outcome =
      options.live.asked
          ? run_live(scenario, options.recording, options.live, options.json ? std::cerr : std::cout, program)
          : run_scenario(scenario, options.recording, program, nullptr, options.threads);
  if (!outcome.complete) {
    print_interrupted(options, outcome.simulated_s);
    return interrupted;
  }
  warn_of_misfits(scenario, program);
  const std::vector<Judgement> judgements = judge(scenario, outcome.measures);
  if (options.json) {
    std::cout << document_of(scenario, outcome, judgements).dump(2) << "\n";
  } else {
    print(scenario, outcome, judgements, std::cout);
  }
  const bool all_kept = std::ranges::all_of(judgements, &Judgement::kept);
  return all_kept && !outcome.divergence ? ok : expectation_failed;
}

void add_live(CLI::App& verb, LiveChoice& choice) {
  CLI::Option* live = verb.add_flag("--live", choice.asked,
                                    "show it in a browser on this machine as it is made, until Ctrl-C");
  verb.add_option("--port", choice.port, "of that page; 0: any that is free")
      ->transform(whole_number<std::uint16_t>())
      ->needs(live);
  verb.add_option("--speed", choice.speed, "of the clock, 1 by default; 0: as fast as it can")
      ->transform(finite_number(0.0))
      ->needs(live);
  verb.add_flag("--paused", choice.paused, "begin paused")->needs(live);
  verb.add_flag("--until-done", choice.until_done, "end with the run")->needs(live);
}

}  // namespace

void add_run(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand("run", "Run one scenario; record it if asked");
  verb->footer(
      "Example: fairway run scenarios/cube20_8.yaml --algorithm orca3d --seed 3 --out cube.mcap\n"
      "Exit code 1 if an expectation is not kept, and if the run diverges: then it has no results, and the\n"
      "recording ends before that.");
  auto options = std::make_shared<RunOptions>();
  verb->add_option("scenario", options->file, "scenario file")->check(not_empty())->required();
  verb->add_option("--algorithm", options->algorithm,
                   "for every vehicle, instead of the file's: a name, or a YAML file that tune made")
      ->check(not_empty());
  verb->add_option("--set", options->settings, "path=value, over what the file says");
  verb->add_option("--seed", options->seed, "instead of the file's")
      ->transform(whole_number<std::uint64_t>());
  auto outputs = std::make_shared<Outputs>(*verb);
  CLI::Option* out =
      outputs->add("--out", options->recording.file, recording_file, "record the run to this MCAP file");
  verb->add_flag("--perception", options->recording.perception,
                 "record what each vehicle perceived too: tracks and echoes")
      ->needs(out);
  verb->add_flag("--sketch", options->recording.sketches,
                 "record what each method draws of its thinking, and the messages under way")
      ->needs(out);
  add_live(*verb, options->live);
  verb->add_option("--threads", options->threads,
                   "that go through the vehicles together; the results are the same on any number")
      ->capture_default_str()
      ->transform(whole_number<std::size_t>(1, max_jobs))
      ->excludes("--live");
  verb->add_flag("--json", options->json, "print JSON");
  program.on(*verb, [=, &program] { return run(*options, *outputs, program); });
}

}  // namespace fairway::cli
