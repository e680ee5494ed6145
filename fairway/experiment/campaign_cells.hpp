// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/experiment/campaign.hpp"

namespace fairway {

/// Every combination of what is written, scenario by scenario, the last axis fastest. Of `campaign` the
/// scenarios are asked for.
std::vector<CampaignCell> expanded_cells(const CampaignFile& written, const Campaign& campaign);

/// Throws InputError where two cells of one scenario and method are the same run under the first seed: a path
/// that is varied and changes nothing, as one under `defaults` that every vehicle sets for itself, would give
/// results under names that they do not deserve. O(cells).
void refuse_cells_alike(const Campaign& campaign);

}  // namespace fairway
