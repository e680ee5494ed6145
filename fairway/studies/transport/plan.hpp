// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/studies/study_runs.hpp"
#include "fairway/studies/transport/field.hpp"
#include "fairway/studies/transport/transport_case.hpp"

namespace fairway::transport {

/// Runs that differ in their seed only, and what they came to, in order of the seeds.
struct Cell {
  std::string place;   ///< case or kind of field
  std::string method;  ///< as in tables
  std::string mode;    ///< plant
  std::vector<StudyRun> runs;
  std::vector<std::vector<Measure>> results;

  /// A quantity of run `i` of the first vehicle or the fleet; NaN where it was not measured.
  double value(std::size_t i, std::string_view quantity) const;
};

/// The four published runs on both plants.
std::vector<Cell> published_cells();

/// What is compared beyond the publication: its methods as printed, corrected and filtered, the blend, and
/// other methods of the catalog that command velocities.
std::span<const Method> compared_methods();

/// Every method on the two cases and on the one with an unknown obstacle.
std::vector<Cell> case_cells();

/// Every method on `seeds` random fields of each kind.
std::vector<Cell> field_cells(int seeds);

}  // namespace fairway::transport
