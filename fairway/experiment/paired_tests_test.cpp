// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/paired_tests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

// Hamilton depression scale at the first and second visit, Hollander and Wolfe 1973, table 3.1; first -
// second, as in R's ?wilcox.test
const std::vector<double> depression{1.83 - 0.878, 0.50 - 0.647, 1.62 - 0.598, 2.48 - 2.05, 1.68 - 1.06,
                                     1.88 - 1.29,  1.55 - 1.06,  3.06 - 3.14,  1.30 - 1.29};

// "Student" 1908, group 1 less group 2 of R's sleep: one zero, one tie
const std::vector<double> sleep{0.7 - 1.9, -1.6 - 0.8, -0.2 - 1.1, -1.2 - 0.1, -0.1 - -0.1,
                                3.4 - 4.4, 3.7 - 5.5,  0.8 - 1.6,  0.0 - 4.6,  2.0 - 3.4};

TEST(SignedRankTest, OfTheDepressionScaleIsWhatRPrints) {
  // wilcox.test(x, y, paired = TRUE): V = 40, p-value = 0.03906; 20 of 512 orders are as far out
  const PairedTest test = signed_rank_test(depression);
  EXPECT_EQ(test.statistic, 40.0);
  EXPECT_NEAR(test.p, 20.0 / 512.0, 1e-15);
  EXPECT_TRUE(test.exact);
  EXPECT_NEAR(test.effect, (40.0 - 5.0) / 45.0, 1e-15);
}

TEST(SignedRankTest, WithTiesAndZerosIsWhatRPrints) {
  // wilcox.test(extra ~ group, data = sleep, paired = TRUE): V = 0, p-value = 0.009091
  const PairedTest test = signed_rank_test(sleep, 1e-12);
  EXPECT_EQ(test.statistic, 0.0);
  EXPECT_NEAR(test.p, 0.009091, 5e-7);
  EXPECT_FALSE(test.exact);
  EXPECT_EQ(test.pairs, 9U);
  EXPECT_EQ(test.effect, -1.0);
}

TEST(SignedRankTest, ExactChancesAreThoseOfAllOrders) {
  // every sign of 1 to 6: the share of statistics as far out, counted out
  std::array<double, 6> differences{};
  for (unsigned signs = 0; signs < 64; ++signs) {
    for (unsigned i = 0; i < 6; ++i) differences[i] = (signs >> i & 1U) != 0 ? i + 1.0 : -(i + 1.0);
    const PairedTest test = signed_rank_test(differences);
    int as_far = 0;
    for (unsigned other = 0; other < 64; ++other) {
      double sum = 0.0;
      for (unsigned i = 0; i < 6; ++i) sum += (other >> i & 1U) != 0 ? i + 1.0 : 0.0;
      as_far += std::abs(sum - 10.5) >= std::abs(test.statistic - 10.5) ? 1 : 0;
    }
    EXPECT_NEAR(test.p, as_far / 64.0, 1e-15);
  }
}

TEST(SignedRankTest, BeyondFiftyPairsIsNormalAndNearTheExact) {
  std::vector<double> differences(50);
  for (std::size_t i = 0; i < 50; ++i)
    differences[i] = (i % 3 == 0 ? -1.0 : 1.0) * (static_cast<double>(i) + 1.0);
  const PairedTest exact = signed_rank_test(differences);
  EXPECT_TRUE(exact.exact);
  differences.push_back(1e-9);
  const PairedTest normal = signed_rank_test(differences);
  EXPECT_FALSE(normal.exact);
  EXPECT_NEAR(normal.p, exact.p, 0.006);  // 0.044 and 0.040
}

TEST(SignedRankTest, OfNothingOrNoDifferenceSaysNothing) {
  for (const std::vector<double>& none : {std::vector<double>{}, std::vector<double>(5, 0.0)}) {
    const PairedTest test = signed_rank_test(none);
    EXPECT_EQ(test.pairs, 0U);
    EXPECT_EQ(test.p, 1.0);
    EXPECT_EQ(test.effect, 0.0);
  }
}

