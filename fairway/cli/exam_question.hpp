// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fairway/cli/program.hpp"
#include "fairway/exam/exam_plan.hpp"
#include "fairway/exam/reference.hpp"

// What `fairway exam` is asked, from its flags.

namespace fairway::cli {

struct ExamFlags {
  std::string grounds = shipped("campaigns/exam/exam.yaml");
  std::vector<std::string> methods;
  std::vector<std::string> families;
  std::vector<std::string> conditions;
  std::optional<std::size_t> seeds;
  std::string against;
  std::string tuned;
  std::string out;
  unsigned jobs{0};
  bool add{false};
  bool as_it_is{false};
  bool playbacks{false};
  bool json{false};
};

/// Who is asked, where and under what. Throws InputError for what is not known, and for two that would be
/// called alike; says on standard error of whom it is not known what a search saw.
ExamQuestion question_of(const ExamFlags& flags, const ExamFile& exam, const Catalog& methods);

/// Stored results that newcomers are held against; none if there is no such flag. Unless families are named,
/// those that it has are left, and with --add all of them. Throws InputError where they are of other
/// scenarios, or call another method as one that is asked is called.
std::optional<ExamReference> reference_for(const ExamFlags& flags, const ExamFile& exam,
                                           ExamQuestion& question);

/// The files that it reads.
std::vector<std::string> exam_inputs(const ExamFlags& flags, const ExamFile& exam);

/// Says of stored runs how each is made, where this program knows their methods.
void add_commands(std::vector<ExamRun>& runs, const ExamFile& exam, ExamQuestion question,
                  const Program& program);

/// Says on standard error where a method that is named costs what the exam would have spared.
void tell_what_is_not_left_out(const ExamFile& exam, const ExamQuestion& question);

}  // namespace fairway::cli
