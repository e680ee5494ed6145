// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/exam_plan.hpp"

#include <algorithm>
#include <utility>

#include "fairway/exam/entrance.hpp"
#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway {
namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

std::string label_of(const RunSpec& spec, std::string_view name) {
  const std::string* value = find_label(spec.labels, name);
  return value == nullptr ? std::string{} : *value;
}

class Planner {
 public:
  Planner(const ExamFile& exam, const ExamQuestion& question, const Catalog& methods)
      : exam_{exam}, question_{question}, methods_{methods} {
    plan_.campaign.name = exam.name;
    plan_.campaign.summary = exam.summary;
    plan_.campaign.file = exam.file;
  }

  ExamPlan made() {
    for (const Candidate& candidate : question_.candidates) {
      refuse_outsider(candidate);
      tell_for_others(candidate);
    }
    for (const ExamFamily& family : question_.families) add_family(family);
    return std::move(plan_);
  }

 private:
  /// Whoever was named has something to do.
  void refuse_outsider(const Candidate& candidate) const {
    if (!question_.by_name || candidate.tuned) return;
    std::string first;
    for (const ExamFamily& family : question_.families) {
      const std::string why = why_not(methods_, algorithm_of(candidate.method), family);
      if (why.empty()) return;
      if (first.empty()) first = family.name + ": " + candidate.method.label + " " + why;
    }
    throw InputError("--methods " + candidate.method.label + " may enter none of the families; " + first);
  }

  static bool is_for(const Candidate& candidate, const ExamFamily& family) {
    return candidate.families.empty() || has(candidate.families, family.name);
  }

  /// Parameters that are for none of the families that are asked are told of.
  void tell_for_others(const Candidate& candidate) {
    const auto is_wanted = [&](const ExamFamily& family) { return is_for(candidate, family); };
    if (std::ranges::any_of(question_.families, is_wanted)) return;
    for (const ExamFamily& family : question_.families)
      plan_.absences.push_back({.family = family.name,
                                .condition = {},
                                .method = candidate.method.label,
                                .tuned = true,
                                .why = "was tuned for " + candidate.families.front() + " alone"});
  }

  void add_family(const ExamFamily& family) {
    if (question_.seeds > family.test.count)
      throw InputError(family.file + ": seeds.test: has " + std::to_string(family.test.count) +
                       " seeds, and --seeds asks for " + std::to_string(question_.seeds));
    const std::size_t first_scenario = plan_.campaign.scenarios.size();
    for (const ExamGround& ground : family.grounds)
      plan_.campaign.scenarios.emplace_back(ground.file, ground.text);
    std::vector<Candidate> entrants{{.method = exam_.baseline, .tuned = false, .families = {}}};
    for (const Candidate& candidate : question_.candidates)
      if (is_entrant(candidate, family)) entrants.push_back(candidate);
    for (const ExamCondition& condition : question_.conditions) {
      if (!is_concerned(family, condition)) {
        plan_.absences.push_back({.family = family.name,
                                  .condition = condition.name,
                                  .method = {},
                                  .why = "changes nothing there: nobody tells, or nothing is to be seen"});
        continue;
      }
      for (const Candidate& entrant : entrants) {
        std::string why = why_not_under(methods_, algorithm_of(entrant.method), family, condition);
        if (why.empty())
          add_cells(family, condition, entrant, first_scenario);
        else
          plan_.absences.push_back(
              {family.name, condition.name, entrant.method.label, entrant.tuned, std::move(why)});
      }
    }
  }

  bool is_entrant(const Candidate& candidate, const ExamFamily& family) {
    if (candidate.method.label == exam_.baseline.label && !candidate.tuned) return false;  // is there anyhow
    if (!is_for(candidate, family)) return false;
    std::string why = why_not(methods_, algorithm_of(candidate.method), family);
    if (why.empty() && !question_.by_name)
      for (const ExamOmission& omission : exam_.omissions)
        if (omission.method == candidate.method.label && has(omission.families, family.name))
          why = "left out: " + omission.why;
    if (!why.empty())
      plan_.absences.push_back({family.name, {}, candidate.method.label, candidate.tuned, why});
    return why.empty();
  }

  bool is_concerned(const ExamFamily& family, const ExamCondition& condition) const {
    return std::ranges::any_of(family.grounds, [&](const ExamGround& ground) {
      return concerns(condition.of, first_test(family, ground, {}));
    });
  }

  void add_cells(const ExamFamily& family, const ExamCondition& condition, const Candidate& entrant,
                 std::size_t first_scenario) {
    const std::size_t grounds = family.grounds.size();
    for (std::size_t ground = 0; ground < std::min(grounds, question_.seeds); ++ground) {
      CampaignCell cell{.labels = {{"case", family.grounds[ground].name},
                                   {"condition", condition.name},
                                   {"family", family.name},
                                   {"method", entrant.method.label},
                                   {"tuned", entrant.tuned ? "true" : "false"}},
                        .scenario = first_scenario + ground,
                        .algorithm = entrant.method.avoider,
                        .overrides = family.set,
                        .place = entrant.method.place};
      cell.overrides.emplace_back(family.keep_named_avoiders ? "defaults.avoider" : "vehicles[*].avoider",
                                  entrant.method.avoider);
      // whatever a method needs around it is written in its name, so that none is given more than another
      cell.overrides.emplace_back("vehicles[*].tracking", "raw");
      cell.overrides.insert(cell.overrides.end(), condition.set.begin(), condition.set.end());
      for (std::size_t seed = ground; seed < question_.seeds; seed += grounds) {
        plan_.campaign.specs.push_back(
            {.key = {}, .labels = cell.labels, .seed = family.test.first + seed, .command = {}});
        plan_.campaign.cells_of.push_back(plan_.campaign.cells.size());
      }
      plan_.campaign.cells.push_back(std::move(cell));
    }
  }

  const ExamFile& exam_;
  const ExamQuestion& question_;
  const Catalog& methods_;
  ExamPlan plan_;
};

}  // namespace

ExamPlan plan_exam(const ExamFile& exam, const ExamQuestion& question, const Catalog& methods,
                   const CheckScenario& check, unsigned jobs, const OwnMethods& own,
                   const WatchListing& watch) {
  ExamPlan plan = Planner{exam, question, methods}.made();
  resolve_runs(plan.campaign, check, jobs, own, watch);
  return plan;
}

ExamRun exam_run_of(const RunRecord& record) {
  return {.family = label_of(record.spec, "family"),
          .condition = label_of(record.spec, "condition"),
          .method = label_of(record.spec, "method"),
          .tuned = label_of(record.spec, "tuned") == "true",
          .ground = label_of(record.spec, "case"),
          .seed = record.spec.seed,
          .outcome = record.failure.empty() ? outcome_in(record.measures) : failed_exam(),
          .command = record.spec.command};
}

std::string digest_of(const ExamFamily& family, const std::vector<ExamCondition>& conditions) {
  Digest digest;
  const auto add_all = [&](const Overrides& set) {
    for (const auto& [path, value] : set) digest.add(path).add(value);
  };
  digest.add(family.name).add(std::to_string(family.test.first));
  digest.add(family.keep_named_avoiders ? "named" : "all");
  for (const ExamGround& ground : family.grounds) {
    Scenario scenario = first_test(family, ground, {});
    scenario.summary.clear();
    scenario.expect.clear();
    digest.add(to_yaml(scenario));
  }
  for (const ExamCondition& condition : conditions) {
    digest.add(condition.name);
    add_all(condition.set);
  }
  return digest.hex();
}

}  // namespace fairway