TEST(SignedRankTest, RejectsTheTrueAsOftenAsItSays) {
  constexpr int samples = 4000;
  Rng rng{2};
  int rejected = 0;
  for (int i = 0; i < samples; ++i) {
    std::array<double, 12> values{};
    for (double& x : values) x = rng.normal();
    rejected += signed_rank_test(values).p <= 0.05 ? 1 : 0;
  }
  // R's 2 * psignrank(13, 12) = 0.0425 is the largest chance below 0.05; one standard error is 0.0032
  EXPECT_NEAR(static_cast<double>(rejected) / samples, 0.0425, 0.0096);
}

TEST(HodgesLehmannTest, OfTheDepressionScaleIsAsPublished) {
  // Hollander and Wolfe 1999, examples 3.3 and 3.4 (second - first): -0.46, and [-0.786, -0.010] at 96.1 %,
  // which is what 95 % comes to with nine pairs
  const MedianEstimate e = hodges_lehmann(depression);
  EXPECT_NEAR(e.median, 0.46, 1e-12);
  EXPECT_NEAR(e.low, 0.010, 1e-12);
  EXPECT_NEAR(e.high, 0.786, 1e-12);
}

TEST(HodgesLehmannTest, EndsAreWalshAveragesInTheirPlaces) {
  // all Walsh averages, sorted; R's qsignrank(0.025, 20) = 53
  Rng rng{3};
  std::vector<double> values(20);
  for (double& x : values) x = rng.normal();
  std::vector<double> walsh;
  for (std::size_t i = 0; i < 20; ++i) {
    for (std::size_t j = i; j < 20; ++j) walsh.push_back(0.5 * (values[i] + values[j]));
  }
  std::ranges::sort(walsh);
  const MedianEstimate e = hodges_lehmann(values);
  EXPECT_EQ(e.low, walsh[53 - 1]);
  EXPECT_EQ(e.high, walsh[210 - 53]);
  EXPECT_NEAR(e.median, 0.5 * (walsh[104] + walsh[105]), 1e-15);
}

