// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fairway {

/// A median with its confidence interval; the whole line where so few values bound nothing.
struct MedianEstimate {
  double median{};
  double low{};
  double high{};
};

/// Up to so many pairs the null distribution of the signed rank statistic is counted out.
inline constexpr std::size_t most_exact_pairs = 50;

/// Hodges and Lehmann's estimate (1963): the median of the Walsh averages (x[i] + x[j]) / 2, i <= j. It takes
/// the differences to be independent and symmetric about one value. The interval's ends are Walsh averages
/// whose places come from the exact distribution of the signed rank statistic up to most_exact_pairs, from
/// the normal one beyond (Hollander and Wolfe 1999, equations 3.23 and 3.31); ties and zeros make it wider
/// than it needs to be. At 95 % fewer than six differences have the whole line. Of no or of values that are
/// not finite the median is NaN. O(n) memory, O(n) for each of some hundred steps.
MedianEstimate hodges_lehmann(std::span<const double> differences, double confidence = 0.95);

/// A two-sided test of pairs.
struct PairedTest {
  std::size_t pairs{};  ///< that decide: those without a difference do not
  double statistic{};
  double p{};       ///< 1 where no pair decides
  double effect{};  ///< in the direction of the first of each pair; 0 where no pair decides
  bool exact{};     ///< else the normal approximation
};

/// Wilcoxon's signed rank test (1945) that differences are symmetric about 0; the statistic is the sum of the
/// ranks of the positive ones, as R's V. Exact up to most_exact_pairs unless there are ties or zeros, else
/// normal with corrections for ties and continuity, as R's wilcox.test(). Differences within `grain` of each
/// other tie, and within it of 0 are zero and left out. The effect is the matched-pairs rank-biserial
/// correlation, (positive - negative ranks) / all of them (Kerby 2014). O(n log n).
PairedTest signed_rank_test(std::span<const double> differences, double grain = 0.0);

/// The exact sign test of pairs of which `more` have the larger value first and `less` second; the statistic
/// is `more`, the effect (more - less) / (more + less).
PairedTest sign_test(std::size_t more, std::size_t less);

/// Pairs of answers, yes or no.
struct PairedAnswers {
  std::size_t both{};
  std::size_t first{};   ///< only the first of the pair is a yes
  std::size_t second{};  ///< only the second is
  std::size_t neither{};
};

/// McNemar's test (1947), exact: a binomial test of the pairs that disagree. The statistic is `first`, the
/// effect Cohen's g (1988), first / (first + second) - 1/2.
PairedTest mcnemar_test(const PairedAnswers& answers);

/// A difference of two rates of the same pairs.
struct RateDifference {
  std::size_t pairs{};
  double difference{};  ///< first - second; NaN of no pairs
  double low{};
  double high{};
};

/// Newcombe's interval (1998, Statistics in Medicine 17, 2635-2650, method 10): squares of the distances to
/// the ends of both Wilson intervals, joined by the correlation of the answers, less n / 2 where it is
/// positive.
RateDifference paired_rate_difference(const PairedAnswers& answers, double confidence = 0.95);

/// p values adjusted by Holm (1979), so that the chance of any false rejection among all of them is kept: the
/// k-th smallest times (m - k + 1), never below the one before, at most 1. NaNs are not counted and stay.
std::vector<double> holm_adjusted(std::span<const double> p);

}  // namespace fairway
