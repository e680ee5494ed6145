// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/merge.hpp"

#include <fmt/format.h>

#include <atomic>
#include <filesystem>
#include <iostream>
#include <memory>

#include "fairway/cli/outputs.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/experiment/local_store.hpp"

namespace fairway::cli {
namespace {

struct MergeFlags {
  std::vector<std::string> stores;
  std::string out;
  bool json{false};
};

void print_merged(const MergeFlags& flags, const MergeReport& report) {
  if (flags.json) {
    const nlohmann::json document{{"campaign", report.origin.campaign},
                                  {"stores", flags.stores.size()},
                                  {"runs", report.runs},
                                  {"others", report.runs - report.of_campaign},
                                  {"failed", report.failed},
                                  {"missing", report.missing()},
                                  {"makers", report.origin.makers},
                                  {"remark", remark_on(report.origin.makers)}};
    std::cout << document.dump(2) << "\n";
    return;
  }
  std::cout << fmt::format("{}: {} runs from {} stores, {} of them failed, {} missing\n", flags.out,
                           report.runs, flags.stores.size(), report.failed, report.missing());
  if (report.of_campaign < report.runs)
    std::cout << fmt::format("{} of these are of another campaign, or of another version of {}\n",
                             report.runs - report.of_campaign, report.origin.campaign);
  for (const std::string& kind : kinds_of(report.origin.makers)) std::cout << "made by " << kind << "\n";
  if (const std::string remark = remark_on(report.origin.makers); !remark.empty())
    std::cout << remark << "\n";
  if (report.missing() > 0)
    std::cout << fmt::format("fairway sweep CAMPAIGN --missing {0} --out {0} makes what is missing\n",
                             flags.out);
}

int merge(const MergeFlags& flags, const Outputs& outputs, const Program& program) {
  const std::atomic<bool>* const stop = program.stop;  // from here on the first signal ends in order
  // what is at --out may be among what is merged, and is merged anyway
  std::vector<std::string> others;
  std::error_code none;
  for (const std::string& file : flags.stores) {
    if (!std::filesystem::equivalent(file, flags.out, none)) others.push_back(file);
  }
  outputs.judge(others);
  LocalStore merged{flags.out, outputs.force() ? Store::Foreign::replace : Store::Foreign::refuse};
  const MergeReport report = merge_into(merged.store(), flags.out, flags.stores);
  if (*stop) {
    std::cerr << "fairway: interrupted; nothing was written\n";
    return interrupted;
  }
  merged.publish();
  print_merged(flags, report);
  return ok;
}

}  // namespace

void add_merge(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand("merge", "Put the stores of a campaign's shards together");
  verb->footer(
      "Example: fairway merge parts/*.db --out all.db\nIn any order, and again when there are more of them.");
  auto flags = std::make_shared<MergeFlags>();
  verb->add_option("results", flags->stores, "results stores of one campaign")
      ->check(not_empty())
      ->required();
  auto outputs = std::make_shared<Outputs>(*verb);
  outputs->add("--out", flags->out, store_file, "results store to write; what it holds already is kept")
      ->required();
  verb->add_flag("--json", flags->json, "print what was merged as JSON");
  program.on(*verb, [=, &program] { return merge(*flags, *outputs, program); });
}

}  // namespace fairway::cli
