// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/tune.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "fairway/cli/numbers.hpp"
#include "fairway/cli/outputs.hpp"
#include "fairway/cli/own_methods.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/cli/word_list.hpp"
#include "fairway/core/names.hpp"
#include "fairway/core/text.hpp"
#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/record/output_file.hpp"
#include "fairway/sim/simulation.hpp"
#include "fairway/tuning/tuning_text.hpp"

namespace fairway::cli {
namespace {

struct TuneFlags {
  std::string specification;
  std::vector<std::string> methods;
  std::size_t budget{};
  std::string out;
  std::string shard;
  std::uint64_t seed{1};
  unsigned jobs{0};
  bool json{false};
};

/// What a tuning leaves in its folder.
struct TuneFiles {
  std::string folder;
  std::string parts;  ///< a folder, with the stores of several who search together
  std::string store;
  std::string avoider;
  std::string document;
};

TuneFiles tune_files_in(const std::filesystem::path& folder) {
  return {folder.string(), (folder / "parts").string(), (folder / "runs.sqlite").string(),
          (folder / "best.yaml").string(), (folder / "tuning.json").string()};
}

/// One of the searches that are asked for, with where it leaves what it finds.
struct Task {
  TuningFile tuning;
  TuneFiles files;
};

std::vector<Task> tasks_of(const TuneFlags& flags, const Catalog& methods) {
  TuningSpecification specification =
      parse_tuning_file(read_text(flags.specification), flags.specification, methods);
  std::vector<std::string_view> known;
  for (const TuningFile& tuning : specification.tunings) known.push_back(tuning.method.label);
  for (const std::string& method : flags.methods)
    if (std::ranges::find(known, method) == known.end())
      throw InputError("--methods " + method + ": is not in " + flags.specification +
                       suggestion(method, known));
  std::vector<Task> tasks;
  for (const TuningFile& tuning : specification.tunings) {
    const std::string& label = tuning.method.label;
    if (!flags.methods.empty() && std::ranges::find(flags.methods, label) == flags.methods.end()) continue;
    const std::filesystem::path out{flags.out};
    tasks.push_back({tuning, tune_files_in(specification.is_list ? out / label : out)});
  }
  return tasks;
}

std::vector<std::string> inputs_of(const TuneFlags& flags, const TuningFile& tuning) {
  std::vector<std::string> inputs{flags.specification};
  const std::filesystem::path folder = std::filesystem::path(flags.specification).parent_path();
  for (const TuningSet* set : {&tuning.train, &tuning.validation, &tuning.test})
    for (const CampaignScenarioFile& scenario : set->scenarios)
      inputs.push_back((folder / scenario.path).lexically_normal().string());
  return inputs;
}

/// What the search rests on: the specification and its scenarios, as they are written.
Digest& add_specification(Digest& digest, const TuneFlags& flags, const TuningFile& tuning) {
  for (const std::string& file : inputs_of(flags, tuning)) digest.add(read_text(file));
  return digest;
}

/// By which a result is known to be of this search, whatever the budget.
nlohmann::json search_of(const TuneFlags& flags, const TuningFile& tuning) {
  Digest digest;
  return {{"specification", add_specification(digest, flags, tuning).hex()}, {"seed", flags.seed}};
}

/// A result that is there stays, unless it is of the same search with no larger a budget, or of one by a
/// fairway that did not note whose it was.
void refuse_result_of_another(const TuneFlags& flags, const Task& task) {
  std::ifstream file{task.files.document};
  const nlohmann::json document = nlohmann::json::parse(file, nullptr, false);
  if (!document.is_object() || !document.contains("search")) return;
  if (document["search"] == search_of(flags, task.tuning))
    return refuse_smaller_budget(document, task.files.document, flags.budget);
  throw InputError(
      task.files.document +
      ": is the result of another search: of another specification, scenario or --seed; expected "
      "another --out, or --force to replace it");
}

/// Tells this search from every other that may leave its runs in the same folder.
std::string digest_of(const TuneFlags& flags, const TuningFile& tuning, const Shard& shard) {
  Digest digest;
  digest.add(std::to_string(flags.budget));
  digest.add(std::to_string(flags.seed));
  digest.add(std::to_string(shard.count));
  return add_specification(digest, flags, tuning).hex();
}

RunMaker maker_for(const Program& program) {
  const Catalogs& catalogs = program.catalogs;
  return {
      .check =
          [&](const Scenario& scenario) {
            Simulation{scenario, catalogs};
          },
      .own = own_methods(program),
      .simulate = [&](const Scenario& scenario) { return measure_run(scenario, catalogs, program.stop); }};
}

/// What lies in the folder would go on with numbers that mean something else now.
void refuse_other_epoch(const std::string& store) {
  std::error_code none;
  if (std::filesystem::exists(store, none) && std::filesystem::file_size(store, none) > 0 &&
      is_of_kind(store, store_file))
    Store::open_existing(store).refuse_other_epoch();
}

/// Everything that can be wrong is said before anything is run.
void refuse_mistakes(const TuneFlags& flags, const Task& task, const Outputs& outputs,
                     const Program& program) {
  const TuningFile& tuning = task.tuning;
  for (const TuningSet* set : {&tuning.train, &tuning.validation, &tuning.test})
    expanded(campaign_on(*set, {tuning.method}, 0, 1), flags.specification, maker_for(program).check);
  refuse_small_budget(tuning, flags.budget);
  if (std::filesystem::exists(task.files.folder))
    outputs.judge(inputs_of(flags, tuning), {{"--out", task.files.store, store_file},
                                             {"--out", task.files.avoider, tuned_file},
                                             {"--out", task.files.document, tuning_document}});
  if (!outputs.force()) refuse_result_of_another(flags, task);
  refuse_other_epoch(task.files.store);
}

TuningResult search(const TuneFlags& flags, const Task& task, const Shard& shard, Store::Foreign foreign,
                    const Program& program) {
  const auto& [tuning, files] = task;
  make_folder(shard.is_all() ? files.folder : files.parts, "--out");
  const ExecutorOptions options{.jobs = flags.jobs, .stop = program.stop};
  Progress progress{tuning.name};
  const TuneOptions how{.budget = flags.budget, .seed = flags.seed, .progress = &progress};
  Origin origin{.campaign = tuning.name, .summary = tuning.summary};
  if (shard.is_all()) {
    Store store = Store::open(files.store, foreign);
    store.note(origin);
    TrialRuns runs{flags.specification, maker_for(program), store, options};
    return tune(tuning, runs, how);
  }
  origin.digest = digest_of(flags, tuning, shard);
  Companions companions{files.parts, shard, origin, foreign};
  TrialRuns runs{flags.specification, maker_for(program), companions, options, [](const std::string& file) {
                   std::cerr << "fairway: waits for runs that " << file << " is to have\n";
                 }};
  return tune(tuning, runs, how);
}

/// The command that comes to the same result: without what changes nothing about it, such as the number of
/// threads, the folder and how the methods of one specification were shared out.
std::string command_of(const TuneFlags& flags, const Task& task, const Program& program) {
  const auto& [tuning, files] = task;
  std::string command = program.name + " tune " + shell_word(flags.specification);
  if (files.folder != flags.out) command += " --methods " + shell_word(tuning.method.label);
  command += " --budget " + std::to_string(flags.budget);
  if (flags.seed != TuneFlags{}.seed) command += " --seed " + std::to_string(flags.seed);
  return command + " --out FOLDER";
}

/// Writes a result, and says it unless all are said as JSON in the end.
nlohmann::json write_result(const TuneFlags& flags, const Task& task, const TuningResult& result,
                            const Program& program) {
  const auto& [tuning, files] = task;
  write_file(files.avoider, tuned_avoider(tuning, result, command_of(flags, task, program)));
  nlohmann::json document = to_json(tuning, result);
  document["search"] = search_of(flags, tuning);
  write_file(files.document, document.dump(2) + "\n");
  if (!flags.json)
    std::cout << tuning_text(tuning, result) << "wrote " << files.avoider << "\n" << std::flush;
  return document;
}

int tune_methods(const TuneFlags& flags, const Outputs& outputs, const Program& program) {
  const std::vector<Task> tasks = tasks_of(flags, program.catalogs.avoiders);
  for (const Task& task : tasks) refuse_mistakes(flags, task, outputs, program);
  const Shard shard = flags.shard.empty() ? Shard{} : parse_shard(flags.shard);
  const Store::Foreign foreign = outputs.force() ? Store::Foreign::replace : Store::Foreign::refuse;
  nlohmann::json documents = nlohmann::json::array();
  try {
    for (const Task& task : tasks) {
      const TuningResult result = search(flags, task, shard, foreign, program);
      if (shard.index == 0) documents.push_back(write_result(flags, task, result, program));
    }
  } catch (const RunAbandoned&) {
    std::cerr << "fairway: interrupted; the same command goes on from here\n";
    return *program.terminated && !shard.is_all() ? ok : interrupted;
  }
  const bool is_single = tasks.size() == 1 && tasks.front().files.folder == flags.out;
  if (flags.json && shard.index == 0)
    std::cout << (is_single ? documents.front() : documents).dump(2) << "\n";
  return ok;
}

}  // namespace

void add_tune(CLI::App& app, Program& program) {
  CLI::App* verb =
      app.add_subcommand("tune", "Search for a method's parameters, and judge them on runs not searched on");
  verb->footer("Example: fairway tune campaigns/tuning/orca3d_cube.yaml --budget 2000 --out tuned");
  auto flags = std::make_shared<TuneFlags>();
  auto outputs = std::make_shared<Outputs>(*verb);
  verb->add_option("specification", flags->specification, "what to tune, on what, and on what to judge it")
      ->check(not_empty())
      ->required();
  add_word_list(*verb, "--methods", flags->methods, "of a specification with several, those to tune");
  verb->add_option("--budget", flags->budget,
                   "runs to search with, for each method; those to judge by come on top")
      ->transform(whole_number<std::size_t>(1, max_campaign_runs))
      ->required();
  verb->add_option("--out", flags->out,
                   "folder for the runs, best.yaml and tuning.json, of several methods one in it for each; "
                   "goes on where it is there")
      ->check(not_empty())
      ->required()
      ->type_name("FOLDER");
  verb->add_option(
          "--shard", flags->shard,
          "I/N: makes part I, from 0, of the runs, beside others that make theirs in the same folder; "
          "part 0 writes the result")
      ->check(not_empty())
      ->type_name("I/N");
  verb->add_option("--seed", flags->seed, "of the search")
      ->transform(whole_number<std::uint64_t>())
      ->capture_default_str();
  verb->add_option("--jobs", flags->jobs, "threads; 0 = as many as the machine has")
      ->transform(whole_number(0U, max_jobs))
      ->capture_default_str();
  verb->add_flag("--json", flags->json, "print the result as JSON");
  program.on(*verb, [=, &program] { return tune_methods(*flags, *outputs, program); });
}

}  // namespace fairway::cli
