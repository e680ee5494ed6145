// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/compare.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "fairway/cli/numbers.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/core/error.hpp"
#include "fairway/core/names.hpp"
#include "fairway/experiment/store.hpp"
#include "fairway/experiment/stored_results.hpp"

namespace fairway::cli {
namespace {

/// Leaves the measures of these quantities alone; all of them where none is named, or `all`.
void keep_quantities(std::vector<RunRecord>& records, const std::vector<std::string>& quantities) {
  if (quantities.empty() || quantities == std::vector<std::string>{"all"}) return;
  std::set<std::string> measured;
  for (RunRecord& record : records) {
    std::erase_if(record.measures, [&](const Measure& m) {
      measured.insert(m.quantity);
      return std::ranges::find(quantities, m.quantity) == quantities.end();
    });
  }
  for (const std::string& quantity : quantities)
    if (!measured.contains(quantity))
      throw InputError("no run measured " + quantity +
                       suggestion(quantity, {measured.begin(), measured.end()}));
}

}  // namespace

void add_compare(CLI::App& app, Program& program) {
  CLI::App* verb =
      app.add_subcommand("compare", "Compare stored results, paired by seed, with confidence intervals");
  verb->footer(
      "Example: fairway compare methods.sqlite --by method --baseline orca3d --quantity navigation_time_s");
  auto stores = std::make_shared<std::vector<std::string>>();
  auto options = std::make_shared<CompareOptions>();
  auto csv = std::make_shared<bool>(false);
  auto json = std::make_shared<bool>(false);
  verb->add_option("results", *stores, "results stores")->check(not_empty())->required();
  CLI::Option* by =
      verb->add_option("--by", options->by, "label whose values are compared")->capture_default_str();
  CLI::Option* baseline =
      verb->add_option("--baseline", options->baseline,
                       "value that the others are compared with; the first of the campaign if not given");
  verb->add_option("--quantity", options->quantities,
                   "quantities; those of the campaign if none is named, or `all`");
  CLI::Option* confidence = verb->add_option("--confidence", options->confidence, "of each interval")
                                ->capture_default_str()
                                ->transform(finite_number(0.5, 0.9999));
  verb->add_flag("--mixed", options->mixed,
                 "take stores of several results epochs, or versions of a campaign, together");
  CLI::Option* as_json = verb->add_flag("--json", *json, "print JSON");
  CLI::Option* as_csv = verb->add_flag(
      "--csv", *csv, "print every measure of every run as CSV instead, or those of --quantity");
  for (CLI::Option* other : {by, baseline, confidence, as_json}) as_csv->excludes(other);
  program.on(*verb, [=] {
    StoredResults results =
        read_stores(*stores, options->mixed || (*csv && stores->size() == 1) ? Together::compared_mixed
                                                                             : Together::compared);
    if (*csv) {
      keep_quantities(results.records, options->quantities);
      write_csv(std::cout, results.records);
      return ok;
    }
    const Comparison comparison = compare(results.records, options_for(results.origin, *options));
    std::cout << (*json ? to_json(comparison).dump(2) + "\n" : table_text(comparison));
    return ok;
  });
}

}  // namespace fairway::cli
