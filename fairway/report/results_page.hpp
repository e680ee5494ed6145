// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "fairway/experiment/compare.hpp"
#include "fairway/experiment/stored_results.hpp"

namespace fairway {

/// The report document of stored results: what to beware of, rates, for each quantity a box for every cell
/// and value of the label compared, means with intervals, times that were cut off, differences paired by seed
/// with their tests, and the methods in sentences. Cells stand in the order of the campaign. Throws
/// InputError as compare() does, and for a store without runs.
nlohmann::json results_page(const StoredResults& results, CompareOptions options, const std::string& command);

}  // namespace fairway
