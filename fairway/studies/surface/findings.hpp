// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/studies/surface/plan.hpp"

namespace fairway::surface {

/// Every published outcome beside the measured one, and what else was measured in the published runs.
/// Agreement is `reproduced_assuming`, since the courses and much of the methods' settings are proposals.
std::vector<StudyRow> published_rows(const std::vector<Cell>& cells);

/// How often each method arrived untouched in the variations, how near it came, how long it took and how
/// smoothly it went where it arrived.
std::vector<StudyRow> varied_rows(const std::vector<Cell>& cells);

/// What the published claims come to, in sentences with the measured numbers.
std::vector<std::string> claims(const std::vector<Cell>& published);

/// What each improvement buys, in sentences with the measured numbers.
std::vector<std::string> ablation(const std::vector<Cell>& variations);

}  // namespace fairway::surface
