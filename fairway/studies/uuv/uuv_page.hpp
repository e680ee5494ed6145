// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "fairway/studies/uuv/findings.hpp"

namespace fairway::uuv {

/// Everything that the study's report shows.
struct Results {
  std::vector<Cell> published, variations, gatherings, silence;
  std::vector<StudyRow> published_rows, varied_rows, gathering_rows, silence_rows;
  int seeds{};
};

/// The report: published against measured, Figures 4 and 5 redrawn, every method on variations of both
/// encounters, gatherings, and what silence does to the cubes.
nlohmann::json page_of(const Results& results, const StudyOptions& options);

}  // namespace fairway::uuv
