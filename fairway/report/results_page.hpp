// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "fairway/experiment/run.hpp"

namespace fairway {

/// The report document of any store: for each quantity a box for every cell and value of the label `by`, the
/// means with intervals, and differences paired by seed. Throws InputError for a label that no run has,
/// and for a store without runs.
nlohmann::json results_page(std::span<const RunRecord> records, const std::string& name,
                            const std::string& by, const std::string& command);

}  // namespace fairway
