// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/cli/numbers.hpp"
#include "fairway/cli/outputs.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/core/text.hpp"
#include "fairway/view/explain/explain_recording.hpp"
#include "fairway/view/playback.hpp"

namespace fairway::cli {
namespace {

struct ExplainFlags {
  std::string recording;
  std::string vehicle;
  std::string page;
  double time{};
  bool json{false};
};

std::string cell_text(const ExplanationTable::Cell& cell) {
  const auto* number = std::get_if<double>(&cell);
  if (number == nullptr) return std::get<std::string>(cell);
  // what is a whole number, or short as it was written, is shown so
  const std::string exact = number_text(*number);
  return exact.size() <= 6 ? exact : fmt::format("{:.4g}", *number);
}

/// Numbers and words in columns; the last column is as long as it is.
void print_table(const ExplanationTable& table) {
  std::vector<std::vector<std::string>> lines{table.columns};
  for (const auto& row : table.rows) {
    lines.emplace_back();
    std::ranges::transform(row, std::back_inserter(lines.back()), cell_text);
  }
  std::vector<std::size_t> widths(table.columns.size());
  for (const auto& line : lines) {
    for (std::size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], line[k].size());
  }
  for (const auto& line : lines) {
    std::string text = " ";
    for (std::size_t k = 0; k < line.size(); ++k) {
      text += k + 1 == line.size() ? " " + line[k] : fmt::format(" {:<{}}", line[k], widths[k] + 1);
    }
    std::cout << text << "\n";
  }
}

void print(const Explanation& explanation) {
  std::cout << explanation.headline << "\n";
  for (const ExplanationSection& section : explanation.sections) {
    std::cout << "\n" << section.title << "\n";
    for (const std::string& line : section.lines) std::cout << "  " << line << "\n";
    if (!section.table.columns.empty()) print_table(section.table);
  }
}

int explain(const ExplainFlags& flags, const Outputs& outputs, const Program& program) {
  outputs.judge({flags.recording});
  const Recording recording = Recording::read(flags.recording);
  const auto explained =
      explain_recording(recording, {flags.recording, flags.vehicle, flags.time, flags.page, program.typed},
                        program.catalogs, program.stop);
  if (!explained) {
    std::cerr << "fairway: interrupted\n";
    return interrupted;
  }
  if (flags.json) {
    std::cout << exact_json(explained->scenario, explained->found, explained->explanation).dump(2) << "\n";
  } else {
    print(explained->explanation);
    if (!recording.divergence().empty()) std::cout << "\nthe run later " << recording.divergence() << "\n";
    if (!flags.page.empty()) std::cout << "\npage: " << flags.page << "\n";
  }
  return explained->found.difference ? expectation_failed : ok;
}

}  // namespace

void add_explain(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand(
      "explain",
      "Why a vehicle did what it did: one decision of a recorded run, asked again, in words and numbers");
  verb->footer(
      "Example: fairway explain cube.mcap --vehicle auv_2 --time 31.5 --out why.html\n"
      "The run is simulated again until then; exit code 1 if the command found is not the recorded one.");
  auto flags = std::make_shared<ExplainFlags>();
  verb->add_option("recording", flags->recording, "MCAP file written by `fairway run --out`")
      ->check(not_empty())
      ->required();
  verb->add_option("--vehicle", flags->vehicle, "its name, id or index")->required();
  verb->add_option("--time", flags->time,
                   "s since the start; the last recorded frame at or before it is taken")
      ->required()
      ->transform(finite_number());
  auto outputs = std::make_shared<Outputs>(*verb);
  outputs->add("--out", flags->page, playback_file,
               "write an HTML page of the 30 s before and after, with what was thought");
  verb->add_flag("--json", flags->json, "print JSON, every number exact");
  program.on(*verb, [=, &program] { return explain(*flags, *outputs, program); });
}

}  // namespace fairway::cli
