// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fairway/exam/exam_plan.hpp"
#include "fairway/exam/exam_table.hpp"
#include "fairway/record/output_check.hpp"

namespace fairway {

// what an exam leaves in its folder
inline constexpr FileKind exam_rows_file{
    .name = "rows of an exam",
    .begins = "",
    .holds = "family,condition,method,tuned,quantity,mean,low,high,runs\n",
    .is_table = true};
inline constexpr FileKind exam_document{.name = "results of an exam", .begins = "{", .holds = "\"absent\""};
inline constexpr FileKind exam_latex{.name = "a table of an exam", .begins = "% fairway exam", .holds = ""};
inline constexpr FileKind decision_times_file{.name = "decision times of an exam",
                                              .begins = "",
                                              .holds = "family,method,tuned,decisions,mean_us,worst_us\n",
                                              .is_table = true};

/// What the numbers say, a sentence each, in the order of the exam. Nothing is said of what the tests do not
/// show, nor of cells without runs.
std::vector<std::string> findings(const ExamTable& table);

/// `exam --json`: rows, and what else the page shows. What is unknown is null.
nlohmann::json to_json(const ExamTable& table, const std::vector<Absence>& absences);

/// The rows as CSV, unknown ends empty.
std::string rows_csv(const ExamTable& table);

/// One line for each method in each contest, as a longtable of booktabs.
std::string latex_of(const ExamTable& table);

/// Who stands where, aligned, and the findings.
std::string table_text(const ExamTable& table, const std::vector<Absence>& absences);

}  // namespace fairway
