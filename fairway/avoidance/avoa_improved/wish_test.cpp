// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/wish.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "fairway/avoidance/avoa_improved/testing/unicycle.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::avoa_improved {
namespace {

TEST(AvoaImprovedWish, AMoverIsMetWhereBothCanBeAtTheSameTimeFirst) {
  Rng rng{6};
  int met = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec2 p{rng.uniform(-9, 9), rng.uniform(-9, 9)};
    const Vec2 v{rng.uniform(-2, 2), rng.uniform(-2, 2)};
    const auto there = meeting({p, p, 0.5, v}, Vec2::Zero(), 1.2, 20.0, 0.0);
    double first = -1.0;
    for (int k = 0; k <= 2000 && first < 0.0; ++k) {
      if ((p + 0.01 * k * v).norm() <= 1.2 * 0.01 * k) first = 0.01 * k;
    }
    ASSERT_EQ(there.has_value(), first >= 0.0) << i;
    if (!there) continue;
    ++met;
    EXPECT_LT((there->from - p - first * v).norm(), 0.03);
    EXPECT_EQ(there->velocity, Vec2(0, 0));
  }
  EXPECT_GT(met, 300);
}

TEST(AvoaImprovedWish, TheSolidThatIsMetReachesAheadOfItsBow) {
  const auto there = meeting({{12, -6}, {12, -6}, 0.75, {0, 0.6}}, Vec2::Zero(), 1.2, 20.0, 2.0);
  ASSERT_TRUE(there);
  EXPECT_LT((there->to - there->from - Vec2(0, 1.2)).norm(), 1e-12);
  EXPECT_FALSE(meeting({{12, -6}, {12, -6}, 0.75, {0, 0.6}}, Vec2::Zero(), 1.2, 5.0, 2.0)) << "too late";
}

TEST(AvoaImprovedWish, TheFartherItHasToTurnTheSlower) {
  const auto speed = [](double yaw) {
    Situation s{.period = 0.2};
    s.own.yaw = yaw;
    s.goal = {.position = {25, 0, 0}, .cruise_speed = 1.2};
    AvoaImproved::Memory memory;
    return wish_of({}, s, {}, memory, nullptr).speed;
  };
  EXPECT_EQ(speed(0.0), 1.2);
  EXPECT_EQ(speed(0.29), 1.2);
  EXPECT_NEAR(speed(0.75), 0.6, 1e-12);  // half way from 0.3 to 1.2 rad
  EXPECT_EQ(speed(1.3), 0.0);
  EXPECT_EQ(speed(3.0), 0.0);
}

TEST(AvoaImprovedWish, OutOfAGapThatIsTooNarrowForTheFullMarginItGoesWithHalfOfIt) {
  std::vector<Obstacle> ring;
  for (int k = 0; k < 24; ++k) {
    if (k == 12) continue;
    const double angle = k * pi / 12;
    ring.push_back(buoy(4.2 * std::cos(angle), 4.2 * std::sin(angle)));
  }
  Situation s{.period = 0.2};
  s.own.radius = 0.6;  // the gap is 2.17 m between centres: 0.18 m on both sides
  s.goal = {.position = {25, 0, 0}, .cruise_speed = 1.2};
  s.obstacles = ring;
  AvoaImproved::Memory memory;
  memory.chart.enter(s, true, 0.2);
  const Wish wish = wish_of({}, s, {}, memory, nullptr);
  EXPECT_EQ(wish.margin, 0.125);
  EXPECT_NEAR(std::abs(wish.heading), pi, 0.05);
}

}  // namespace
}  // namespace fairway::avoa_improved
