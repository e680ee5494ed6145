// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fairway/studies/study.hpp"

namespace fairway::cubes {

/// What the rows say of the published numbers, in sentences. Each is made of the numbers of its rows, its
/// words too; one whose rows are missing, or not numbers, is left out.
std::vector<std::string> findings(std::span<const StudyRow> rows);

/// Likewise: what was tried to find out why numbers come out differently.
std::vector<std::string> causes(std::span<const StudyRow> rows);

/// Likewise: how far apart each method keeps vehicles, by what it is told to keep.
std::vector<std::string> clearances(std::span<const StudyRow> rows);

}  // namespace fairway::cubes
