// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/tune.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "fairway/cli/numbers.hpp"
#include "fairway/cli/outputs.hpp"
#include "fairway/cli/own_methods.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/record/output_file.hpp"
#include "fairway/sim/simulation.hpp"
#include "fairway/tuning/tuning_text.hpp"

namespace fairway::cli {
namespace {

struct TuneFlags {
  std::string specification;
  std::size_t budget{};
  std::string out;
  std::string shard;
  std::uint64_t seed{1};
  unsigned jobs{0};
  bool json{false};
};

/// What a tuning leaves in its folder.
struct TuneFiles {
  std::string parts;  ///< a folder, with the stores of several who search together
  std::string store;
  std::string avoider;
  std::string document;
};

TuneFiles files_in(const std::string& folder) {
  const std::filesystem::path out{folder};
  return {(out / "parts").string(), (out / "runs.sqlite").string(), (out / "best.yaml").string(),
          (out / "tuning.json").string()};
}

std::vector<std::string> inputs_of(const TuneFlags& flags, const TuningFile& tuning) {
  std::vector<std::string> inputs{flags.specification};
  const std::filesystem::path folder = std::filesystem::path(flags.specification).parent_path();
  for (const TuningSet* set : {&tuning.train, &tuning.validation, &tuning.test})
    for (const CampaignScenarioFile& scenario : set->scenarios)
      inputs.push_back((folder / scenario.path).lexically_normal().string());
  return inputs;
}

/// Tells this search from every other that may leave its runs in the same folder.
std::string digest_of(const TuneFlags& flags, const TuningFile& tuning, const Shard& shard) {
  Digest digest;
  digest.add(std::to_string(flags.budget));
  digest.add(std::to_string(flags.seed));
  digest.add(std::to_string(shard.count));
  for (const std::string& file : inputs_of(flags, tuning)) digest.add(read_text(file));
  return digest.hex();
}

void write_result(const TuneFlags& flags, const TuneFiles& files, const TuningFile& tuning,
                  const TuningResult& result, const Program& program) {
  write_file(files.avoider, tuned_avoider(tuning, result, program.typed));
  const nlohmann::json document = to_json(tuning, result);
  write_file(files.document, document.dump(2) + "\n");
  std::cout << (flags.json ? document.dump(2) + "\n"
                           : tuning_text(tuning, result) + "wrote " + files.avoider + "\n");
}

int tune_method(const TuneFlags& flags, const Outputs& outputs, const Program& program) {
  const Catalogs& catalogs = program.catalogs;
  const TuningFile tuning =
      parse_tuning_file(read_text(flags.specification), flags.specification, catalogs.avoiders);
  const TuneFiles files = files_in(flags.out);
  refuse_small_budget(tuning, flags.budget);
  const auto check = [&](const Scenario& scenario) { Simulation{scenario, catalogs}; };
  for (const TuningSet* set : {&tuning.train, &tuning.validation, &tuning.test})
    expanded({.scenarios = set->scenarios, .algorithms = {tuning.method}, .first_seed = set->first_seed},
             flags.specification, check);
  const Shard shard = flags.shard.empty() ? Shard{} : parse_shard(flags.shard);
  if (std::filesystem::exists(flags.out)) {
    outputs.judge(inputs_of(flags, tuning), {{"--out", files.store, store_file},
                                             {"--out", files.avoider, tuned_file},
                                             {"--out", files.document, tuning_document}});
  }
  std::filesystem::create_directories(shard.is_all() ? flags.out : files.parts);
  const Store::Foreign foreign = outputs.force() ? Store::Foreign::replace : Store::Foreign::refuse;
  const RunMaker maker{
      .check = check, .own = own_methods(program), .simulate = [&](const Scenario& scenario) {
        return measure_run(scenario, catalogs, program.stop);
      }};
  const ExecutorOptions options{.jobs = flags.jobs, .stop = program.stop};
  std::optional<Store> store;
  std::optional<Companions> companions;
  std::optional<TrialRuns> runs;
  Origin origin{.campaign = tuning.name, .summary = tuning.summary};
  if (shard.is_all()) {
    store.emplace(Store::open(files.store, foreign));
    store->note(origin);
    runs.emplace(flags.specification, maker, *store, options);
  } else {
    origin.digest = digest_of(flags, tuning, shard);
    companions.emplace(files.parts, shard, origin, foreign);
    runs.emplace(flags.specification, maker, *companions, options, [](const std::string& file) {
      std::cerr << "fairway: waits for runs that " << file << " is to have\n";
    });
  }
  Progress progress{tuning.name};
  try {
    const TuningResult result =
        tune(tuning, *runs, {.budget = flags.budget, .seed = flags.seed, .progress = &progress});
    if (shard.index == 0) write_result(flags, files, tuning, result, program);
  } catch (const RunAbandoned&) {
    std::cerr << "fairway: interrupted; the same command goes on from here\n";
    return *program.terminated && !shard.is_all() ? ok : interrupted;
  }
  return ok;
}

}  // namespace

void add_tune(CLI::App& app, Program& program) {
  CLI::App* verb =
      app.add_subcommand("tune", "Search for a method's parameters, and judge them on runs not searched on");
  verb->footer("Example: fairway tune campaigns/tuning/orca3d_cubes.yaml --budget 2000 --out tuned");
  auto flags = std::make_shared<TuneFlags>();
  auto outputs = std::make_shared<Outputs>(*verb);
  verb->add_option("specification", flags->specification, "what to tune, on what, and on what to judge it")
      ->required();
  verb->add_option("--budget", flags->budget, "runs to search with; those to judge by come on top")
      ->transform(whole_number<std::size_t>(1, max_campaign_runs))
      ->required();
  verb->add_option("--out", flags->out,
                   "folder for the runs, best.yaml and tuning.json; goes on where it is there")
      ->required()
      ->type_name("FOLDER");
  verb->add_option(
          "--shard", flags->shard,
          "I/N: makes part I, from 0, of the runs, beside others that make theirs in the same folder; "
          "part 0 writes the result")
      ->type_name("I/N");
  verb->add_option("--seed", flags->seed, "of the search")
      ->transform(whole_number<std::uint64_t>())
      ->capture_default_str();
  verb->add_option("--jobs", flags->jobs, "threads; 0 = as many as the machine has")
      ->transform(whole_number(0U, max_jobs))
      ->capture_default_str();
  verb->add_flag("--json", flags->json, "print the result as JSON");
  program.on(*verb, [=, &program] { return tune_method(*flags, *outputs, program); });
}

}  // namespace fairway::cli
