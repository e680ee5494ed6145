// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/exam/exam_table.hpp"

namespace fairway {

/// A run that shows where a method is weakest in a family, under whatever condition.
struct WorstRun {
  const ExamCell* cell{};
  const ExamRun* run{};
};

/// Of every method and family one run: of those with a collision that which left the least clearance; where
/// there is none, of those in which not all arrived; where all did, of all of them. Runs that broke, or that
/// nobody here can make again, are passed over. By family, then by method. O(runs log runs).
std::vector<WorstRun> worst_runs(const ExamTable& table);

/// What is the worst about it: "collision", "not all arrived", "least clearance".
std::string_view worst_of(const ExamOutcome& outcome);

/// Whether it is known when which vehicle had the least clearance, so that its decision can be explained.
bool has_instant(const ExamOutcome& outcome);

/// The table of these runs, with the commands that play and explain them; a row leads to its run.
nlohmann::json worst_table(std::span<const WorstRun> worst,
                           const std::function<nlohmann::json(const ExamRun&)>& place_of);

}  // namespace fairway
