// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <thread>

#include "fairway/cli/numbers.hpp"
#include "fairway/cli/outputs.hpp"
#include "fairway/cli/own_methods.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/cli/scheduler.hpp"
#include "fairway/core/text.hpp"
#include "fairway/experiment/campaign.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/submission.hpp"
#include "fairway/record/output_file.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct SubmitFlags {
  std::string campaign;
  std::string engine;
  std::string out;
  std::string time{"00:30"};
  unsigned nodes{1};
  unsigned cores{0};
  unsigned shards{0};
  bool no_host{false};
  bool dry_run{false};
  bool json{false};
};

constexpr FileKind script_file{
    .name = "a script of fairway submit", .begins = "#!/bin/bash\n", .holds = "Written by `fairway submit`"};
constexpr FileKind plan_file{.name = "a submission of fairway", .begins = "{", .holds = "\"campaign\": "};

/// "HH:MM" or "HH:MM:SS" in seconds.
unsigned seconds_of(const std::string& time) {
  unsigned hours = 0;
  unsigned minutes = 0;
  unsigned seconds = 0;
  int end = 0;
  const int size = static_cast<int>(time.size());
  const bool is_short = std::sscanf(time.c_str(), "%3u:%2u%n", &hours, &minutes, &end) == 2 && end == size;
  const bool is_time =
      is_short ||
      (std::sscanf(time.c_str(), "%3u:%2u:%2u%n", &hours, &minutes, &seconds, &end) == 3 && end == size);
  const unsigned total = hours * 3600 + minutes * 60 + seconds;
  const bool is_plain = time.find_first_not_of("0123456789:") == std::string::npos;
  if (!is_time || !is_plain || minutes > 59 || seconds > 59 || total < 60)
    throw InputError("--time " + time + ": expected HH:MM or HH:MM:SS, at least 00:01");
  return total;
}

/// How long a run takes on one core, from as much of it as is made within `patience` [s].
double time_of_run(const Scenario& scenario, const Program& program, double patience) {
  Simulation simulation{scenario, program.catalogs};
  RunMetrics metrics = metrics_for(scenario, program.catalogs.vehicles);
  const std::vector<FrameSink*> sinks{&metrics};
  const Clock::time_point begin = Clock::now();
  double elapsed = 0.0;
  while (!simulation.is_done() && elapsed < patience) {
    simulation.step(sinks);
    elapsed = std::chrono::duration<double>(Clock::now() - begin).count();
  }
  return simulation.is_done() ? elapsed : elapsed * scenario.duration_s / simulation.time();
}

/// Seconds for one unit of expected_cost(), by a run of each cell, for a few seconds in all. `sample` has the
/// first run of every cell. Where there are too many cells for that, the others are taken to be like these.
double seconds_per_cost(const Campaign& sample, const Program& program) {
  constexpr double patience = 0.5;
  constexpr double patience_in_all = 4.0;
  const Clock::time_point begin = Clock::now();
  double seconds = 0.0;
  double cost = 0.0;
  for (std::size_t i = 0; i < sample.specs.size(); ++i) {
    if (std::chrono::duration<double>(Clock::now() - begin).count() > patience_in_all) break;
    const Scenario scenario = sample.scenario_of(i);
    seconds += time_of_run(scenario, program, patience);
    cost += expected_cost(scenario);
  }
  return cost > 0.0 ? seconds / cost : 0.0;
}

/// Absolute, and the same however it was spelled.
std::string absolute(const std::string& path) { return fs::weakly_canonical(fs::absolute(path)).string(); }

/// The command by its path: what started it (scripts/build --portable) says so, or else its own file.
std::string this_program() {
  if (const char* told = std::getenv("FAIRWAY_PROGRAM"); told != nullptr) return told;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? "fairway" : program.string();
}

/// Cores of a shard that were not told: those of a node, or a machine's share.
unsigned default_cores(const SubmitFlags& flags) {
  if (flags.engine == "slurm") return flags.dry_run ? 1 : slurm::cores_of_a_node();
  return std::max(1U, std::thread::hardware_concurrency() / flags.nodes);
}

