// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "fairway/exam/exam_file.hpp"
#include "fairway/exam/exam_plan.hpp"
#include "fairway/exam/exam_table.hpp"
#include "fairway/exam/margins.hpp"

namespace fairway {

/// How long a method took to decide, by the clock of the machine that it ran on: no result rests on it.
struct DecisionTime {
  std::string family;
  std::string method;
  bool tuned{};
  std::int64_t decisions{};
  double mean_us{};
  double worst_us{};
};

/// Where the page finds the playback of a run, or "".
using PlaybackOf = std::function<std::string(const ExamRun&)>;

/// What the page says besides the table.
struct ExamPageParts {
  std::span<const ExamFamily> families;
  std::span<const ExamCondition> conditions;
  std::span<const Absence> absences;
  std::span<const DecisionTime> decision_times;
  PlaybackOf playback;  ///< may be empty
  ExamMargins margins;
  std::string command;  ///< as typed
  std::string origin;   ///< what made the runs, and the results that they are held against
};

/// The report document of an exam (viewer/README.md): findings, a heat map of methods and families for every
/// condition, what each condition costs, fronts of safety and time, distributions, the worst runs with the
/// commands that play and explain them, and their playbacks, every placing, decision times, and who could not
/// enter.
nlohmann::json exam_page(const ExamTable& table, const ExamPageParts& parts);

}  // namespace fairway
