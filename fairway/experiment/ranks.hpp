// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fairway {

/// The ranks of values, the least having 1 and equal ones the mean of theirs. Infinities are values; NaN
/// throws std::domain_error. O(n log n).
std::vector<double> ranks_of(std::span<const double> values);

/// Friedman's test (1937) of whether several treatments do alike in blocks that all of them share.
struct FriedmanTest {
  std::size_t blocks{};
  std::vector<double> mean_ranks;  ///< of each treatment
  double statistic{};  ///< corrected for ties, as R's friedman.test; 0 where all blocks are tied throughout
  double p{1.0};       ///< by chi squared with treatments - 1 degrees of freedom
};

/// `blocks[i][j]` is what treatment j came to in block i, less being better. Throws std::invalid_argument for
/// blocks of different lengths or of fewer than two treatments.
FriedmanTest friedman_test(std::span<const std::vector<double>> blocks);

/// The quantile of the range of `count` independent standard normal variables, which is the studentized range
/// with infinite degrees of freedom; R's qtukey(p, count, Inf). To 1e-6, by integration and bisection. Throws
/// std::domain_error unless `p` is in (0, 1) and count at least 2.
double range_quantile(double p, std::size_t count);

/// Nemenyi's critical difference (1963; Demsar 2006, equation 3): mean ranks of `treatments` over `blocks`
/// that are farther apart differ, at a family-wise error of `alpha`.
double nemenyi_difference(std::size_t treatments, std::size_t blocks, double alpha = 0.05);

}  // namespace fairway