Submission planned(const SubmitFlags& flags, const Program& program) {
  const auto check = [&](const Scenario& scenario) { Simulation{scenario, program.catalogs}; };
  const Campaign sample = load_cells(flags.campaign, check, 0, own_methods(program));
  Submission s{.campaign = sample.name,
               .file = absolute(flags.campaign),
               .digest = sample.digest,
               .folder = absolute(flags.out),
               .engine = flags.engine,
               .program = this_program(),
               .options = flags.no_host ? " --no-host" : "",
               .typed = program.typed,
               .nodes = flags.nodes,
               .cores = flags.cores > 0 ? flags.cores : default_cores(flags),
               .limit_s = seconds_of(flags.time)};
  const double unit_s = seconds_per_cost(sample, program);
  const double total = plan_of(sample, 1).costs.front();
  if (flags.engine == "mpi" && flags.shards > 0)
    throw InputError(
        fmt::format("--shards {}: --engine mpi hands out single runs, and cuts no shards", flags.shards));
  std::uint32_t count = flags.engine == "mpi" ? 1 : flags.shards;
  const std::uint32_t most = flags.engine == "slurm" && !flags.dry_run ? slurm::most_tasks() : 1001;
  if (count == 0) {
    count = shard_count({.total_s = total * unit_s,
                         .runs = sample.run_count(),
                         .nodes = s.nodes,
                         .cores = s.cores,
                         .limit_s = s.limit_s,
                         .most = most});
  } else if (flags.engine == "slurm" && count > most) {
    throw InputError(
        fmt::format("--shards {}: this Slurm takes {} tasks in an array (MaxArraySize)", count, most));
  }
  const ShardPlan plan = plan_of(sample, count);
  s.runs = plan.runs;
  for (const double cost : plan.costs) s.expected_s.push_back(cost * unit_s);
  return s;
}

/// The submission that the folder holds already, if it does: its shards stay as they were cut.
void go_on_with_former(Submission& s, const SubmitFlags& flags) {
  const fs::path file = fs::path(s.folder) / submission_file;
  if (!fs::exists(file) || !is_of_kind(file.string(), plan_file)) return;
  Submission former = read_submission(s.folder);
  if (former.digest != s.digest) {
    throw InputError(s.folder + ": holds " +
                     (former.campaign == s.campaign ? "another version of campaign "
                                                    : "campaign " + former.campaign + ", not ") +
                     s.campaign + "; submit it to another folder");
  }
  if (former.engine != s.engine)
    throw InputError(s.folder + ": was submitted by --engine " + former.engine +
                     "; go on with that, or in another folder");
  if (flags.shards > 0 && flags.shards != former.shards())
    throw InputError(
        fmt::format("--shards {}: {} was cut into {}, and stays so; leave it out, or submit to another "
                    "folder",
                    flags.shards, s.folder, former.shards()));
  s.runs = std::move(former.runs);
  s.expected_s = std::move(former.expected_s);
  s.jobs = std::move(former.jobs);
}

void set_aside(const std::string& damaged) {
  std::error_code error;
  fs::rename(damaged, damaged + ".damaged", error);
  if (error) throw InputError(damaged + ": is damaged, and cannot be moved aside: " + error.message());
}

/// Shards that are not whole and not among `queued`. A damaged store is moved aside for them to be made
/// again.
std::vector<std::uint32_t> shards_to_make(Submission& s, const std::map<std::uint32_t, std::string>& queued) {
  const std::vector<ShardProgress> progress = progress_of(s);
  std::vector<std::uint32_t> shards;
  s.present = 0;
  for (std::uint32_t shard = 0; shard < s.shards(); ++shard) {
    s.present += progress[shard].runs;
    if (progress[shard].state == ShardState::whole || queued.contains(shard)) continue;
    if (progress[shard].state == ShardState::damaged) set_aside(s.part(shard));
    shards.push_back(shard);
  }
  return shards;
}

/// What is written into the folder.
std::vector<Output> files_of(const Submission& s) {
  return {{"--out", s.folder + "/shards.sh", script_file},
          {"--out", s.folder + "/merge.sh", script_file},
          {"--out", s.folder + "/" + submission_file, plan_file},
          {"--out", s.merged(), store_file}};
}

void make_folders(const Submission& s) {
  for (const char* part : {"/parts", "/logs"}) make_folder(s.folder + part, "--out");
}

/// So that the error of an attempt before is not taken for one of that which begins.
void note_another_attempt(const std::string& log) {
  if (fs::exists(log)) std::ofstream{log, std::ios::app} << "---- sent again\n";
}

void write_submission(const Submission& s) {
  write_file(s.folder + "/" + submission_file, nlohmann::json(s).dump(1) + "\n");
}

/// Sends the shards, and the merge behind them; says so on `out`.
void send(Submission& s, const std::vector<std::uint32_t>& shards, std::ostream& out) {
  std::vector<std::string> merge_options;
  if (!shards.empty()) {
    const std::string job = slurm::send({}, s.folder + "/shards.sh");
    s.jobs.push_back(job);
    write_submission(s);
    out << fmt::format("job {}: {} shards, {} at a time\n", job, shards.size(), s.nodes);
    merge_options.push_back("--dependency=afterany:" + job);
  }
  out << fmt::format("job {}: merges them\n", slurm::send(merge_options, s.folder + "/merge.sh"));
}

