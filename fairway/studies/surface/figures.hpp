// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fairway/studies/run_index.hpp"
#include "fairway/studies/surface/plan.hpp"

namespace fairway::surface {

/// A passage made again to be looked at.
struct Passage {
  std::string label;
  nlohmann::json track;        ///< for the block `trajectories`
  nlohmann::json speeds;       ///< for the block `lines`: speed and turn rate, had and wanted
  double mean_decision_us{};   ///< on this machine
  double worst_decision_us{};  ///< likewise
};

/// The first published run of a method on a course, under the overrides.
Passage passage_of(Course course, const Method& method, const Overrides& overrides, const RunIndex& runs);

/// Passages over one course, seen from above, with the way of the other vessel.
nlohmann::json ways(const std::string& title, Course course, const std::vector<Passage>& passages);

}  // namespace fairway::surface
