// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/core/params.hpp"
#include "fairway/exam/exam_file.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// What a campaign writes of a method, with its parameters.
Choice choice_of(const CampaignAlgorithm& method);

/// The name in the catalog of a method as a campaign writes it: "orca3d+inflate" of `{algorithm:
/// orca3d+inflate, crit_dist_m: 20}`.
std::string algorithm_of(const CampaignAlgorithm& method);

/// Throws InputError, which says where the method is written, unless the catalog has it.
void expect_known(const CampaignAlgorithm& method, const Catalog& methods);

/// Why a method is not made for a family: "ignores obstacles, and there are some"; empty if it may enter.
/// Follows from what its layers declare (AlgorithmInfo). One that needs a link avoids whoever speaks as it
/// does, so what moves has to be vehicles that all have it, in a group of a size that it is made for.
/// Throws InputError for an unknown method.
std::string why_not(const Catalog& methods, std::string_view algorithm, const ExamFamily& family);

/// Why it has nothing to go by under a condition that it would enter otherwise: a link that carries no word;
/// empty where it has. Likewise.
std::string why_not_under(const Catalog& methods, std::string_view algorithm, const ExamFamily& family,
                          const ExamCondition& condition);

/// Whether a condition makes a difference to a scenario: whether somebody tells somebody, or something is
/// there to be seen that no chart has.
bool concerns(ConditionOf of, const Scenario& scenario);

/// A ground under a condition, as it is drawn for the family's first test seed.
Scenario first_test(const ExamFamily& family, const ExamGround& ground, const ExamCondition& condition);

}  // namespace fairway
