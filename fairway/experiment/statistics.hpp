// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fairway {

/// The probability beyond each end of a two-sided interval, (1 - confidence) / 2. Throws std::domain_error if
/// `confidence` is not in (0, 1).
double tail_of(double confidence);

/// A mean with its confidence interval. Of no values the mean is NaN; of fewer than two the deviation is
/// NaN and the interval is the whole line, which is what is known; of equal values the interval is that
/// value.
struct MeanEstimate {
  std::size_t count{};
  double mean{};
  double deviation{};  ///< of the sample, n - 1 below
  double low{};
  double high{};
};

/// Student's t interval: mean ± t(1 - (1 - confidence)/2, n - 1) · s / sqrt(n). It takes the values to be
/// independent and their mean to be about normal. A value that is not finite makes every number NaN.
/// `confidence` in (0, 1), else std::domain_error. O(n).
MeanEstimate estimate_mean(std::span<const double> values, double confidence = 0.95);

/// The mean of a[i] - b[i]: what pairs of runs under the same seed have in common cancels. Throws
/// std::invalid_argument if the lengths differ.
MeanEstimate paired_difference(std::span<const double> a, std::span<const double> b,
                               double confidence = 0.95);

/// A share of trials. Of no trials the share is NaN and the interval [0, 1].
struct RateEstimate {
  std::size_t successes{};
  std::size_t trials{};
  double rate{};
  double low{};
  double high{};
};

/// Wilson's score interval (E. B. Wilson 1927), without continuity correction. Also right near 0 and 1,
/// unlike rate ± z s. Throws std::invalid_argument if successes > trials.
RateEstimate wilson_interval(std::size_t successes, std::size_t trials, double confidence = 0.95);

/// Fisher's exact test (1922), two-sided: how likely, if both shares are the same, the totals given, is a
/// table no likelier than this one. As R's fisher.test. Throws likewise. O(first_trials + second_trials).
double fisher_exact(std::size_t first_successes, std::size_t first_trials, std::size_t second_successes,
                    std::size_t second_trials);

/// A count of rare events with its interval.
struct CountEstimate {
  double count{};
  double low{};
  double high{};
};

/// Garwood's exact interval (1936) for the mean of a Poisson count, from quantiles of chi squared. Throws
/// std::invalid_argument for a negative count.
CountEstimate poisson_interval(double count, double confidence = 0.95);

/// The quantile of sorted, finite values by linear interpolation at p (n - 1): type 7 of Hyndman and Fan
/// (1996), the usual one of R and NumPy. NaN of no values; `p` in [0, 1], else std::domain_error. O(1).
double quantile(std::span<const double> sorted, double p);

/// A box plot: five numbers, whiskers to the farthest values within 1.5 (q3 - q1) of the box (Tukey
/// 1977), and the values beyond, sorted. Of no values all are NaN.
struct BoxSummary {
  std::size_t count{};
  double min{};
  double lower_quartile{};
  double median{};
  double upper_quartile{};
  double max{};
  double low_whisker{};
  double high_whisker{};
  std::vector<double> outliers;
};

/// The box of finite values in any order; throws std::domain_error for others. O(n log n).
BoxSummary summarize(std::vector<double> values);

}  // namespace fairway
