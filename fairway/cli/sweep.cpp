// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <system_error>

#include "fairway/cli/listing.hpp"
#include "fairway/cli/numbers.hpp"
#include "fairway/cli/outputs.hpp"
#include "fairway/cli/own_methods.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/experiment/campaign.hpp"
#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/local_store.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/stored_results.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::cli {
namespace {

struct SweepFlags {
  std::string campaign;
  std::string out;
  std::string shard;
  std::string missing;
  unsigned jobs{0};
  bool retry{false};
  bool no_host{false};
  bool json{false};

  /// Whether what is missing is to be made in the very store that lacks it.
  bool fills() const {
    std::error_code none;
    return !missing.empty() && std::filesystem::equivalent(missing, out, none);
  }

  /// Of a part of the campaign, the rest of which is elsewhere, nothing is compared.
  bool is_of_part() const { return !shard.empty() || (!missing.empty() && !fills()); }
};

/// Where the runs are stored: a file, on local disk first for a shard, or memory.
class SweepStore {
 public:
  SweepStore(const SweepFlags& flags, Store::Foreign foreign) {
    if (flags.out.empty()) {
      store_.emplace(Store::in_memory());
    } else if (flags.shard.empty()) {
      store_.emplace(Store::open(flags.out, foreign));
    } else {
      local_.emplace(flags.out, foreign);
    }
  }

  Store& get() { return local_ ? local_->store() : *store_; }

  /// Has what is stored stand under its name, where it does not by itself.
  void publish() {
    if (local_) local_->publish();
    published_ = Clock::now();
  }

