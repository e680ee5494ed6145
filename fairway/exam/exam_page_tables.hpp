// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "fairway/exam/exam_page.hpp"

namespace fairway {

/// A column of a table of the report; `digits` below 0 leaves a number as it is.
nlohmann::json column(const char* key, const char* label, const char* type, int digits = -1);

/// The tables of an exam's page that rest on no result: how long decisions took, which cells have no runs and
/// why, what the families are.
nlohmann::json decisions_table(std::span<const DecisionTime> times);
nlohmann::json absences_table(std::span<const Absence> absences);
nlohmann::json families_table(std::span<const ExamFamily> families);

/// How the places were found, in paragraphs.
std::vector<std::string> how();

}  // namespace fairway
