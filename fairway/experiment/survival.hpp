// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fairway/experiment/paired_tests.hpp"

namespace fairway {

/// How long something took, or, if it was cut off, how long it had taken by then.
struct ObservedTime {
  double time{};
  bool cut{};
};

/// The share that takes longer than `time`, from there to the next step. It is 1 before the first.
struct SurvivalStep {
  double time{};
  double share{};
  double
      variance{};  ///< Greenwood's, of the share's logarithm: the sum of d / (n (n - d)); infinite at share 0
  std::size_t at_risk{};
  std::size_t events{};
};

/// Kaplan and Meier's estimate (1958), one step for each time at which something ended; what is cut off at a
/// time is taken to be still under way then. It takes those that were cut off to be like the others that had
/// gone on for as long. O(n log n).
std::vector<SurvivalStep> kaplan_meier(std::span<const ObservedTime> times);

/// The time by which half have ended, with the interval of Brookmeyer and Crowley (1982) from bands on the
/// scale of the logarithm, as R's survfit() has them. Infinite where it was not reached.
MedianEstimate median_time(std::span<const SurvivalStep> steps, double confidence = 0.95);

/// The mean of times of which each counts up to a limit.
struct RestrictedMean {
  double mean{};
  double error{};  ///< Greenwood's standard error, as R's survfit() has it
  double low{};
  double high{};
};

/// The area below the steps up to `limit`, with its normal interval, which never leaves [0, limit].
RestrictedMean restricted_mean(std::span<const SurvivalStep> steps, double limit, double confidence = 0.95);

/// For each time what it adds to the restricted mean, n times that of all less n - 1 times that of the others
/// (Andersen, Hansen and Klein 2004): the time itself up to the limit, where none was cut off before. O(n²).
std::vector<double> restricted_pseudo_values(std::span<const ObservedTime> times, double limit);

}  // namespace fairway
