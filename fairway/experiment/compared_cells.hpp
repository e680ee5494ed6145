// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fairway/experiment/compare.hpp"

/// What compare() makes of one cell, and of two whose runs pair by seed.
namespace fairway {

using Seeds = std::map<std::uint64_t, const RunRecord*>;

struct CellOfRuns {
  Seeds all;
  std::vector<const RunRecord*> counted{};  ///< counted_runs() of them
  const RunRecord* versioned{};             ///< the first whose version is known
  bool same() const { return counted.size() < all.size(); }
};

/// Runs of one seed: the candidate's, the baseline's. Where both cells count as one run, one pair.
std::vector<std::pair<const RunRecord*, const RunRecord*>> pairs_of(const CellOfRuns& candidate,
                                                                    const CellOfRuns& baseline);

/// Where a time of any of the cells was cut off, how far all of them tell something: up to the least of the
/// last times of those cells in which the last was cut off.
std::optional<double> common_limit(const std::vector<const CellOfRuns*>& cells, const std::string& quantity);

/// Value, median and censoring of a cell; `limit` as common_limit() gives it.
ComparedMean mean_of(const CellOfRuns& cell, const std::string& quantity, std::optional<double> limit,
                     double confidence);

/// Adds the difference from the baseline and its test.
void add_difference(ComparedMean& mean, const CellOfRuns& cell, const CellOfRuns& baseline,
                    std::optional<double> limit, double confidence);

RateEstimate rate_of(const CellOfRuns& cell, const RateQuestion& question, double confidence);

void add_difference(ComparedRate& rate, const CellOfRuns& cell, const CellOfRuns& baseline,
                    const RateQuestion& question, double confidence);

}  // namespace fairway
