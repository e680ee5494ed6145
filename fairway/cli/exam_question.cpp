// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/exam_question.hpp"

#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <tuple>

#include "fairway/cli/own_methods.hpp"
#include "fairway/exam/entrance.hpp"
#include "fairway/exam/labels.hpp"
#include "fairway/exam/tuned.hpp"

namespace fairway::cli {

ExamQuestion question_of(const ExamFlags& flags, const ExamFile& exam, const Catalog& methods) {
  ExamQuestion question{.families = chosen_by_name(exam.families, flags.families, "--families"),
                        .conditions = chosen_by_name(exam.conditions, flags.conditions, "--conditions"),
                        .candidates = {},
                        .by_name = !flags.methods.empty()};
  expect_known(exam.baseline, methods);
  for (const std::string& name : flags.methods)
    question.candidates.push_back(candidate_of(name, exam, methods, "--methods"));
  if (flags.methods.empty() && (flags.against.empty() || flags.add))
    for (const CampaignAlgorithm& method : exam.methods)
      question.candidates.push_back(candidate_of(method.label, exam, methods, "methods:"));
  refuse_taken_labels(question, exam, methods);
  for (const Candidate& candidate : question.candidates)
    if (!candidate.file.empty() && !is_search_told("--methods", candidate.file, question.families))
      std::cerr << "fairway: --methods " << candidate.file
                << ": was tuned, and no tuning.json beside it says on which seeds; they may be test seeds\n";
  if (flags.tuned.empty()) return question;
  for (Candidate& candidate : tuned_candidates(flags.tuned, exam, question, methods))
    question.candidates.push_back(std::move(candidate));
  return question;
}

std::optional<ExamReference> reference_for(const ExamFlags& flags, const ExamFile& exam,
                                           ExamQuestion& question) {
  if (flags.against.empty()) return {};
  std::vector<ExamFamily>& families = question.families;
  ExamReference reference = parse_reference(read_maybe_compressed(flags.against), flags.against);
  if (flags.families.empty() && !flags.add)
    std::erase_if(families,
                  [&](const ExamFamily& family) { return !reference.grounds.contains(family.name); });
  for (const ExamFamily& family : families) {
    const auto known = reference.grounds.find(family.name);
    if (known == reference.grounds.end() && flags.add) continue;
    if (known == reference.grounds.end())
      throw InputError("--against " + flags.against + ": has no runs of the family " + family.name);
    if (known->second != digest_of(family, exam.conditions))
      throw InputError("--against " + flags.against + ": its runs of " + family.name +
                       " are of other scenarios than " + family.file + " has now");
  }
  refuse_stored_labels(question, reference, flags.against);
  return reference;
}

std::vector<std::string> exam_inputs(const ExamFlags& flags, const ExamFile& exam) {
  std::vector<std::string> inputs{flags.grounds};
  for (const ExamFamily& family : exam.families) {
    inputs.push_back(family.file);
    for (const ExamGround& ground : family.grounds) inputs.push_back(ground.file);
  }
  for (const std::string& method : flags.methods)
    if (method.ends_with(".yaml")) inputs.push_back(method);
  if (!flags.against.empty()) inputs.push_back(flags.against);
  return inputs;
}

void add_commands(std::vector<ExamRun>& runs, const ExamFile& exam, ExamQuestion question,
                  const Program& program) {
  std::set<std::string> known;
  for (const ExamRun& run : runs)
    if (!run.tuned && run.method != exam.baseline.label) known.insert(run.method);
  question.candidates.clear();
  for (const std::string& method : known) {
    try {
      question.candidates.push_back(candidate_of(method, exam, program.catalogs.avoiders, ""));
    } catch (const InputError&) {  // somebody else's: its runs are shown without
    }
  }
  std::size_t most = 1;
  for (const ExamFamily& family : question.families) most = std::max(most, family.grounds.size());
  question.seeds = most;
  question.by_name = false;
  const ExamPlan plan = plan_exam(exam, question, program.catalogs.avoiders, {}, 1, own_methods(program));
  using Key = std::tuple<std::string, std::string, std::string, std::string>;
  std::map<Key, std::string> commands;
  for (const RunSpec& spec : plan.campaign.specs) {
    const auto label = [&](const char* name) { return *find_label(spec.labels, name); };
    commands[{label("family"), label("condition"), label("method"), label("case")}] = spec.command;
  }
  for (ExamRun& run : runs)
    if (const auto found = commands.find({run.family, run.condition, run.method, run.ground});
        !run.tuned && found != commands.end())
      run.command = found->second;
}

void tell_what_is_not_left_out(const ExamFile& exam, const ExamQuestion& question) {
  if (!question.by_name) return;
  for (const ExamOmission& omission : exam.omissions) {
    std::string families;
    for (const ExamFamily& family : question.families)
      if (std::ranges::find(omission.families, family.name) != omission.families.end())
        families += (families.empty() ? "" : ",") + family.name;
    const auto is_named = [&](const Candidate& candidate) {
      return !candidate.tuned && candidate.method.label == omission.method;
    };
    if (families.empty() || std::ranges::none_of(question.candidates, is_named)) continue;
    std::cerr << "fairway: " << omission.method << " is named, so that " << families << " is not left out ("
              << omission.why << "); --families takes others\n";
  }
}

}  // namespace fairway::cli
