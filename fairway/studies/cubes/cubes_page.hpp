// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/studies/cubes/plan.hpp"
#include "fairway/studies/study.hpp"

namespace fairway::cubes {

/// The report: published against measured, the thesis's Figures 16 to 23 redrawn, the corrected
/// comparison with intervals, what does not reproduce, and one run in detail.
nlohmann::json page_of(const std::vector<Cell>& cells, std::span<const StudyRow> rows,
                       const StudyOptions& options);

}  // namespace fairway::cubes
