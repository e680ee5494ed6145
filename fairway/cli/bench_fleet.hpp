// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "fairway/cli/program.hpp"

namespace fairway::cli {

/// Prints what a step of fleets of so many vehicles costs: nanoseconds a vehicle and step, as a whole and by
/// stage (deciding includes looking round; recording is the metrics), the growth over the first, and bytes of
/// the heap a vehicle, the scenario included. Each is stepped for `budget_s` at least, by so many threads,
/// whose times add up in the stages.
int bench_fleets(const std::vector<std::size_t>& counts, double budget_s, std::size_t threads, bool as_json,
                 const Catalogs& catalogs);

}  // namespace fairway::cli
