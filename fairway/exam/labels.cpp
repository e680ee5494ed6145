// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/labels.hpp"

#include <algorithm>

#include "fairway/experiment/digest.hpp"

namespace fairway {
namespace {

bool is_in(const Catalog& methods, const std::string& name) {
  try {
    methods.params(name);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// Who has a label whatever is asked; empty: nobody.
std::string owner_of(const std::string& label, const ExamFile& exam, const Catalog& methods) {
  if (label == exam.baseline.label) return "the exam's baseline";
  if (std::ranges::find(exam.methods, label, &CampaignAlgorithm::label) != exam.methods.end())
    return "a method of the exam";
  return is_in(methods, label) ? "a method that fairway has" : "";
}

[[noreturn]] void refuse(const Candidate& candidate, const std::string& whose) {
  const std::string& label = candidate.method.label;
  throw InputError(
      "--methods " + (candidate.file.empty() ? label : candidate.file) + ": its label, " + label +
      ", is that of " + whose + "; expected " +
      (candidate.file.empty() ? "other stored results" : "a file of another name, so rename it"));
}

std::string digest_of(const Candidate& candidate) { return Digest::of(candidate.method.avoider); }

}  // namespace

void refuse_taken_labels(const ExamQuestion& question, const ExamFile& exam, const Catalog& methods) {
  const std::vector<Candidate>& all = question.candidates;
  for (auto candidate = all.begin(); candidate != all.end(); ++candidate) {
    if (candidate->file.empty()) continue;
    const std::string& label = candidate->method.label;
    if (const std::string owner = owner_of(label, exam, methods); !owner.empty()) refuse(*candidate, owner);
    const auto other = std::find_if(all.begin(), candidate, [&](const Candidate& before) {
      return !before.file.empty() && before.method.label == label;
    });
    if (other != candidate) refuse(*candidate, other->file);
  }
}

void refuse_stored_labels(const ExamQuestion& question, const ExamReference& reference,
                          const std::string& file) {
  for (const Candidate& candidate : question.candidates) {
    if (candidate.tuned) continue;
    const std::string& label = candidate.method.label;
    const auto stored = reference.avoiders.find(label);
    const bool is_known = stored != reference.avoiders.end();
    const bool is_there =
        is_known || (!candidate.file.empty() && std::ranges::any_of(reference.runs, [&](const ExamRun& run) {
          return run.method == label && !run.tuned;
        }));
    if (!is_there || (is_known && !candidate.file.empty() && stored->second == digest_of(candidate)))
      continue;
    refuse(candidate,
           (is_known ? "another avoider in " : "a method that is not known to be this one in ") + file);
  }
}

std::map<std::string, std::string> avoiders_of(const ExamQuestion& question) {
  std::map<std::string, std::string> avoiders;
  for (const Candidate& candidate : question.candidates)
    if (!candidate.file.empty()) avoiders[candidate.method.label] = digest_of(candidate);
  return avoiders;
}

}  // namespace fairway
