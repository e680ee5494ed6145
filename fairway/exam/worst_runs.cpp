// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/worst_runs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "fairway/exam/exam_page_tables.hpp"
#include "fairway/studies/page_blocks.hpp"

namespace fairway {
namespace {

using nlohmann::json;

/// The least is the worst.
auto soundness(const ExamOutcome& outcome) {
  return std::tuple{outcome.is_safe(), outcome.all_arrived(), outcome.clearance_m};
}

std::string command_to_play(const ExamRun& run) {
  std::string command = fmt::format("{}{} --out worst.mcap; fairway view worst.mcap", run.command, run.seed);
  if (has_instant(run.outcome))
    command += fmt::format("; fairway explain worst.mcap --vehicle {:.0f} --time {:g}",
                           run.outcome.worst_vehicle, run.outcome.worst_time_s);
  return command;
}

}  // namespace

std::vector<WorstRun> worst_runs(const ExamTable& table) {
  std::map<std::pair<std::string, std::string>, WorstRun> found;
  for (const ExamCell& cell : table.cells) {
    if (cell.is_baseline) continue;
    for (const ExamRun* run : cell.runs) {
      if (std::isnan(run->outcome.clearance_m) || run->command.empty()) continue;
      WorstRun& worst = found[{cell.family, cell.name()}];
      if (worst.run == nullptr || soundness(run->outcome) < soundness(worst.run->outcome))
        worst = {&cell, run};
    }
  }
  std::vector<WorstRun> runs;
  runs.reserve(found.size());
  for (const auto& [key, worst] : found) runs.push_back(worst);
  return runs;
}

std::string_view worst_of(const ExamOutcome& outcome) {
  if (!outcome.is_safe()) return "collision";
  return outcome.all_arrived() ? "least clearance" : "not all arrived";
}

bool has_instant(const ExamOutcome& outcome) {
  return outcome.worst_vehicle >= 0.0 && std::isfinite(outcome.worst_time_s);
}

json worst_table(std::span<const WorstRun> worst, const std::function<json(const ExamRun&)>& place_of) {
  json rows = json::array();
  for (const auto& [cell, run] : worst)
    rows.push_back({{"family", cell->family},
                    {"method", cell->name()},
                    {"condition", cell->condition},
                    {"what", worst_of(run->outcome)},
                    {"clearance", page::number(run->outcome.clearance_m)},
                    {"time", page::number(run->outcome.worst_time_s)},
                    {"command", command_to_play(*run)},
                    {"$runs", place_of(*run)}});
  return {{"kind", "table"},
          {"title", "The worst run of each method in each family"},
          {"columns",
           {column("family", "Family", "text"), column("method", "Method", "text"),
            column("condition", "Condition", "text"), column("what", "What", "text"),
            column("clearance", "Clearance [m]", "number", 2), column("time", "At [s]", "number", 1),
            column("command", "To play and explain it", "text")}},
          {"rows", std::move(rows)},
          {"filter", {"family", "method", "condition", "what"}},
          {"note",
           "Of runs with a collision the one that left the least clearance; where there is none, of those in "
           "which not all arrived; where all did, of all. A row leads to its run, and where there is one, to "
           "its playback."}};
}

}  // namespace fairway
