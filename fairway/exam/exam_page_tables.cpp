// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/exam_page_tables.hpp"

#include <fmt/format.h>

#include <utility>

namespace fairway {

using nlohmann::json;

json column(const char* key, const char* label, const char* type, int digits) {
  json column{{"key", key}, {"label", label}, {"type", type}};
  if (digits >= 0) column["digits"] = digits;
  return column;
}

json decisions_table(std::span<const DecisionTime> times) {
  json rows = json::array();
  for (const DecisionTime& each : times)
    rows.push_back({{"family", each.family},
                    {"method", each.tuned ? each.method + ", tuned" : each.method},
                    {"decisions", each.decisions},
                    {"mean", each.mean_us},
                    {"worst", each.worst_us}});
  return {{"kind", "table"},
          {"title", "Time to decide, of one run under the first condition"},
          {"columns",
           {column("family", "Family", "text"), column("method", "Method", "text"),
            column("decisions", "Decisions", "number", 0), column("mean", "Mean [us]", "number", 2),
            column("worst", "Longest [us]", "number", 0)}},
          {"rows", std::move(rows)},
          {"filter", {"family", "method"}}};
}

json absences_table(std::span<const Absence> absences) {
  json rows = json::array();
  for (const Absence& absence : absences)
    rows.push_back({{"family", absence.family},
                    {"condition", absence.condition.empty() ? "all" : absence.condition},
                    {"method", absence.method.empty() ? "all" : absence.method},
                    {"why", absence.why}});
  return {{"kind", "table"},
          {"title", "Cells without runs"},
          {"columns",
           {column("family", "Family", "text"), column("condition", "Condition", "text"),
            column("method", "Method", "text"), column("why", "Why", "text")}},
          {"rows", std::move(rows)},
          {"filter", {"family", "method"}}};
}

json families_table(std::span<const ExamFamily> families) {
  json rows = json::array();
  for (const ExamFamily& family : families) {
    std::string needs, grounds;
    for (const auto& [needed, name] :
         {std::pair{family.needs_movers, "movers"}, std::pair{family.needs_obstacles, "obstacles"},
          std::pair{family.needs_space, "space"}})
      if (needed) needs += (needs.empty() ? "" : ", ") + std::string(name);
    for (const ExamGround& ground : family.grounds) grounds += (grounds.empty() ? "" : ", ") + ground.name;
    rows.push_back({{"family", family.name},
                    {"summary", family.summary},
                    {"source", family.source},
                    {"needs", needs},
                    {"grounds", grounds},
                    {"seeds", fmt::format("{} to {}", family.test.first, family.test.last())}});
  }
  return {{"kind", "table"},
          {"title", "Families"},
          {"columns",
           {column("family", "Family", "text"), column("summary", "What happens", "text"),
            column("source", "Source", "text"), column("needs", "A method must see", "text"),
            column("grounds", "Grounds", "text"), column("seeds", "Test seeds", "text")}},
          {"rows", std::move(rows)}};
}

std::vector<std::string> how() {
  return {
      "Every method runs in the same scenarios under the same seeds, with the same limits, radii and "
      "information; what a method adds for itself is among its parameters. Times, lengths and energies are "
      "those of the run over those of direct alone under the same seed, in runs in which all arrived in "
      "both: direct avoids nobody, contacts are counted and not felt, and so its run is everyone's own way "
      "as if the others were not there.",
      "Within a family and condition whoever has the most runs without a collision leads, then the most "
      "arrivals, then the least time. Another is behind where McNemar's test of collision-free runs says "
      "so, or a sign test of who came out better under each seed: safe before unsafe, then in larger part "
      "arrived, then more than one in a hundred sooner. Since any entrant could have led, each p value is "
      "taken times "
      "half their number, and all are adjusted by Holm over the whole table. Whoever is not shown to be "
      "behind shares the place.",
      "Mean ranks are Friedman's over the seeds of a family, a run with a collision being behind all others; "
      "ranks that are farther apart than Nemenyi's critical difference differ at 5 % within that contest, "
      "without any correction over the table."};
}

}  // namespace fairway
