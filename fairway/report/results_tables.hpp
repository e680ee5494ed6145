// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "fairway/report/results_cells.hpp"

/// Tables of a comparison, as blocks of a report document. A row leads to the runs of its cell.
namespace fairway {

nlohmann::json rates_table(const Comparison& comparison, const CellRuns& runs, const GroupNames& names);

nlohmann::json means_table(const Comparison& comparison, const CellRuns& runs, const GroupNames& names);

/// Times that the end of the run cut off, and the others of their group.
nlohmann::json censored_table(const Comparison& comparison, const CellRuns& runs, const GroupNames& names);

/// Paired differences with their tests, quantities and rates.
nlohmann::json differences_table(const Comparison& comparison, const CellRuns& runs, const GroupNames& names);

}  // namespace fairway
