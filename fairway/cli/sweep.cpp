// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "fairway/cli/numbers.hpp"
#include "fairway/cli/outputs.hpp"
#include "fairway/cli/own_methods.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/experiment/campaign.hpp"
#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/stored_results.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::cli {
namespace {

struct SweepFlags {
  std::string campaign;
  std::string out;
  unsigned jobs{0};
  bool retry{false};
  bool json{false};
};

/// The store that --out names, or one in memory.
Store store_for(const SweepFlags& flags, const Outputs& outputs, const Campaign& campaign) {
  if (flags.out.empty()) return Store::in_memory();
  std::vector<std::string> inputs{flags.campaign};
  for (const CampaignScenario& scenario : campaign.scenarios) inputs.push_back(scenario.file);
  outputs.judge(inputs);
  return Store::open(flags.out, outputs.force() ? Store::Foreign::replace : Store::Foreign::refuse);
}

int sweep(const SweepFlags& flags, const Outputs& outputs, const Program& program) {
  const Catalogs& catalogs = program.catalogs;
  const std::atomic<bool>* stop = program.stop;
  const auto check = [&](const Scenario& scenario) { Simulation{scenario, catalogs}; };
  const Campaign campaign = load_campaign(flags.campaign, check, flags.jobs, own_methods(program));
  Store store = store_for(flags, outputs, campaign);
  Progress progress{campaign.name};
  const ExecutorReport report = run_campaign(
      campaign, [&](const Scenario& scenario) { return measure_run(scenario, catalogs, stop); }, store,
      {.jobs = flags.jobs, .progress = &progress, .stop = stop, .retry_failures = flags.retry});
  if (report.stopped) {
    std::cerr << fmt::format("fairway: interrupted after {} runs; the same command goes on from here\n",
                             report.made);
    return interrupted;
  }
  const Comparison comparison = compare(records_of(campaign, store), options_for(origin_of(campaign), {}));
  if (flags.json) {
    std::cout << to_json(comparison).dump(2) << "\n";
  } else {
    std::cout << fmt::format("{}: {} runs made, {} were there\n", campaign.name, report.made, report.present)
              << table_text(comparison);
  }
  return report.failed == 0 ? ok : expectation_failed;
}

}  // namespace

void add_sweep(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand(
      "sweep", "Run a campaign: scenarios x algorithms x settings x seeds; only what is missing");
  verb->footer("Example: fairway sweep campaigns/methods.yaml --out methods.sqlite");
  auto flags = std::make_shared<SweepFlags>();
  verb->add_option("campaign", flags->campaign, "campaign file")->required();
  auto outputs = std::make_shared<Outputs>(*verb);
  outputs->add("--out", flags->out, store_file, "results store to write; continued if it is there");
  verb->add_option("--jobs", flags->jobs, "threads; 0 = as many as the machine has")
      ->transform(whole_number(0U, max_jobs))
      ->capture_default_str();
  verb->add_flag("--retry-failures", flags->retry, "make failed runs again");
  verb->add_flag("--json", flags->json, "print the comparison as JSON");
  program.on(*verb, [=, &program] { return sweep(*flags, *outputs, program); });
}

}  // namespace fairway::cli
