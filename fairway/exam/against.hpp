// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fairway/exam/exam_plan.hpp"
#include "fairway/exam/reference.hpp"
#include "fairway/experiment/store.hpp"

// What is asked of whom, held against runs that are stored. All are O(runs log runs).

namespace fairway {

/// How many test seeds every one of these families has in the reference.
std::size_t seeds_in(const ExamReference& reference, const std::vector<ExamFamily>& families);

/// The reference's runs of what is asked, under the seeds that are asked; of whoever is asked anew only if
/// what is stored is `added` to.
std::vector<ExamRun> runs_beside(const ExamReference& reference, const ExamQuestion& question, bool added);

/// Leaves the runs of newcomers, who are not the baseline, where the reference has somebody to hold them
/// against.
void keep_news(ExamPlan& plan, const ExamReference& reference, const std::string& baseline);

/// Leaves the runs that the reference has not.
void keep_lacking(ExamPlan& plan, const ExamReference& reference);

/// Leaves the runs of the cells whose every run is stored; the others are told.
void keep_complete_cells(ExamPlan& plan, const Store& store);

}  // namespace fairway
