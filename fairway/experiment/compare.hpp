// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fairway/experiment/paired_tests.hpp"
#include "fairway/experiment/run.hpp"
#include "fairway/experiment/statistics.hpp"
#include "fairway/experiment/survival.hpp"

namespace fairway {

/// A share of runs: those whose `quantity` lies in [min, max], and so does `also` where that was measured.
struct RateQuestion {
  std::string name;      ///< "collision_free_ratio"
  std::string quantity;  ///< "collision_count"
  double min{-std::numeric_limits<double>::infinity()};
  double max{std::numeric_limits<double>::infinity()};
  std::string also{};
};

/// Runs in which no two vehicles collided, and runs in which everyone arrived. For the first two counts have
/// to be 0: raja2024's leaves out who is still near when a vehicle is given up as stuck.
std::vector<RateQuestion> usual_rates();

struct CompareOptions {
  std::string by = "method";              ///< the label whose values are compared
  std::string baseline{};                 ///< the value that others are compared with; empty = the first
  std::vector<std::string> quantities{};  ///< empty = all that any run measured
  std::vector<RateQuestion> rates = usual_rates();
  double confidence = 0.95;          ///< of each interval by itself
  std::vector<std::string> order{};  ///< of the values of `by`; those not named follow, numbers before words
  bool mixed{};                      ///< a cell may have runs of several versions of its scenario
};

/// What a paired test came to.
struct ComparedTest {
  const char* name;         ///< "wilcoxon_signed_rank", "mcnemar" or, where times were cut off, "sign"
  const char* effect_size;  ///< "rank_biserial" or "cohens_g"
  PairedTest result;
  double p_adjusted{};  ///< by Holm over all tests of the comparison
};

/// Times of which the end of the run cut some off.
struct CensoredTimes {
  std::size_t cut{};                  ///< runs; their values are too small
  RateEstimate complete;              ///< runs that were not cut off; a failed one was not complete
  std::vector<SurvivalStep> curve{};  ///< of Kaplan and Meier
  MedianEstimate median;
  double limit{};  ///< of the restricted mean: as far as the times of every cell of the group tell something
  RestrictedMean restricted;
};

/// One quantity of one cell. Runs that failed or did not measure it (a value that is not finite) are left
/// out.
struct ComparedMean {
  Labels group;           ///< the other labels
  std::string candidate;  ///< value of the compared label
  std::string quantity;
  MeanEstimate value;       ///< unknown but for its count where a time was cut off
  double median{};          ///< of the runs; of times that were cut off, Kaplan and Meier's
  std::size_t left_out{};   ///< runs
  std::size_t truncated{};  ///< runs in which a vehicle's time counts until the end alone
  MeanEstimate difference;  ///< candidate - baseline over the seeds that both have; count 0 for the baseline;
                            ///< of restricted pseudo-values where a time of either was cut off
  MedianEstimate difference_median;         ///< NaN where a time of either was cut off
  std::optional<ComparedTest> test{};       ///< where there are pairs
  std::optional<CensoredTimes> censored{};  ///< where a time of any cell of the group was cut off
};

struct ComparedRate {
  Labels group;
  std::string candidate;
  std::string name;
  RateEstimate value;  ///< a run that failed is none of the successes
  RateDifference difference{};
  std::optional<ComparedTest> test{};
};

struct ComparedCell {
  Labels group;
  std::string candidate;
  std::size_t runs{};       ///< that count
  std::size_t failed{};     ///< of these
  std::size_t identical{};  ///< so many runs of different seeds came to the same and count as the one
};

struct Comparison {
  std::string by;
  std::string baseline;
  double confidence{};
  std::vector<ComparedCell> cells{};
  std::vector<ComparedMean> means{};
  std::vector<ComparedRate> rates{};
  std::size_t tests{};   ///< in the family over which p values are adjusted
  std::string family{};  ///< "Holm over 12 comparisons: 3 methods x 4 quantities"; empty of no tests
};

/// A run counts as one value, because its vehicles are not independent of each other: the fleet's measure if
/// there is one, otherwise the mean over the vehicles that have a finite one; NaN if neither is there.
double run_value(std::span<const Measure> measures, std::string_view quantity);

/// Whether the end of the run cut this quantity off, as QuantityInfo::complete_at_1 has it.
bool cut_off(std::span<const Measure> measures, std::string_view quantity);

/// The runs of one cell that count: all of them or, where none failed and all came to the same measures to
/// the bit, of which one is no whole number, the first alone. Counts alone may agree by chance; where
/// measures of lengths and times agree in all runs, nothing was drawn. Where that is known of the scenario
/// already, as by another method's cell, runs that agree in whole numbers count as one, too, and runs that
/// all failed with the same words.
std::vector<const RunRecord*> counted_runs(std::span<const RunRecord* const> cell,
                                           bool nothing_is_drawn = false);

/// Compares cells that differ in one label and agree in all others, run by run under the same seed, each run
/// by its run_value(). Throws InputError for a label, baseline or quantity that no run has, a quantity asked
/// about twice, and two runs of one cell and seed, or of one cell and two versions: then the records are of
/// more than one version of a scenario. O(n log n) in measures;
/// O(n²) in the runs of a cell where times were cut off.
Comparison compare(std::span<const RunRecord> records, const CompareOptions& options = {});

/// What the reader of the numbers has to know beside them.
struct Remark {
  bool warning{};
  std::string text;  ///< a sentence or more
};

/// Runs that are the same, runs that failed, times that were cut off, what the tests are and their family.
std::vector<Remark> remarks(const Comparison& comparison);

/// Aligned tables for people, numbers to four digits, and the remarks.
std::string table_text(const Comparison& comparison);

/// The same with full precision. What is unknown or infinite is null.
nlohmann::json to_json(const Comparison& comparison);

}  // namespace fairway
