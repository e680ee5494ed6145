// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/exam/exam_file.hpp"
#include "fairway/exam/exam_run.hpp"
#include "fairway/experiment/campaign.hpp"

namespace fairway {

/// Who is asked.
struct Candidate {
  CampaignAlgorithm method;           ///< its label is what results call it by
  bool tuned{};                       ///< has parameters that somebody searched for
  std::vector<std::string> families;  ///< that these parameters are for; empty: all
  std::string file{};  ///< of its avoider, where somebody gave one; its label is then the file's
};

/// What is to be asked of whom.
struct ExamQuestion {
  std::vector<ExamFamily> families;
  std::vector<ExamCondition> conditions;
  std::vector<Candidate> candidates;
  std::size_t seeds{20};  ///< test seeds of every family
  bool by_name{};         ///< the candidates were named, so that no cell is left out for their slowness
};

/// A cell that has no runs, and why.
struct Absence {
  std::string family;
  std::string condition;  ///< empty: all
  std::string method;     ///< empty: all
  bool tuned{};
  std::string why;
};

struct ExamPlan {
  Campaign campaign;  ///< labels: case (the ground), condition, family, method, tuned
  std::vector<Absence> absences;
};

/// The runs of an exam: of each family, condition and candidate that may meet, one for each of the first
/// test seeds, and the baseline's beside them. Throws InputError for one who was named and may enter none of
/// the families, for more seeds than a family has, and as resolve_runs().
ExamPlan plan_exam(const ExamFile& exam, const ExamQuestion& question, const Catalog& methods,
                   const CheckScenario& check, unsigned jobs, const OwnMethods& own,
                   const WatchListing& watch = {});

/// A run of the plan, as it was stored.
ExamRun exam_run_of(const RunRecord& record);

/// A digest of what is asked of everybody in a family: its scenarios and what is laid over them by itself and
/// by the conditions. Equal for equal questions.
std::string digest_of(const ExamFamily& family, const std::vector<ExamCondition>& conditions);

}  // namespace fairway
