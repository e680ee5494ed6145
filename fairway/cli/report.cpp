// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "fairway/cli/outputs.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/experiment/stored_results.hpp"
#include "fairway/report/page.hpp"
#include "fairway/report/results_page.hpp"

namespace fairway::cli {

void add_report(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand("report", "Stored results as one self-contained HTML page");
  verb->footer("Example: fairway report methods.sqlite --baseline orca3d --out report.html");
  auto stores = std::make_shared<std::vector<std::string>>();
  auto out = std::make_shared<std::string>("report.html");
  auto options = std::make_shared<CompareOptions>();
  auto json = std::make_shared<bool>(false);
  verb->add_option("results", *stores, "results stores")->check(not_empty())->required();
  auto outputs = std::make_shared<Outputs>(*verb);
  CLI::Option* written =
      outputs->add("--out", *out, report_file, "write the page here")->capture_default_str();
  verb->add_option("--by", options->by, "label whose values are compared")->capture_default_str();
  verb->add_option("--baseline", options->baseline,
                   "value that the others are compared with; the first of the campaign if not given");
  verb->add_option("--quantity", options->quantities,
                   "quantities; those of the campaign if none is named, or `all`");
  verb->add_flag("--mixed", options->mixed,
                 "take stores of several results epochs, or versions of a campaign, together");
  verb->add_flag("--json", *json, "print the page's document as JSON instead of writing the page")
      ->excludes(written);
  program.on(*verb, [=, &program] {
    if (!*json) outputs->judge(*stores);
    const nlohmann::json page =
        results_page(read_stores(*stores, options->mixed ? Together::compared_mixed : Together::compared),
                     *options, program.typed);
    if (*json) {
      std::cout << page.dump(2) << "\n";
    } else {
      write_page(page.dump(), *out);
      std::cout << "report: " << *out << "\n";
    }
    return ok;
  });
}

}  // namespace fairway::cli