  /// The same, but not often: whoever looks how far it is, or is killed, is at most a minute behind.
  void publish_now_and_then() {
    if (Clock::now() - published_ > std::chrono::minutes{1}) publish();
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::optional<Store> store_;
  std::optional<LocalStore> local_;
  Clock::time_point published_{Clock::now()};
};

void judge_outputs(const SweepFlags& flags, const Outputs& outputs, const Campaign& campaign) {
  std::vector<std::string> inputs{flags.campaign};
  for (const CampaignScenario& scenario : campaign.scenarios) inputs.push_back(scenario.file);
  for (const CampaignCell& cell : campaign.cells) inputs.push_back(cell.place.where.file);
  if (!flags.fills()) inputs.push_back(flags.missing);
  outputs.judge(inputs);
}

/// A shard goes on in a store of its own campaign alone: it is to be merged.
void refuse_other_campaign(const SweepFlags& flags, const Campaign& campaign, const Store& store) {
  const Origin origin = store.origin();
  if (flags.shard.empty() || origin.digest.empty() || origin.digest == campaign.digest) return;
  throw InputError(flags.out + ": holds a shard of " +
                   (origin.campaign == campaign.name ? "another version of campaign "
                                                     : "campaign " + origin.campaign + ", not of ") +
                   campaign.name + "; write to another file");
}

/// Whoever reads the store has to know of runs in it that are none of this campaign as it is now.
void tell_of_others(const SweepFlags& flags, const Store& store) {
  const std::size_t others = store.size() - store.campaign_size();
  if (others == 0 || flags.out.empty()) return;
  std::cerr << fmt::format(
      "fairway: warning: {} holds {} runs of another campaign, or of another version of this one\n",
      flags.out, others);
}

/// Leaves out the runs that the store of --missing has.
void leave_out_stored(const SweepFlags& flags, Campaign& campaign) {
  if (flags.missing.empty() || flags.fills()) return;
  const Store store = Store::open_existing(flags.missing);
  keep_runs(campaign, [&](const RunSpec& spec) {
    const Store::Status status = store.status(spec.key);
    return status == Store::Status::missing || (status == Store::Status::failed && flags.retry);
  });
}

/// Of the runs that were there already, for behind their count.
std::string failed_before(const ExecutorReport& report) {
  return report.failed_before > 0 ? fmt::format(", {} of them failed", report.failed_before) : "";
}

void print_part(const SweepFlags& flags, const Campaign& campaign, const ExecutorReport& report) {
  const std::size_t failed = report.failed + report.failed_before;
  if (flags.json) {
    const nlohmann::json document{{"campaign", campaign.name},          {"shard", text_of(campaign.shard)},
                                  {"runs", campaign.specs.size()},      {"made", report.made},
                                  {"present", report.present},          {"failed", failed},
                                  {"of_campaign", campaign.run_count()}};
    std::cout << document.dump(2) << "\n";
    return;
  }
  const std::string part = flags.shard.empty() ? "missing from " + flags.missing : "shard " + flags.shard;
  std::cout << fmt::format("{}, {}: {} of {} runs; {} made, {} of them failed, {} were there{}\n",
                           campaign.name, part, campaign.specs.size(), campaign.run_count(), report.made,
                           report.failed, report.present, failed_before(report));
}

/// What is stored is kept, so SIGTERM, by which a scheduler ends a job, is no failure.
int stopped(const SweepFlags& flags, const ExecutorReport& report, const Program& program) {
  const bool is_kept = !flags.out.empty();
  std::cerr << fmt::format("fairway: {} after {} runs; {}\n",
                           *program.terminated ? "terminated" : "interrupted", report.made,
                           is_kept ? "the same command goes on from here" : "nothing was kept (no --out)");
  return *program.terminated && is_kept ? ok : interrupted;
}

Campaign listed_campaign(const SweepFlags& flags, const CheckScenario& check, const Program& program) {
  Listing listing{flags.campaign, program.stop};
  return load_campaign(flags.campaign, check, flags.jobs, own_methods(program),
                       flags.shard.empty() ? Shard{} : parse_shard(flags.shard), std::ref(listing));
}

int sweep(const SweepFlags& flags, const Outputs& outputs, const Program& program) {
  if (!flags.shard.empty() && flags.out.empty()) throw InputError("--shard needs --out, where its runs go");
  if (!flags.missing.empty()) {
    if (flags.out.empty()) throw InputError("--missing needs --out, where its runs go");
    if (!std::filesystem::exists(flags.missing))
      throw InputError("--missing " + flags.missing + ": no such results store");
  }
  const Catalogs& catalogs = program.catalogs;
  const std::atomic<bool>* stop = program.stop;
  const auto check = [&](const Scenario& scenario) { Simulation{scenario, catalogs}; };
  Campaign campaign;
  try {
    campaign = listed_campaign(flags, check, program);
  } catch (const RunAbandoned&) {
    return stopped(flags, {}, program);
  }
  if (!flags.out.empty()) judge_outputs(flags, outputs, campaign);
  leave_out_stored(flags, campaign);
  SweepStore store{flags, outputs.force() ? Store::Foreign::replace : Store::Foreign::refuse};
  refuse_other_campaign(flags, campaign, store.get());
  store.get().refuse_other_epoch();
  store.get().note(this_maker(!flags.shard.empty() && !flags.no_host));
  Progress progress{campaign.name};
  const ExecutorReport report = run_campaign(
      campaign, [&](const Scenario& scenario) { return measure_run(scenario, catalogs, stop); }, store.get(),
      {.jobs = flags.jobs, .progress = &progress, .stop = stop, .retry_failures = flags.retry, .stored = [&] {
         store.publish_now_and_then();
       }});
  store.publish();
  tell_of_others(flags, store.get());
  if (report.stopped) return stopped(flags, report, program);
  if (flags.is_of_part()) {
    print_part(flags, campaign, report);
  } else {
    const Comparison comparison =
        compare(records_of(campaign, store.get()), options_for(origin_of(campaign), {}));
    if (flags.json) {
      std::cout << to_json(comparison).dump(2) << "\n";
    } else {
      std::cout << fmt::format("{}: {} runs made, {} were there{}\n", campaign.name, report.made,
                               report.present, failed_before(report))
                << table_text(comparison);
    }
  }
  return report.failed + report.failed_before == 0 ? ok : expectation_failed;
}

}  // namespace

void add_sweep(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand(
      "sweep", "Run a campaign: scenarios x algorithms x settings x seeds; only what is missing");
  verb->footer(
      "Example: fairway sweep campaigns/methods.yaml --out methods.sqlite\n"
      "On several machines: fairway sweep campaigns/methods.yaml --shard 3/64 --out part3.sqlite, and then "
      "fairway merge");
  auto flags = std::make_shared<SweepFlags>();
  verb->add_option("campaign", flags->campaign, "campaign file")->check(not_empty())->required();
  auto outputs = std::make_shared<Outputs>(*verb);
  outputs->add("--out", flags->out, store_file, "results store to write; continued if it is there");
  verb->add_option("--shard", flags->shard, "only part I of N, from 0; --out then appears when it is whole")
      ->check(not_empty())
      ->type_name("I/N");
  verb->add_option("--missing", flags->missing, "only what this results store does not have")
      ->check(not_empty())
      ->type_name("STORE");
  verb->add_option("--jobs", flags->jobs, "threads; 0 = as many as the machine has")
      ->transform(whole_number(0U, max_jobs))
      ->capture_default_str();
  verb->add_flag("--retry-failures", flags->retry, "make failed runs again");
  verb->add_flag("--no-host", flags->no_host, "keep the machine's name out of a shard's store");
  verb->add_flag("--json", flags->json, "print the comparison as JSON");
  program.on(*verb, [=, &program] { return sweep(*flags, *outputs, program); });
}

}  // namespace fairway::cli
