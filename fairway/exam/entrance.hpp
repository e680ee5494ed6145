// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/exam/exam_file.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// The name in the catalog of a method as a campaign writes it: "orca3d+inflate" of `{algorithm:
/// orca3d+inflate, crit_dist_m: 20}`.
std::string algorithm_of(const CampaignAlgorithm& method);

/// Why a method is not made for a family: "ignores obstacles, and there are some"; empty if it may enter.
/// Follows from what its layers declare (AlgorithmInfo). Throws InputError for an unknown method.
std::string why_not(const Catalog& methods, std::string_view algorithm, const ExamFamily& family);

/// Whether a condition makes a difference to a scenario: whether somebody tells somebody, or something is
/// there to be seen that no chart has.
bool concerns(ConditionOf of, const Scenario& scenario);

}  // namespace fairway
