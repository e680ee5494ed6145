// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/labels.hpp"

#include <algorithm>

#include "fairway/experiment/digest.hpp"

namespace fairway {
namespace {

/// Who has a label whatever is asked; empty: nobody.
std::string owner_of(const std::string& label, const ExamFile& exam, const Catalog& methods) {
  if (label == exam.baseline.label) return "the exam's baseline";
  if (std::ranges::find(exam.methods, label, &CampaignAlgorithm::label) != exam.methods.end())
    return "a method of the exam";
  const auto is_known = [&](std::string_view layer) { return methods.has(layer); };
  return std::ranges::all_of(layer_names(label), is_known) ? "a method that fairway has" : "";
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
    const bool is_file = !candidate.file.empty();
    const auto has_run = [&](const ExamRun& run) {
      return run.method == candidate.method.label && !run.tuned;
    };
    const auto stored = reference.avoiders.find(candidate.method.label);
    if (stored == reference.avoiders.end()) {
      if (is_file && std::ranges::any_of(reference.runs, has_run))
        refuse(candidate, "a method that is not known to be this one in " + file);
    } else if (!is_file || stored->second != digest_of(candidate)) {
      refuse(candidate, "another avoider in " + file);
    }
  }
}

std::map<std::string, std::string> avoiders_of(const ExamQuestion& question) {
  std::map<std::string, std::string> avoiders;
  for (const Candidate& candidate : question.candidates)
    if (!candidate.file.empty()) avoiders[candidate.method.label] = digest_of(candidate);
  return avoiders;
}

}  // namespace fairway
