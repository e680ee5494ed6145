// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/exam/exam_plan.hpp"

namespace fairway {

/// A method by its name in the catalog, by its label in the exam, or by a file of an avoider, `mine.yaml`,
/// whose name is then its label. Throws InputError, which begins with `flag`, for anything else, with the
/// nearest name.
Candidate candidate_of(const std::string& name, const ExamFile& exam, const Catalog& methods,
                       const std::string& flag);

/// Whether it is known what the search for the avoider in `file` saw: tuning.json beside it says so, or
/// nothing says that it was searched for. Throws InputError, which begins with `flag`, where it saw a test
/// seed of a ground of these families, under its name or as a copy of it.
bool is_search_told(const std::string& flag, const std::string& file,
                    const std::vector<ExamFamily>& families);

/// What `fairway tune` left: a file of an avoider, or of a folder and those below it every one, where methods
/// were asked for by name those of the same methods. One is for a family alone whose name the folder has that
/// it lies in, or one above that up to the one that is given. What was searched on stands in tuning.json
/// beside it. Throws InputError where there is none, where two are of one method and family, and where a
/// search saw a test seed of a ground of the families that are asked, or may have seen any.
std::vector<Candidate> tuned_candidates(const std::string& path, const ExamFile& exam,
                                        const ExamQuestion& question, const Catalog& methods);

}  // namespace fairway
