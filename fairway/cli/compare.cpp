// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/compare.hpp"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/cli/numbers.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/experiment/store.hpp"
#include "fairway/experiment/stored_results.hpp"

namespace fairway::cli {

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
  verb->add_option("--by", options->by, "label whose values are compared")->capture_default_str();
  verb->add_option("--baseline", options->baseline,
                   "value that the others are compared with; the first of the campaign if not given");
  verb->add_option("--quantity", options->quantities,
                   "quantities; those of the campaign if none is named, or `all`");
  verb->add_option("--confidence", options->confidence, "of each interval")
      ->capture_default_str()
      ->transform(finite_number(0.5, 0.9999));
  verb->add_flag("--csv", *csv, "print every measure of every run as CSV instead");
  verb->add_flag("--json", *json, "print JSON");
  program.on(*verb, [=] {
    const StoredResults results = read_stores(*stores);
    if (*csv) {
      write_csv(std::cout, results.records);
      return ok;
    }
    const Comparison comparison = compare(results.records, options_for(results.origin, *options));
    std::cout << (*json ? to_json(comparison).dump(2) + "\n" : table_text(comparison));
    return ok;
  });
}

}  // namespace fairway::cli
