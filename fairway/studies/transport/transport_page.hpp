// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/studies/transport/findings.hpp"

namespace fairway::transport {

/// Everything that the study's report shows.
struct Results {
  std::vector<Cell> published, cases, fields;
  std::vector<StudyRow> rows;  ///< all, those of the published runs first
  std::size_t published_rows{};
  int seeds{};
};

/// The report: published against measured on both plants, what does not reproduce and why, Figures 5 to 9
/// redrawn, and what the publication could not show: every method on its cases and on random fields.
nlohmann::json page_of(const Results& results, const StudyOptions& options);

}  // namespace fairway::transport