TEST(HodgesLehmannTest, FewerThanSixBoundNothing) {
  const MedianEstimate five = hodges_lehmann(std::vector{1.0, 2.0, 3.0, 4.0, 5.0});
  EXPECT_EQ(five.median, 3.0);
  EXPECT_TRUE(std::isinf(five.low) && std::isinf(five.high));
  const MedianEstimate six = hodges_lehmann(std::vector{1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
  EXPECT_EQ(six.low, 1.0);
  EXPECT_EQ(six.high, 6.0);
  EXPECT_TRUE(std::isnan(hodges_lehmann({}).median));
  EXPECT_TRUE(std::isnan(hodges_lehmann(std::vector{1.0, std::nan("")}).median));
  const MedianEstimate zeros = hodges_lehmann(std::vector<double>(9, 0.0));
  EXPECT_EQ(zeros.low, 0.0);
  EXPECT_EQ(zeros.high, 0.0);
}

TEST(HodgesLehmannTest, IntervalHoldsTheTrueCentreAsOftenAsItSays) {
  constexpr int samples = 2000;
  Rng rng{4};
  for (const std::size_t size : {10U, 60U}) {
    int held = 0;
    std::vector<double> values(size);
    for (int i = 0; i < samples; ++i) {
      for (double& x : values) x = 10.0 + std::pow(rng.normal(), 3.0);
      const MedianEstimate e = hodges_lehmann(values);
      held += e.low <= 10.0 && 10.0 <= e.high ? 1 : 0;
    }
    // one standard error is 0.0049; with ten the interval has 95.1 %
    EXPECT_NEAR(static_cast<double>(held) / samples, 0.95, 0.015) << size;
  }
}

TEST(McnemarTest, IsABinomialTestOfThosePairsThatDisagree) {
  // binom.test(1, 10)$p.value = 22/1024; binom.test(5, 10) = 1
  const PairedTest test = mcnemar_test({.both = 7, .first = 9, .second = 1, .neither = 3});
  EXPECT_NEAR(test.p, 22.0 / 1024.0, 1e-15);
  EXPECT_NEAR(test.effect, 0.4, 1e-15);  // 9/10 - 1/2
  EXPECT_EQ(mcnemar_test({.first = 5, .second = 5}).p, 1.0);
  EXPECT_EQ(mcnemar_test({.both = 20}).p, 1.0);
  EXPECT_EQ(mcnemar_test({.both = 20}).effect, 0.0);
  EXPECT_NEAR(mcnemar_test({.second = 30}).p, std::ldexp(1.0, -29), 1e-20);
}

TEST(RateDifferenceTest, IsNewcombesMethodTen) {
  // R's contingencytables, Newcombe_square_and_add_CI_paired_2x2(cavo_2012): -0.0621 (-0.1186 to -0.0046)
  const RateDifference cavo = paired_rate_difference({.both = 59, .first = 6, .second = 16, .neither = 80});
  EXPECT_NEAR(cavo.difference, -0.0621, 5.1e-5);
  EXPECT_NEAR(cavo.low, -0.1186, 5.1e-5);
  EXPECT_NEAR(cavo.high, -0.0046, 5.1e-5);
  // Fagerland, Lydersen and Laake 2014, Statistics in Medicine 33, 2850-2875, airway data: -0.507 to -0.026
  const RateDifference airway = paired_rate_difference({.both = 1, .first = 1, .second = 7, .neither = 12});
  EXPECT_NEAR(airway.low, -0.507, 5.1e-4);
  EXPECT_NEAR(airway.high, -0.026, 5.1e-4);
}

TEST(RateDifferenceTest, TurnsWithItsPairsAndIsDefinedAtTheEnds) {
  const RateDifference one = paired_rate_difference({.both = 20, .first = 12, .second = 2, .neither = 16});
  const RateDifference other = paired_rate_difference({.both = 20, .first = 2, .second = 12, .neither = 16});
  EXPECT_NEAR(one.low, -other.high, 1e-15);
  EXPECT_NEAR(one.high, -other.low, 1e-15);
  const RateDifference all = paired_rate_difference({.both = 20});
  EXPECT_EQ(all.difference, 0.0);
  EXPECT_TRUE(all.low < 0.0 && all.high > 0.0);
  const RateDifference none = paired_rate_difference({});
  EXPECT_TRUE(std::isnan(none.difference));
  EXPECT_EQ(none.low, -1.0);
}

TEST(HolmTest, AdjustsAsRDoes) {
  // p.adjust(c(0.01, 0.04, 0.03, 0.005), "holm"): 0.03 0.06 0.06 0.02, as 3 x 0.01, 2 x 0.03 and so on
  const std::vector<double> adjusted = holm_adjusted(std::vector{0.01, 0.04, 0.03, 0.005});
  EXPECT_NEAR(adjusted[0], 0.03, 1e-15);
  EXPECT_NEAR(adjusted[1], 0.06, 1e-15);
  EXPECT_NEAR(adjusted[2], 0.06, 1e-15);
  EXPECT_NEAR(adjusted[3], 0.02, 1e-15);
  EXPECT_EQ(holm_adjusted(std::vector{0.7, 0.6}), (std::vector{1.0, 1.0}));
}

TEST(HolmTest, DoesNotCountWhatWasNotTested) {
  const std::vector<double> adjusted = holm_adjusted(std::vector{0.01, std::nan(""), 0.02});
  EXPECT_NEAR(adjusted[0], 0.02, 1e-15);
  EXPECT_TRUE(std::isnan(adjusted[1]));
  EXPECT_NEAR(adjusted[2], 0.02, 1e-15);
  EXPECT_TRUE(holm_adjusted({}).empty());
}

}  // namespace
}  // namespace fairway
