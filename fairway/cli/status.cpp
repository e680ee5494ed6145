// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>

#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/cli/scheduler.hpp"
#include "fairway/core/error.hpp"
#include "fairway/experiment/submission.hpp"

namespace fairway::cli {
namespace {

/// What is told of a submission.
struct Standing {
  std::size_t runs{};
  std::size_t made{};
  std::size_t failed{};
  std::uint32_t whole{};
  std::vector<std::uint32_t> running, waiting;         ///< as the scheduler says
  std::vector<std::uint32_t> begun, missing, damaged;  ///< that nobody works at
  std::map<std::uint32_t, std::string> errors;         ///< of these, with which some ended
  bool is_merged{};
  double runs_per_s{};
  double left_s{};
  std::string silent;  ///< why the scheduler does not answer, or empty

  std::size_t to_repeat() const { return begun.size() + missing.size() + damaged.size(); }
};

Standing standing_of(const Submission& s) {
  Standing standing;
  std::map<std::uint32_t, std::string> queued;
  try {
    if (s.engine == "slurm") queued = slurm::queued(s.jobs);
  } catch (const InputError& error) {
    standing.silent = error.what();
  }
  const std::vector<ShardProgress> progress = progress_of(s);
  for (std::uint32_t shard = 0; shard < s.shards(); ++shard) {
    const ShardProgress& at = progress[shard];
    standing.runs += s.runs[shard];
    standing.made += at.runs;
    standing.failed += at.failed;
    if (at.state == ShardState::whole) {
      ++standing.whole;
    } else if (const auto task = queued.find(shard); task != queued.end()) {
      (task->second == "PENDING" ? standing.waiting : standing.running).push_back(shard);
    } else {
      (at.state == ShardState::damaged ? standing.damaged
       : at.state == ShardState::begun ? standing.begun
                                       : standing.missing)
          .push_back(shard);
      if (std::string error = error_of(s, shard); !error.empty()) standing.errors[shard] = std::move(error);
    }
  }
  standing.is_merged = is_merged(s);
  const double now =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  const double elapsed_s = now - s.submitted_s;
  if (standing.made > s.present && elapsed_s > 0.0)
    standing.runs_per_s = static_cast<double>(standing.made - s.present) / elapsed_s;
  if (standing.runs_per_s > 0.0)
    standing.left_s = static_cast<double>(standing.runs - standing.made) / standing.runs_per_s;
  return standing;
}

nlohmann::json document_of(const Submission& s, const Standing& at) {
  nlohmann::json errors = nlohmann::json::object();
  for (const auto& [shard, error] : at.errors) errors[std::to_string(shard)] = error;
  return {{"campaign", s.campaign},
          {"engine", s.engine},
          {"shards", s.shards()},
          {"whole", at.whole},
          {"running", at.running},
          {"waiting", at.waiting},
          {"begun", at.begun},
          {"missing", at.missing},
          {"damaged", at.damaged},
          {"errors", std::move(errors)},
          {"runs", at.runs},
          {"made", at.made},
          {"failed", at.failed},
          {"runs_per_s", at.runs_per_s},
          {"left_s", at.left_s},
          {"merged", at.is_merged ? nlohmann::json(s.merged()) : nlohmann::json()},
          {"repeat", at.to_repeat() > 0 ? nlohmann::json(s.typed) : nlohmann::json()}};
}

void print_list(const char* what, const std::vector<std::uint32_t>& shards) {
  if (!shards.empty())
    std::cout << fmt::format("  {:<10} {:>5}  {}\n", what, shards.size(), ranges_text(shards));
}

void print(const Submission& s, const Standing& at) {
  std::cout << fmt::format("{}: {} of {} runs, {} of them failed, {} of {} shards\n", s.campaign, at.made,
                           at.runs, at.failed, at.whole, s.shards());
  print_list("running", at.running);
  print_list("waiting", at.waiting);
  print_list("begun", at.begun);
  print_list("missing", at.missing);
  print_list("damaged", at.damaged);
  for (const auto& [shard, error] : at.errors)
    std::cout << fmt::format("  shard {} failed: {}\n", shard, error);
  if (at.whole < s.shards() && at.runs_per_s > 0.0)
    std::cout << fmt::format("{:.3g} runs/s since it was submitted, {:.0f} s left at that rate\n",
                             at.runs_per_s, at.left_s);
  if (at.is_merged) std::cout << "merged: " << s.merged() << "\n";
  if (at.to_repeat() > 0 && at.silent.empty())
    std::cout << (s.engine != "slurm" ? "unless that is still at work, this" : "nobody works at these; this")
              << " makes what is not whole:\n  " << s.typed << "\n";
}

}  // namespace

void add_status(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand("status", "How far a submitted campaign is, and what to repeat of it");
  verb->footer("Example: fairway status methods");
  auto folder = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  verb->add_option("folder", *folder, "that fairway submit wrote")->check(not_empty())->required();
  verb->add_flag("--json", *json, "print JSON");
  program.on(*verb, [=] {
    const Submission submission = read_submission(*folder);
    const Standing standing = standing_of(submission);
    if (*json) {
      std::cout << document_of(submission, standing).dump(2) << "\n";
    } else {
      print(submission, standing);
    }
    if (standing.silent.empty()) return ok;
    std::cerr << "fairway: " << standing.silent << "\n";
    return bad_input;
  });
}

}  // namespace fairway::cli
