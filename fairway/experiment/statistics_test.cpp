// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

using testing::ElementsAre;

std::vector<double> one_to(int n) {
  std::vector<double> values(static_cast<std::size_t>(n));
  std::iota(values.begin(), values.end(), 1.0);
  return values;
}

TEST(MeanTest, OfOneToTenIsWhatRPrintsForItsTTest) {
  const MeanEstimate e = estimate_mean(one_to(10));  // t.test(1:10)
  EXPECT_EQ(e.count, 10U);
  EXPECT_DOUBLE_EQ(e.mean, 5.5);
  EXPECT_NEAR(e.deviation, 3.02765035409749, 1e-14);
  EXPECT_NEAR(e.low, 3.334149, 5e-7);
  EXPECT_NEAR(e.high, 7.665851, 5e-7);
}

TEST(MeanTest, HalfWidthsAreThoseOfTheTableOfStudentsT) {
  // two-sided 95 and 99 %, degrees of freedom 1, 2, 5, 10, 30, 120; any table of the t distribution
  const std::array<int, 6> freedom{1, 2, 5, 10, 30, 120};
  const std::array<double, 6> t95{12.706, 4.303, 2.571, 2.228, 2.042, 1.980};
  const std::array<double, 6> t99{63.657, 9.925, 4.032, 3.169, 2.750, 2.617};
  for (std::size_t i = 0; i < freedom.size(); ++i) {
    const std::vector<double> values = one_to(freedom[i] + 1);
    for (const auto& [confidence, t] : {std::pair{0.95, t95[i]}, std::pair{0.99, t99[i]}}) {
      const MeanEstimate e = estimate_mean(values, confidence);
      EXPECT_NEAR((e.high - e.mean) * std::sqrt(values.size()) / e.deviation, t, 5.1e-4);
    }
  }
}

TEST(MeanTest, OfTwoValuesHasTheClosedFormOfCauchy) {
  const MeanEstimate e = estimate_mean(std::vector{1.0, 3.0});
  EXPECT_NEAR(e.high, 2.0 + std::tan(0.475 * std::numbers::pi), 1e-12);  // s / sqrt(2) = 1
}

TEST(MeanTest, KeepsTheDigitsOfTheHardReferenceSetsOfNist) {
  // NIST StRD, univariate: NumAcc1, NumAcc3 and NumAcc4, certified mean and deviation
  const MeanEstimate first = estimate_mean(std::vector{10000001.0, 10000003.0, 10000002.0});
  EXPECT_EQ(first.mean, 10000002.0);
  EXPECT_EQ(first.deviation, 1.0);

  for (const double base : {1000000.0, 10000000.0}) {
    std::vector<double> values{base + 0.2};
    for (int i = 0; i < 500; ++i) values.insert(values.end(), {base + 0.1, base + 0.3});
    const MeanEstimate e = estimate_mean(values);
    EXPECT_NEAR(e.mean, base + 0.2, 1e-8);
    EXPECT_NEAR(e.deviation, 0.1, 2e-8);  // the values themselves are rounded to 1e-9
  }
}

TEST(MeanTest, IsDefinedForNoneOneAndEqualValues) {
  const MeanEstimate none = estimate_mean({});
  EXPECT_TRUE(std::isnan(none.mean) && std::isnan(none.deviation));
  EXPECT_TRUE(std::isinf(none.low) && std::isinf(none.high) && none.low < none.high);

  const MeanEstimate one = estimate_mean(std::vector{3.0});
  EXPECT_EQ(one.mean, 3.0);
  EXPECT_TRUE(std::isnan(one.deviation));
  EXPECT_TRUE(std::isinf(one.low) && std::isinf(one.high) && one.low < one.high);

  const MeanEstimate equal = estimate_mean(std::vector<double>(7, 0.1));
  EXPECT_EQ(equal.mean, 0.1);
  EXPECT_EQ(equal.deviation, 0.0);
  EXPECT_EQ(equal.low, 0.1);
  EXPECT_EQ(equal.high, 0.1);
}

TEST(MeanTest, OfSomethingNotFiniteIsUnknown) {
  const MeanEstimate e = estimate_mean(std::vector{1.0, std::numeric_limits<double>::infinity()});
  EXPECT_TRUE(std::isnan(e.mean) && std::isnan(e.low) && std::isnan(e.high));
}

TEST(MeanTest, RefusesAConfidenceThatIsNone) {
  EXPECT_THROW(estimate_mean({}, 95.0), std::domain_error);
  EXPECT_THROW(estimate_mean({}, 1.0), std::domain_error);
  EXPECT_THROW(estimate_mean({}, std::nan("")), std::domain_error);
}

TEST(MeanTest, IntervalHoldsTheTrueMeanAsOftenAsItSays) {
  constexpr int samples = 20'000;
  Rng rng{1};
  int held = 0;
  for (int i = 0; i < samples; ++i) {
    std::array<double, 5> values{};
    for (double& x : values) x = 10.0 + 3.0 * rng.normal();
    const MeanEstimate e = estimate_mean(values);
    held += e.low <= 10.0 && 10.0 <= e.high ? 1 : 0;
  }
  // one standard error is sqrt(0.95 * 0.05 / 20000) = 0.0015
  EXPECT_NEAR(static_cast<double>(held) / samples, 0.95, 0.006);
}

