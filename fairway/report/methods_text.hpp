// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/origin.hpp"

namespace fairway {

/// How the numbers of a comparison came about, in sentences for a paper: design, seeds, estimates, tests,
/// corrections, versions. One text for each paragraph.
std::vector<std::string> methods_text(const Comparison& comparison, std::span<const RunRecord> records,
                                      const Origin& origin);

}  // namespace fairway
