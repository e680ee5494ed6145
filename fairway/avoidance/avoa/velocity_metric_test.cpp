// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/velocity_metric.hpp"

#include <gtest/gtest.h>

namespace fairway::avoa {
namespace {

constexpr PolarVelocity desired{1.2, 3.0};

TEST(VelocityMetric, IsNothingForTheDesiredVelocityFarFromDanger) {
  EXPECT_EQ(VelocityMetric(desired, 1.5, 0.4, 0.2, 0.4)(desired, 0.0), 0.0);
}

TEST(VelocityMetric, AddsDeviationInSpeedAndHeadingAndDangerByTheirWeights) {
  const VelocityMetric metric{desired, 1.5, 0.4, 0.2, 0.4};
  EXPECT_NEAR(metric({0.6, 3.0}, 0.0), 0.4 * 0.6 / 1.5, 1e-15);
  EXPECT_NEAR(metric({1.2, 2.0}, 0.0), 0.2 * 1.0 / pi, 1e-15);
  EXPECT_NEAR(metric(desired, 0.25), 0.4 * 0.25, 1e-15);
  EXPECT_NEAR(metric({0.6, 2.0}, 0.25), 0.16 + 0.2 / pi + 0.1, 1e-15);
}

TEST(VelocityMetric, MeasuresHeadingsTheShortWayRound) {
  const VelocityMetric metric{desired, 1.5, 0.0, 1.0, 0.0};
  EXPECT_NEAR(metric({1.2, -3.0}, 0.0), (2.0 * pi - 6.0) / pi, 1e-15);
}

TEST(VelocityMetric, ScalesItsWeightsToOne) {
  const VelocityMetric metric{desired, 1.5, 4.0, 2.0, 4.0};
  EXPECT_NEAR(metric({0.6, 2.0}, 0.25), 0.16 + 0.2 / pi + 0.1, 1e-15);
  // the worst there is: no speed of 1.5 desired, the opposite heading, in a zone
  EXPECT_NEAR(VelocityMetric({1.5, 0.0}, 1.5, 7.0, 1.0, 3.0)({0.0, pi}, 1.0), 1.0, 1e-15);
}

TEST(VelocityMetric, WithoutWeightsEverythingIsAsGood) {
  EXPECT_EQ(VelocityMetric(desired, 1.5, 0.0, 0.0, 0.0)({0.1, -2.0}, 1.0), 0.0);
}

TEST(VelocityMetric, WhereSomebodyForeseesWhatLeadsAwayDiffersInSpeedByThatToo) {
  const VelocityMetric metric{{1.2, 0.0}, 1.5, 1.0, 0.0, 0.0, true};
  for (const double across : {0.5 * pi, -0.5 * pi}) EXPECT_NEAR(metric({1.2, across}, 0.0), 0.0, 1e-12);
  EXPECT_NEAR(metric({1.2, pi}, 0.0), 1.2 / 1.5, 1e-12);
  EXPECT_NEAR(metric({0.6, -2.0 * pi / 3.0}, 0.0), (0.6 + 0.3) / 1.5, 1e-12);
}

TEST(CostOfDanger, FallsLinearlyToNothingAtTheThreshold) {
  EXPECT_EQ(cost_of_danger(0.0, 0.3), 1.0);
  EXPECT_NEAR(cost_of_danger(0.1, 0.3), 2.0 / 3.0, 1e-15);
  EXPECT_EQ(cost_of_danger(0.3, 0.3), 0.0);
  EXPECT_EQ(cost_of_danger(9.0, 0.3), 0.0);
  EXPECT_EQ(cost_of_danger(0.0, 0.0), 0.0);
}

}  // namespace
}  // namespace fairway::avoa
