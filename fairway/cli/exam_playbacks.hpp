// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "fairway/cli/program.hpp"
#include "fairway/exam/exam_plan.hpp"
#include "fairway/exam/exam_table.hpp"

namespace fairway::cli {

/// Where the page of an exam finds the playbacks of its runs: paths from its folder.
using ExamPlaybacks = std::map<const ExamRun*, std::string>;

/// "" where there is none.
std::string page_of(const ExamPlaybacks& playbacks, const ExamRun& run);

/// The pages in `folder` that play the worst runs of the table, as far as these are of the plan. If asked,
/// those that are not there are made first, on so many threads (0: as many as the machine has): of half a
/// minute before and after the least clearance, with the decision of then explained, where there was a
/// collision; of the whole run else. Nothing if stopped. Throws InputError if a page cannot be written.
std::optional<ExamPlaybacks> exam_playbacks(const ExamTable& table, const ExamPlan& plan,
                                            const std::filesystem::path& folder, bool are_asked,
                                            unsigned jobs, const Program& program);

}  // namespace fairway::cli
