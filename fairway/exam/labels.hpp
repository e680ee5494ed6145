// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "fairway/exam/exam_plan.hpp"
#include "fairway/exam/reference.hpp"

namespace fairway {

/// Results tell methods apart by their labels alone. Throws InputError for a candidate from a file that would
/// be called as somebody else is: the baseline, a method of the exam or of the catalog, or another candidate;
/// it says whose the label is.
void refuse_taken_labels(const ExamQuestion& question, const ExamFile& exam, const Catalog& methods);

/// The same of stored results, `file`: whoever is called there as a candidate is has to be known for the
/// same.
void refuse_stored_labels(const ExamQuestion& question, const ExamReference& reference,
                          const std::string& file);

/// By which the candidates from files are known again: by label, a digest of each one's avoider.
std::map<std::string, std::string> avoiders_of(const ExamQuestion& question);

}  // namespace fairway
