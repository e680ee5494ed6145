// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/against.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "fairway/experiment/labels.hpp"

namespace fairway {

std::size_t seeds_in(const ExamReference& reference, const std::vector<ExamFamily>& families) {
  std::map<std::string, std::set<std::uint64_t>> seeds;
  for (const ExamRun& run : reference.runs) seeds[run.family].insert(run.seed);
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const ExamFamily& family : families) least = std::min(least, seeds[family.name].size());
  return least;
}

std::vector<ExamRun> runs_beside(const ExamReference& reference, const ExamQuestion& question, bool added) {
  std::vector<ExamRun> runs;
  for (const ExamRun& run : reference.runs) {
    const auto family = std::ranges::find(question.families, run.family, &ExamFamily::name);
    const bool asked = std::ranges::any_of(question.candidates, [&](const Candidate& candidate) {
      return candidate.method.label == run.method && candidate.tuned == run.tuned;
    });
    if (family == question.families.end() || (asked && !added) ||
        run.seed - family->test.first >= question.seeds ||
        std::ranges::find(question.conditions, run.condition, &ExamCondition::name) ==
            question.conditions.end())
      continue;
    runs.push_back(run);
  }
  return runs;
}

void keep_news(ExamPlan& plan, const ExamReference& reference, const std::string& baseline) {
  std::set<std::pair<std::string, std::string>> contests;
  for (const ExamRun& run : reference.runs) contests.emplace(run.family, run.condition);
  keep_runs(plan.campaign, [&](const RunSpec& spec) {
    const auto label = [&](const char* name) { return *find_label(spec.labels, name); };
    const bool is_baseline = label("method") == baseline && label("tuned") == "false";
    return !is_baseline && contests.contains({label("family"), label("condition")});
  });
}

void keep_lacking(ExamPlan& plan, const ExamReference& reference) {
  using Key = std::tuple<std::string, std::string, std::string, bool, std::uint64_t>;
  std::set<Key> stored;
  for (const ExamRun& run : reference.runs)
    stored.emplace(run.family, run.condition, run.method, run.tuned, run.seed);
  keep_runs(plan.campaign, [&](const RunSpec& spec) {
    const auto label = [&](const char* name) { return *find_label(spec.labels, name); };
    return !stored.contains(
        {label("family"), label("condition"), label("method"), label("tuned") == "true", spec.seed});
  });
}

void keep_complete_cells(ExamPlan& plan, const Store& store) {
  const auto cell_of = [](const RunSpec& spec) { return without_label(spec.labels, "case"); };
  std::set<Labels> incomplete;
  for (const RunSpec& spec : plan.campaign.specs)
    if (!store.contains(spec.key)) incomplete.insert(cell_of(spec));
  keep_runs(plan.campaign, [&](const RunSpec& spec) { return !incomplete.contains(cell_of(spec)); });
  for (const Labels& cell : incomplete)
    plan.absences.push_back({.family = *find_label(cell, "family"),
                             .condition = *find_label(cell, "condition"),
                             .method = *find_label(cell, "method"),
                             .tuned = *find_label(cell, "tuned") == "true",
                             .why = "has not been run"});
}

}  // namespace fairway
