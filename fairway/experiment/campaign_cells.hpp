// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "fairway/experiment/campaign_file.hpp"
#include "fairway/experiment/run.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway {

/// One combination of scenario, algorithm and settings; run once for each seed.
struct CampaignCell {
  Labels labels;           ///< case, method, then each path that is varied
  std::size_t scenario{};  ///< index into Campaign::scenarios
  std::string algorithm;   ///< YAML of the avoider, or empty: as in the scenario
  Overrides overrides;     ///< all of them: the algorithm, what is laid over every scenario, what is varied
  WrittenPlace place{};    ///< of the algorithm
};

/// Every combination of what is written, scenario by scenario, the last axis fastest. `cases` are the names
/// of the scenarios.
std::vector<CampaignCell> expanded_cells(const CampaignFile& written, std::span<const std::string> cases);

/// Throws InputError of `file` where two cells of one scenario and method are the same run: a path that is
/// varied and changes nothing, as one under `defaults` that every vehicle sets for itself, would give results
/// under names that they do not deserve. `run_of` is a run of the cell of that index, as text. O(cells).
void refuse_cells_alike(const std::string& file, std::span<const CampaignCell> cells,
                        const std::function<std::string(std::size_t)>& run_of);

}  // namespace fairway