TEST(PairedDifferenceTest, OfStudentsSleepDataIsWhatRPrints) {
  // "Student" 1908; t.test(extra ~ group, data = sleep, paired = TRUE)
  const std::vector<double> first{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
  const std::vector<double> second{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};
  const MeanEstimate e = paired_difference(first, second);
  EXPECT_NEAR(e.mean, -1.58, 1e-12);
  EXPECT_NEAR(e.low, -2.4598858, 5e-8);
  EXPECT_NEAR(e.high, -0.7001142, 5e-8);
}

TEST(PairedDifferenceTest, NeedsPairs) {
  EXPECT_THROW(paired_difference(std::vector{1.0}, std::vector{1.0, 2.0}), std::invalid_argument);
}

struct PublishedRate {
  std::size_t successes, trials;
  double low, high;
};

TEST(RateTest, IntervalsAreThoseOfNewcombesTable) {
  // R. G. Newcombe 1998, Two-sided confidence intervals for the single proportion, table I, method 3
  const std::array<PublishedRate, 4> table{{{81, 263, 0.2553, 0.3662},
                                            {15, 148, 0.0624, 0.1605},
                                            {0, 20, 0.0000, 0.1611},
                                            {1, 29, 0.0061, 0.1718}}};
  for (const PublishedRate& row : table) {
    const RateEstimate wilson = wilson_interval(row.successes, row.trials);
    EXPECT_NEAR(wilson.low, row.low, 5.1e-5);
    EXPECT_NEAR(wilson.high, row.high, 5.1e-5);
  }
}

TEST(RateTest, OfNoneAndOfAllTouchTheEnds) {
  // z² / (n + z²), Wilson's bound of 0 in n
  constexpr double z = 1.959963984540054;
  EXPECT_EQ(wilson_interval(0, 20).low, 0.0);
  EXPECT_NEAR(wilson_interval(0, 20).high, z * z / (20.0 + z * z), 1e-15);
  EXPECT_EQ(wilson_interval(20, 20).high, 1.0);
  EXPECT_NEAR(wilson_interval(20, 20).low, 20.0 / (20.0 + z * z), 1e-15);
}

TEST(Statistics, FishersExactTestIsThatOfPublishedExamples) {
  EXPECT_NEAR(fisher_exact(3, 4, 1, 4), 34.0 / 70.0, 1e-12);      // Fisher's tea (1935): 2 (1 + 16) / 70
  EXPECT_NEAR(fisher_exact(1, 12, 9, 12), 0.002759456, 1e-9);     // R, fisher.test(rbind(c(1,11), c(9,3)))
  EXPECT_NEAR(fisher_exact(2, 5, 0, 100), 10.0 / 5460.0, 1e-12);  // C(5,2) / C(105,2)
  EXPECT_EQ(fisher_exact(0, 5, 0, 100), 1.0);                     // only one table has these totals
  EXPECT_EQ(fisher_exact(0, 0, 3, 7), 1.0);
  EXPECT_THROW(fisher_exact(6, 5, 0, 1), std::invalid_argument);
}

TEST(RateTest, OfNoTrialsIsUnknown) {
  const RateEstimate e = wilson_interval(0, 0);
  EXPECT_TRUE(std::isnan(e.rate));
  EXPECT_EQ(e.low, 0.0);
  EXPECT_EQ(e.high, 1.0);
}

TEST(RateTest, RefusesMoreSuccessesThanTrials) { EXPECT_THROW(wilson_interval(2, 1), std::invalid_argument); }

TEST(BoxTest, QuartilesOfOneToTenAreThoseOfR) {
  const BoxSummary box = summarize({10, 1, 9, 2, 8, 3, 7, 4, 6, 5});  // quantile(1:10)
  EXPECT_EQ(box.count, 10U);
  EXPECT_EQ(box.min, 1.0);
  EXPECT_EQ(box.lower_quartile, 3.25);
  EXPECT_EQ(box.median, 5.5);
  EXPECT_EQ(box.upper_quartile, 7.75);
  EXPECT_EQ(box.max, 10.0);
  EXPECT_EQ(box.low_whisker, 1.0);
  EXPECT_EQ(box.high_whisker, 10.0);
  EXPECT_TRUE(box.outliers.empty());
}

TEST(BoxTest, ValuesBeyondTheWhiskersAreOutliers) {
  // quartiles 2 and 4: whiskers reach to -1 and 7
  const BoxSummary box = summarize({-1.5, 2, 2, 2, 3, 3, 4, 4, 7.0, 7.5, 2, 4, 3});
  EXPECT_EQ(box.lower_quartile, 2.0);
  EXPECT_EQ(box.upper_quartile, 4.0);
  EXPECT_EQ(box.low_whisker, 2.0);
  EXPECT_EQ(box.high_whisker, 7.0);
  EXPECT_THAT(box.outliers, ElementsAre(-1.5, 7.5));
}

TEST(BoxTest, IsDefinedForNoneOneAndEqualValues) {
  const BoxSummary none = summarize({});
  EXPECT_EQ(none.count, 0U);
  EXPECT_TRUE(std::isnan(none.min) && std::isnan(none.median) && std::isnan(none.high_whisker));

  for (const std::vector<double>& values : {std::vector<double>{4.0}, std::vector<double>(5, 4.0)}) {
    const BoxSummary box = summarize(values);
    for (const double x : {box.min, box.lower_quartile, box.median, box.upper_quartile, box.max,
                           box.low_whisker, box.high_whisker}) {
      EXPECT_EQ(x, 4.0);
    }
    EXPECT_TRUE(box.outliers.empty());
  }
}

TEST(BoxTest, RefusesWhatCannotBeSorted) {
  EXPECT_THROW(summarize({1.0, std::nan("")}), std::domain_error);
  EXPECT_THROW(quantile(std::vector{1.0}, 1.5), std::domain_error);
}

}  // namespace
}  // namespace fairway
