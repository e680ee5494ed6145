// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/cross_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fairway {
namespace {

TEST(CrossFlow, BroadsideItIsTheDragOfTwentyOneStrips) {
  // 21/20 of 1/2 rho T L C_d v |v|, and no moment
  const CrossFlow hull{2.0, 0.2, 1000.0};
  const auto [force, moment] = hull.drag({3.0, -0.5, 0.25}, Vec3::Zero(), 1.5);
  EXPECT_EQ(force.x(), 0.0);
  EXPECT_NEAR(force.y(), 1.05 * 0.5 * 1000 * 0.2 * 2.0 * 1.5 * 0.25, 1e-10);
  EXPECT_NEAR(force.z(), -1.05 * 0.5 * 1000 * 0.2 * 2.0 * 1.5 * 0.0625, 1e-10);
  EXPECT_LT(moment.norm(), 1e-12);
}

TEST(CrossFlow, TurningOnTheSpotItIsTheSumOfCubes) {
  // sum |x|^3 dx over x = -1, -0.9 ... 1 is 2 * 0.1^4 (1 + 8 + ... + 1000) = 0.605; the integral is 0.5
  const CrossFlow hull{2.0, 0.2, 1000.0};
  const auto [force, moment] = hull.drag(Vec3::Zero(), {0.0, 2.0, -2.0}, 1.5);
  EXPECT_LT(force.norm(), 1e-12);
  EXPECT_NEAR(moment.y(), -0.5 * 1000 * 0.2 * 1.5 * 0.605 * 4.0, 1e-9);
  EXPECT_NEAR(moment.z(), 0.5 * 1000 * 0.2 * 1.5 * 0.605 * 4.0, 1e-9);
}

TEST(CrossFlow, ItOpposesTheMotionOfEveryStrip) {
  const CrossFlow hull{1.6, 0.19, 1025.0};
  for (int i = 1; i < 100; ++i) {
    const Vec3 v{std::sin(i), std::sin(2.0 * i), std::sin(3.0 * i)};
    const Vec3 omega{std::sin(5.0 * i), std::sin(7.0 * i), std::sin(11.0 * i)};
    const auto [force, moment] = hull.drag(v, omega, 1.0);
    EXPECT_LT(v.dot(force) + omega.dot(moment), 0.0);
  }
}

TEST(CrossFlow, HoernersCurveIsStraightBetweenItsPointsAndConstantBeyond) {
  EXPECT_DOUBLE_EQ(hoerner_drag(0.0, 1.0), 1.96608);
  EXPECT_DOUBLE_EQ(hoerner_drag(20.0, 1.0), 0.559315);
  EXPECT_NEAR(hoerner_drag(2.0 * (0.558473 + 0.646401) / 2.0, 1.0), (1.08356 + 0.998631) / 2.0, 1e-12);
}

TEST(CrossFlow, ACylinderHasItsDragCrisis) {
  const CylinderDrag cylinder{10.0};
  EXPECT_NEAR(cylinder.at(0.0), 0.68 * 1.20769, 1e-12);
  EXPECT_NEAR(cylinder.at(1.0e5), 0.68 * 1.21, 0.68 * 0.002);
  EXPECT_NEAR(cylinder.at(638292.9), 0.82 * 0.28422, 1e-12);  // the bottom of the curve
  EXPECT_NEAR(cylinder.at(1e8), 0.82 * 0.67808, 1e-12);
}

}  // namespace
}  // namespace fairway
