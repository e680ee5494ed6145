// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "fairway/studies/surface/findings.hpp"

namespace fairway::surface {

/// Everything that the study's report shows.
struct Results {
  std::vector<Cell> published, variations, scales;
  std::vector<StudyRow> rows;  ///< all: of the published runs, of the variations, of the scales
  std::size_t published_rows{}, varied_rows{};
  int seeds{};
};

/// The report: published against measured, Figures 3 to 6, 8, 9 and 11 to 13 redrawn, decision times,
/// where the printed times can come from, and every method on the variations.
nlohmann::json page_of(const Results& results, const StudyOptions& options);

}  // namespace fairway::surface
