// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/exam/exam_run.hpp"
#include "fairway/record/output_check.hpp"

namespace fairway {

/// The runs of an exam to hold others against: what they came to, and what they were asked on.
struct ExamReference {
  int epoch{};
  std::string maker;                           ///< what made them: version, commit, compiler, machine
  std::map<std::string, std::string> grounds;  ///< digest_of() each family
  /// Of methods that a file had, by label: digest_of() its avoider, by which the file is known again.
  std::map<std::string, std::string> avoiders;
  std::vector<ExamRun> runs;  ///< without their commands
};

/// As write_reference() gives it, before it is compressed.
inline constexpr FileKind reference_file{
    .name = "stored results of an exam", .begins = "\x28\xb5\x2f\xfd", .holds = ""};

/// A CSV table, one line a run, under lines that begin with # and say where it comes from, a digest of the
/// table among them. The same bytes for the same runs, in the order given.
std::string reference_text(const ExamReference& reference);

/// Reads such a text; `file` is for messages. Throws InputError with the line for anything else, for a table
/// that is not what its digest says, and for results of another epoch.
ExamReference parse_reference(std::string_view text, const std::string& file);

/// zstd, one frame.
std::string compressed(std::string_view text);

/// A file as it is, or what is in it where it is compressed. Throws InputError for a damaged one, or one that
/// holds more than 1 GiB.
std::string read_maybe_compressed(const std::string& file);

}  // namespace fairway
