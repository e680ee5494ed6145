// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "fairway/experiment/run.hpp"
#include "fairway/experiment/statistics.hpp"

namespace fairway {

/// A share of runs: those whose `quantity` lies in [min, max].
struct RateQuestion {
  std::string name;      ///< "collision_free_ratio"
  std::string quantity;  ///< "collision_count"
  double min{-std::numeric_limits<double>::infinity()};
  double max{std::numeric_limits<double>::infinity()};
};

/// Runs without a collision, and runs in which everyone arrived.
std::vector<RateQuestion> usual_rates();

struct CompareOptions {
  std::string by = "method";            ///< the label whose values are compared
  std::string baseline;                 ///< the value that others are compared with; empty = the first
  std::vector<std::string> quantities;  ///< empty = all that any run measured
  std::vector<RateQuestion> rates = usual_rates();
  double confidence = 0.95;  ///< of each interval by itself
};

/// One quantity of one cell. Runs that failed or did not measure it (a value that is not finite) are left
/// out.
struct ComparedMean {
  Labels group;           ///< the other labels
  std::string candidate;  ///< value of the compared label
  std::string quantity;
  MeanEstimate value;
  MeanEstimate difference;  ///< candidate - baseline over the seeds that both have; count 0 for the baseline
};

struct ComparedRate {
  Labels group;
  std::string candidate;
  std::string name;
  RateEstimate value;
};

struct ComparedCell {
  Labels group;
  std::string candidate;
  std::size_t runs{};
  std::size_t failed{};
};

/// Cells in label_order(), quantities as asked for.
struct Comparison {
  std::string by;
  std::string baseline;
  double confidence{};
  std::vector<ComparedCell> cells;
  std::vector<ComparedMean> means;
  std::vector<ComparedRate> rates;
};

/// A run counts as one value, because its vehicles are not independent of each other: the fleet's measure if
/// there is one, otherwise the mean over the vehicles that have a finite one; NaN if neither is there.
double run_value(std::span<const Measure> measures, std::string_view quantity);

/// Compares cells that differ in one label and agree in all others, run by run under the same seed, each run
/// by its run_value(). Throws InputError for a label, baseline or quantity that no run has, and for two runs
/// of one cell and seed: then the records are of more than one version of a scenario. O(n log n) in measures.
Comparison compare(std::span<const RunRecord> records, const CompareOptions& options = {});

/// An aligned table for people; numbers to four digits.
std::string table_text(const Comparison& comparison);

/// The same with full precision. What is unknown or infinite is null.
nlohmann::json to_json(const Comparison& comparison);

}  // namespace fairway
