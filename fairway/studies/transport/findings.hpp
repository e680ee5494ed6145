// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/studies/study.hpp"
#include "fairway/studies/transport/plan.hpp"

namespace fairway::transport {

/// Every published number beside the measured one, on both plants. `reproduced_assuming` where it took the
/// compatible plant, `follows_from_inputs` where gains and geometry fix the number on any. A run that meets
/// an obstacle on another side than the published one is `another_course` from there on.
std::vector<StudyRow> published_rows(const std::vector<Cell>& cells);

/// How often each method arrived untouched on its runs, how near it came, how long it took and what energy it
/// put into the body, of the runs in which it arrived.
std::vector<StudyRow> comparison_rows(const std::vector<Cell>& cells);

/// What the published claims come to, in sentences with the measured numbers.
std::vector<std::string> claims(const std::vector<Cell>& published);

/// The findings of the fields: how many can be escaped, and who touched something in one of those.
std::vector<std::string> field_findings(const std::vector<Cell>& fields, int seeds);

}  // namespace fairway::transport
