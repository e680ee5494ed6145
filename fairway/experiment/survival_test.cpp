// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/survival.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fairway/core/rng.hpp"
#include "fairway/experiment/statistics.hpp"

namespace fairway {
namespace {

// Remission of leukaemia in weeks under 6-MP, Freireich et al. 1963; R's MASS::gehan
const std::vector<ObservedTime> remission{
    {6, false},  {6, false},  {6, false},  {6, true},   {7, false}, {9, true},  {10, false},
    {10, true},  {11, true},  {13, false}, {16, false}, {17, true}, {19, true}, {20, true},
    {22, false}, {23, false}, {25, true},  {32, true},  {32, true}, {34, true}, {35, true}};

TEST(KaplanMeierTest, OfTheRemissionTimesIsWhatRPrints) {
  // summary(survfit(Surv(time, cens) ~ 1)) of treat == "6-MP": time, n.risk, n.event, survival, std.err
  struct Printed {
    double time;
    std::size_t at_risk, events;
    double share, error;
  };
  constexpr std::array<Printed, 7> printed{{{6, 21, 3, 0.857, 0.0764},
                                            {7, 17, 1, 0.807, 0.0869},
                                            {10, 15, 1, 0.753, 0.0963},
                                            {13, 12, 1, 0.690, 0.1068},
                                            {16, 11, 1, 0.627, 0.1141},
                                            {22, 7, 1, 0.538, 0.1282},
                                            {23, 6, 1, 0.448, 0.1346}}};
  const std::vector<SurvivalStep> steps = kaplan_meier(remission);
  ASSERT_EQ(steps.size(), printed.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i].time, printed[i].time);
    EXPECT_EQ(steps[i].at_risk, printed[i].at_risk);
    EXPECT_EQ(steps[i].events, printed[i].events);
    EXPECT_NEAR(steps[i].share, printed[i].share, 5.1e-4);
    EXPECT_NEAR(steps[i].share * std::sqrt(steps[i].variance), printed[i].error, 5.1e-5);
  }
}

TEST(KaplanMeierTest, MedianOfTheRemissionTimesIsWhatRPrints) {
  // print(survfit(...)): median 23, 0.95LCL 16, 0.95UCL NA
  const MedianEstimate median = median_time(kaplan_meier(remission));
  EXPECT_EQ(median.median, 23.0);
  EXPECT_EQ(median.low, 16.0);
  EXPECT_TRUE(std::isinf(median.high));
}

TEST(KaplanMeierTest, RestrictedMeanOfTheRemissionTimesIsWhatRPrints) {
  // print(survfit(...), print.rmean = TRUE): rmean 23.29, se(rmean) 2.83, upper limit 35
  const RestrictedMean mean = restricted_mean(kaplan_meier(remission), 35.0);
  EXPECT_NEAR(mean.mean, 23.29, 0.0051);
  EXPECT_NEAR(mean.error, 2.83, 0.0051);
  EXPECT_NEAR(mean.high - mean.mean, 1.959964 * mean.error, 1e-6);
}

TEST(KaplanMeierTest, WithoutCutsIsThePlainMedianAndMean) {
  const std::vector<ObservedTime> times{{4, false}, {1, false}, {3, false}, {2, false}};
  const std::vector<SurvivalStep> steps = kaplan_meier(times);
  EXPECT_EQ(median_time(steps).median, 2.5);  // the middle of where the share is a half, as R has it
  const RestrictedMean mean = restricted_mean(steps, 10.0);
  EXPECT_NEAR(mean.mean, 2.5, 1e-15);
  EXPECT_NEAR(mean.error, std::sqrt(1.25 / 4.0), 1e-15);  // mean of squares 1.25, over n
  EXPECT_NEAR(restricted_mean(steps, 2.5).mean, (1.0 + 2.0 + 2.5 + 2.5) / 4.0, 1e-15);
}

TEST(KaplanMeierTest, WhereHalfNeverEndedThereIsNoMedian) {
  const std::vector<ObservedTime> times{{10, false}, {600, true}, {600, true}};
  const MedianEstimate median = median_time(kaplan_meier(times));
  EXPECT_TRUE(std::isinf(median.median) && median.median > 0.0);
  EXPECT_TRUE(std::isinf(median.high));
  EXPECT_TRUE(kaplan_meier(std::vector<ObservedTime>(3, {600, true})).empty());
  EXPECT_EQ(restricted_mean({}, 600.0).mean, 600.0);
}

TEST(KaplanMeierTest, OneTimeBoundsNothing) {
  const MedianEstimate median = median_time(kaplan_meier(std::vector<ObservedTime>{{5, false}}));
  EXPECT_EQ(median.median, 5.0);
  EXPECT_TRUE(std::isinf(median.low) && median.low < 0.0);
  EXPECT_TRUE(std::isinf(median.high));
}

TEST(PseudoValuesTest, AreTheTimesUpToALimitThatCutThemAll) {
  const std::vector<ObservedTime> times{{600, true}, {120, false}, {600, true}, {480, false}, {120, false}};
  const std::vector<double> values = restricted_pseudo_values(times, 600.0);
  const std::array<double, 5> expected{600, 120, 600, 480, 120};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(values[i], expected[i], 1e-9);
}

TEST(PseudoValuesTest, AverageNearTheRestrictedMean) {
  // exactly so where the jackknife has no bias; Andersen, Hansen and Klein 2004
  const std::vector<double> values = restricted_pseudo_values(remission, 35.0);
  EXPECT_NEAR(estimate_mean(values).mean, restricted_mean(kaplan_meier(remission), 35.0).mean, 0.15);
}

TEST(RestrictedMeanTest, IntervalHoldsTheTrueMeanAsOftenAsItSays) {
  // exponential of mean 1, cut off at random in [0, 3], up to 1: the true restricted mean is 1 - 1/e
  constexpr int samples = 2000;
  Rng rng{5};
  int held = 0;
  for (int i = 0; i < samples; ++i) {
    std::vector<ObservedTime> times(60);
    for (ObservedTime& t : times) {
      const double time = -std::log(1.0 - rng.uniform(0.0, 1.0));
      const double cut = 3.0 * rng.uniform(0.0, 1.0);
      t = {std::fmin(time, cut), cut < time};
    }
    const RestrictedMean mean = restricted_mean(kaplan_meier(times), 1.0);
    held += std::abs(mean.mean - (1.0 - std::exp(-1.0))) <= 1.959964 * mean.error ? 1 : 0;
  }
  // one standard error is 0.0049; the normal interval falls short by about 0.01 of 60
  EXPECT_NEAR(static_cast<double>(held) / samples, 0.943, 0.018);
}

}  // namespace
}  // namespace fairway