/// Becomes the script that makes the shards here and merges them.
[[noreturn]] void run_here(const Submission& s, bool quietly) {
  if (s.engine == "mpi" && !fs::exists(s.program + "_mpi"))
    throw InputError(s.program +
                     "_mpi: is not there; it is built where MPI is installed (scripts/deps cluster)");
  std::cout << std::flush;
  const std::string script = s.folder + "/shards.sh";
  if (quietly && std::freopen("/dev/null", "w", stdout) == nullptr)
    throw InputError("/dev/null: cannot be opened");
  ::execlp("bash", "bash", script.c_str(), nullptr);
  throw InputError("bash: cannot be started");
}

int submit(const SubmitFlags& flags, const Outputs& outputs, const Program& program) {
  Submission s = planned(flags, program);
  if (!flags.dry_run && fs::exists(s.folder)) outputs.judge({flags.campaign}, files_of(s));
  go_on_with_former(s, flags);
  if (flags.dry_run) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t shard = 0; shard < s.shards(); ++shard) all.push_back(shard);
    std::cout << (flags.json ? nlohmann::json(s).dump(1) : shards_script(s, all) + "\n" + merge_script(s))
              << "\n";
    return ok;
  }
  const auto queued = s.engine == "slurm" ? slurm::queued(s.jobs) : std::map<std::uint32_t, std::string>{};
  const std::vector<std::uint32_t> shards = shards_to_make(s, queued);
  if (shards.empty() && (!queued.empty() || is_merged(s))) {
    std::cout << (flags.json       ? nlohmann::json(s).dump(1)
                  : queued.empty() ? s.merged() + " is there, and no shard is missing"
                                   : "every shard that is not whole is under way; nothing was sent")
              << "\n";
    return ok;
  }
  make_folders(s);
  for (const std::uint32_t shard : shards) note_another_attempt(s.said(shard));
  s.submitted_s = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  write_file(s.folder + "/shards.sh", shards_script(s, shards));
  if (const std::string script = merge_script(s); !script.empty()) write_file(s.folder + "/merge.sh", script);
  write_submission(s);
  std::ostringstream said;
  if (s.engine == "slurm") {
    send(s, shards, said);
  } else {
    said << fmt::format("{} of {} shards, {} at a time\n", shards.size(), s.shards(), s.nodes);
  }
  said << "fairway status " << shell_word(s.folder) << " says how far they are\n";
  std::cout << (flags.json ? nlohmann::json(s).dump(1) + "\n" : said.str());
  if (s.engine != "slurm") run_here(s, flags.json);
  return ok;
}

}  // namespace

void add_submit(CLI::App& app, Program& program) {
  CLI::App* verb =
      app.add_subcommand("submit", "Have several machines run a campaign: shards of it, and then a merge");
  verb->footer(
      "Example: fairway submit campaigns/methods.yaml --engine slurm --nodes 8 --time 00:30 --out methods\n"
      "The same command again sends what is missing. `fairway status methods` says how far it is.");
  auto flags = std::make_shared<SubmitFlags>();
  verb->add_option("campaign", flags->campaign, "campaign file")->check(not_empty())->required();
  verb->add_option("--engine", flags->engine,
                   "slurm; local: processes on this machine; or mpi: one job of Open MPI")
      ->required()
      ->check(CLI::IsMember({"slurm", "local", "mpi"}));
  verb->add_option("--out", flags->out,
                   "folder for scripts, shards and the merged store all.db; all machines see it")
      ->check(not_empty())
      ->required()
      ->type_name("FOLDER");
  verb->add_option("--nodes", flags->nodes, "shards at a time")
      ->transform(whole_number(1U, 100'000U))
      ->capture_default_str();
  verb->add_option("--cores", flags->cores, "of each shard; 0 = as many as a node has")
      ->transform(whole_number(0U, max_jobs))
      ->capture_default_str();
  verb->add_option("--time", flags->time, "wall time that a shard may take, as HH:MM")->capture_default_str();
  verb->add_option("--shards", flags->shards, "how many; 0 = so many that each takes at least 30 s")
      ->transform(whole_number(0U, max_shards))
      ->capture_default_str();
  auto outputs = std::make_shared<Outputs>(*verb);
  verb->add_flag("--no-host", flags->no_host, "keep the machines' names out of the stores");
  verb->add_flag("--dry-run", flags->dry_run, "print the scripts, and neither write nor send anything");
  verb->add_flag("--json", flags->json, "print the submission as JSON");
  program.on(*verb, [=, &program] { return submit(*flags, *outputs, program); });
}

}  // namespace fairway::cli
