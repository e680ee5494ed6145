// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>

#include "fairway/exam/exam_plan.hpp"

namespace fairway {

/// "trackable margin_m 0.3, shown_margin_m 0.4": the parameters by which the layers of a method keep farther
/// away than the radii that everybody is given. Empty where it has none. Throws InputError for an unknown
/// method.
std::string margins_of(const CampaignAlgorithm& method, const Catalog& methods);

/// The same of everybody in a question and of the exam's own methods, by the family and the name in its
/// table, "orca3d" or "orca3d, tuned".
using ExamMargins = std::map<std::pair<std::string, std::string>, std::string>;
ExamMargins margins_in(const ExamFile& exam, const ExamQuestion& question, const Catalog& methods);

}  // namespace fairway
