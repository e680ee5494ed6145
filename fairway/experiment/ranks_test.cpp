// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/ranks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace fairway {
namespace {

TEST(Ranks, EqualValuesShareTheMeanOfTheirs) {
  const std::vector<double> values{3.0, 1.0, std::numeric_limits<double>::infinity(), 1.0};
  EXPECT_EQ(ranks_of(values), (std::vector<double>{3.0, 1.5, 4.0, 1.5}));
  EXPECT_THROW(ranks_of(std::vector<double>{std::nan("")}), std::domain_error);
}

// Hollander and Wolfe (1973), table 7.1, rounding first base: R's friedman.test() says 11.143, p 0.003805
TEST(Ranks, FriedmansTestIsThatOfR) {
  const std::vector<std::vector<double>> times{
      {5.40, 5.50, 5.55}, {5.85, 5.70, 5.75}, {5.20, 5.60, 5.50}, {5.55, 5.50, 5.40}, {5.90, 5.85, 5.70},
      {5.45, 5.55, 5.60}, {5.40, 5.40, 5.35}, {5.45, 5.50, 5.35}, {5.25, 5.15, 5.00}, {5.85, 5.80, 5.70},
      {5.25, 5.20, 5.10}, {5.65, 5.55, 5.45}, {5.60, 5.35, 5.45}, {5.05, 5.00, 4.95}, {5.50, 5.50, 5.40},
      {5.45, 5.55, 5.50}, {5.55, 5.55, 5.35}, {5.45, 5.50, 5.55}, {5.50, 5.45, 5.25}, {5.65, 5.60, 5.40},
      {5.70, 5.65, 5.55}, {6.30, 6.30, 6.25}};
  const FriedmanTest test = friedman_test(times);
  EXPECT_NEAR(test.statistic, 11.143, 5e-4);
  EXPECT_NEAR(test.p, 0.003805, 5e-7);
  EXPECT_NEAR(test.mean_ranks[0] + test.mean_ranks[1] + test.mean_ranks[2], 6.0, 1e-12);
}

TEST(Ranks, BlocksInWhichAllAreAlikeShowNothing) {
  const FriedmanTest test = friedman_test(std::vector<std::vector<double>>{{1.0, 1.0}, {2.0, 2.0}});
  EXPECT_EQ(test.statistic, 0.0);
  EXPECT_EQ(test.p, 1.0);
}

TEST(Ranks, ATreatmentThatIsAlwaysBestHasRankOne) {
  const FriedmanTest test = friedman_test(std::vector<std::vector<double>>(8, {2.0, 1.0, 3.0}));
  EXPECT_EQ(test.mean_ranks, (std::vector<double>{2.0, 1.0, 3.0}));
  EXPECT_NEAR(test.statistic, 16.0, 1e-12);  // n (k - 1) where all blocks agree
}

// Demsar (2006), table 5a: critical values of Nemenyi's test at 0.05, which are quantiles over the root of 2
TEST(Ranks, QuantilesOfTheRangeAreTheTabulatedOnes) {
  const std::vector<std::pair<std::size_t, double>> table{{2, 1.960}, {3, 2.343}, {4, 2.569},
                                                          {5, 2.728}, {7, 2.949}, {10, 3.164}};
  for (const auto& [count, value] : table)
    EXPECT_NEAR(range_quantile(0.95, count) / std::sqrt(2.0), value, 1e-3) << count;
  EXPECT_NEAR(range_quantile(0.90, 10) / std::sqrt(2.0), 2.920, 1e-3);
  EXPECT_THROW(range_quantile(1.0, 3), std::domain_error);
}

// Demsar (2006), section 3.2.2: four classifiers on fourteen data sets at 0.05
TEST(Ranks, TheCriticalDifferenceIsDemsars) { EXPECT_NEAR(nemenyi_difference(4, 14), 1.25, 5e-3); }

}  // namespace
}  // namespace fairway
