// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/submission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <string_view>
#include <utility>

#include "fairway/core/error.hpp"
#include "fairway/core/text.hpp"
#include "fairway/experiment/store.hpp"

namespace fairway {
namespace {

// a scheduler's warning before the end: time to store what is done
constexpr unsigned warning_s = 60;

/// "0:30:00".
std::string clock_text(unsigned seconds) {
  return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

/// A path in an #SBATCH line, in which a % begins a pattern.
std::string in_pattern(const std::string& path) {
  std::string text;
  for (const char c : path) text += c == '%' ? "%%" : std::string(1, c);
  return text;
}

/// A word of an #SBATCH line, which Slurm takes apart as a shell does.
std::string in_quotes(const std::string& word) {
  std::string text = "\"";
  for (const char c : word) text += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  return text + "\"";
}

std::string sweep_command(const Submission& s, const std::string& shard, const std::string& jobs) {
  return fmt::format("{} sweep {} --shard \"{}/{}\" --jobs {}{} --out {}/parts/\"{}\".db",
                     shell_word(s.program), shell_word(s.file), shard, s.shards(), jobs, s.options,
                     shell_word(s.folder), shard);
}

std::string merge_command(const Submission& s) {
  return fmt::format("{} merge {}/parts/*.db --out {}", shell_word(s.program), shell_word(s.folder),
                     shell_word(s.merged()));
}

std::string head(const Submission& s) {
  const auto [runs, total_s] = std::pair{std::accumulate(s.runs.begin(), s.runs.end(), std::size_t{0}),
                                         std::accumulate(s.expected_s.begin(), s.expected_s.end(), 0.0)};
  return fmt::format(
      "#!/bin/bash\n"
      "# Campaign {}: {} runs in {} shards of about {:.3g} s each on {} cores. Written by `fairway submit`; "
      "keep it and edit "
      "it as you\n"
      "# like. A shard that is whole is left as it is, and one that was begun goes on.\n",
      s.campaign, runs, s.shards(), total_s / s.shards() / s.cores, s.cores);
}

std::string slurm_shards(const Submission& s, std::span<const std::uint32_t> shards) {
  return head(s) + fmt::format(
                       "#SBATCH --job-name={0}\n"
                       "#SBATCH --array={1}%{2}\n"
                       "#SBATCH --nodes=1 --ntasks=1 --cpus-per-task={3}\n"
                       "#SBATCH --time={4}\n"
                       "#SBATCH --requeue --open-mode=append --signal=B:TERM@{5}\n"
                       "#SBATCH --output=\"{6}/logs/%a.log\"\n"
                       "exec {7}\n",
                       in_quotes(s.campaign), ranges_text(shards), s.nodes, s.cores, clock_text(s.limit_s),
                       std::min(warning_s, s.limit_s / 4), in_pattern(s.folder),
                       sweep_command(s, "$SLURM_ARRAY_TASK_ID", "\"$SLURM_CPUS_PER_TASK\""));
}

std::string local_shards(const Submission& s, std::span<const std::uint32_t> shards) {
  std::string list;
  for (const std::uint32_t shard : shards) list += " " + std::to_string(shard);
  return head(s) + fmt::format(
                       "# Makes the shards that it is told, or else those of the list, {0} at a time, and "
                       "merges them.\n"
                       "stop() {{ stopped=1; kill -TERM $(jobs -p) 2>/dev/null; }}\n"
                       "trap stop TERM INT\n"
                       "[ $# -gt 0 ] || set --{1}\n"
                       "for shard; do\n"
                       "  while [ \"$(jobs -rp | wc -l)\" -ge {0} ]; do wait -n; done\n"
                       "  [ -z \"$stopped\" ] || break\n"
                       "  {2} >>{3}/logs/\"$shard\".log 2>&1 &\n"
                       "done\n"
                       "while [ -n \"$(jobs -rp)\" ]; do wait; done\n"
                       "exec bash {3}/merge.sh\n",
                       s.nodes, list, sweep_command(s, "$shard", std::to_string(s.cores)),
                       shell_word(s.folder));
}

std::string mpi_job(const Submission& s) {
  return head(s) + fmt::format(
                       "# It runs here, in the allocation that it is in, or by `sbatch shards.sh`.\n"
                       "#SBATCH --job-name={0}\n"
                       "#SBATCH --nodes={1} --ntasks-per-node={2}\n"
                       "#SBATCH --time={3}\n"
                       "#SBATCH --requeue --open-mode=append\n"
                       "#SBATCH --output=\"{4}/logs/mpi.log\"\n"
                       "exec mpirun -n {5} {6}_mpi {7} --out {8}{9}\n",
                       in_quotes(s.campaign), s.nodes, s.cores, clock_text(s.limit_s), in_pattern(s.folder),
                       std::max(2U, s.nodes * s.cores), shell_word(s.program), shell_word(s.file),
                       shell_word(s.merged()), s.options);
}

}  // namespace

std::string Submission::part(std::uint32_t shard) const {
  return engine == "mpi" ? merged() : folder + "/parts/" + std::to_string(shard) + ".db";
}

std::string Submission::said(std::uint32_t shard) const {
  return folder + "/logs/" + (engine == "mpi" ? "mpi" : std::to_string(shard)) + ".log";
}

Submission read_submission(const std::string& folder) {
  const std::string file = (std::filesystem::path(folder) / submission_file).string();
  std::ifstream text{file};
  if (!text) throw InputError(file + ": cannot be read; `fairway submit ... --out " + folder + "` writes it");
  try {
    Submission submission = nlohmann::json::parse(text).get<Submission>();
    if (submission.runs.empty() || submission.expected_s.size() != submission.runs.size())
      throw InputError(file + ": is no submission: its shards are not listed");
    return submission;
  } catch (const nlohmann::json::exception&) {
    throw InputError(file + ": is no submission of fairway, or a damaged one");
  }
}

std::uint32_t shard_count(const ShardSizing& sizing) {
  const double core_s = sizing.total_s / sizing.cores;
  const double long_enough = std::floor(core_s / least_shard_s);
  const double short_enough = std::ceil(core_s / (0.5 * sizing.limit_s));
  const double wanted = std::min(long_enough, std::max(4.0 * sizing.nodes, short_enough));
  const double most = std::min(static_cast<double>(sizing.most), static_cast<double>(sizing.runs));
  double count = std::max(1.0, std::min(wanted, most));
  if (count > sizing.nodes) count -= std::fmod(count, sizing.nodes);  // no node is alone with a last one
  return static_cast<std::uint32_t>(count);
}

std::string ranges_text(std::span<const std::uint32_t> numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += (text.empty() ? "" : ",") + std::to_string(numbers[i]);
    if (last > i) text += "-" + std::to_string(numbers[last]);
    i = last + 1;
  }
  return text;
}

std::string shards_script(const Submission& submission, std::span<const std::uint32_t> shards) {
  if (submission.engine == "slurm") return slurm_shards(submission, shards);
  return submission.engine == "mpi" ? mpi_job(submission) : local_shards(submission, shards);
}

std::string merge_script(const Submission& s) {
  if (s.engine == "mpi") return "";
  std::string script =
      "#!/bin/bash\n# Puts the shards together that are there. Written by `fairway submit`.\n";
  if (s.engine == "slurm") {
    script += fmt::format(
        "#SBATCH --job-name={}\n#SBATCH --ntasks=1 --requeue --open-mode=append\n"
        "#SBATCH --output=\"{}/logs/merge.log\"\n",
        in_quotes(s.campaign + "-merge"), in_pattern(s.folder));
  }
  return script + "exec " + merge_command(s) + "\n";
}

std::vector<ShardProgress> progress_of(const Submission& submission) {
  std::vector<ShardProgress> all;
  for (std::uint32_t shard = 0; shard < submission.shards(); ++shard) {
    ShardProgress& progress = all.emplace_back();
    const std::string part = submission.part(shard);
    if (!std::filesystem::exists(part)) continue;
    try {
      const Store store = Store::open_existing(part);
      const bool is_of_it = store.origin().digest == submission.digest;
      progress.runs = is_of_it ? store.campaign_size() : 0;
      progress.failed = is_of_it ? store.campaign_failed_count() : 0;
      progress.state = !is_of_it                                 ? ShardState::damaged
                       : progress.runs >= submission.runs[shard] ? ShardState::whole
                                                                 : ShardState::begun;
    } catch (const InputError&) {
      progress.state = ShardState::damaged;
    }
  }
  return all;
}

std::string error_of(const Submission& submission, std::uint32_t shard) {
  constexpr std::string_view says = "fairway: ", warns = "fairway: warning: ",
                             was_told_to_stop = "the same command goes on from here";
  std::ifstream log{submission.said(shard)};
  std::string last;
  for (std::string line; std::getline(log, line);) last = line;
  if (!last.starts_with(says) || last.starts_with(warns) || last.ends_with(was_told_to_stop)) return "";
  return last.substr(says.size());
}

bool is_merged(const Submission& s) {
  try {
    const std::size_t runs = std::accumulate(s.runs.begin(), s.runs.end(), std::size_t{0});
    const Store store = Store::open_existing(s.merged());
    return store.origin().digest == s.digest && store.campaign_size() >= runs;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace fairway
