// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/field.hpp"

#include <gtest/gtest.h>

#include "fairway/studies/disc.hpp"

namespace fairway::transport {
namespace {

TEST(RandomField, TheKindsOfASeedShareTheirDiscs) {
  const Field known = random_field(FieldKind::known, 7);
  const Field moving = random_field(FieldKind::moving, 7);
  ASSERT_EQ(moving.obstacles.size(), known.obstacles.size() + 3);
  for (std::size_t i = 0; i < known.obstacles.size(); ++i) {
    EXPECT_EQ(known.obstacles[i].position, moving.obstacles[i].position);
    EXPECT_EQ(known.obstacles[i].radius, moving.obstacles[i].radius);
    EXPECT_TRUE(known.obstacles[i].charted);
  }
}

TEST(RandomField, StartAndGoalAreClear) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Field field = random_field(FieldKind::moving, seed);
    ASSERT_GT(field.obstacles.size(), 3U);
    for (const ObstacleSpec& obstacle : field.obstacles) {
      EXPECT_GE((obstacle.position - field.start).norm() - obstacle.radius, footprint_radius + 2.0);
      if (obstacle.moves()) continue;
      EXPECT_GE((obstacle.position - field.goal).norm() - obstacle.radius, footprint_radius + 2.0);
    }
  }
}

TEST(Escape, AnEmptyFieldHasOne) { EXPECT_TRUE(has_escape({})); }

TEST(Escape, AWalledInStartHasNone) {
  Field field;
  for (int i = 0; i < 24; ++i) {
    const double angle = 2 * pi * i / 24;
    field.obstacles.push_back(disc({12 * std::cos(angle), 12 * std::sin(angle), 0}, 1.0));
  }
  EXPECT_FALSE(has_escape(field));
}

TEST(Escape, AGapMustTakeTheFootprint) {
  const auto gap = [](double width) {
    Field field;
    for (double e = -30; e <= 70; e += 1.0) {
      if (std::abs(e - 25.0) > width / 2) field.obstacles.push_back(disc({25, e, 0}, 0.5));
    }
    return field;
  };
  EXPECT_TRUE(has_escape(gap(12.0)));
  EXPECT_FALSE(has_escape(gap(6.0)));
}

TEST(Escape, WhoIsOverrunHasNone) {
  Field field;
  field.obstacles.push_back(disc({0, 30, 0}, 25.0, {0, -5, 0}));  // as wide as the field, faster than anyone
  EXPECT_FALSE(has_escape(field));
}

TEST(StayClear, BetweenTwoDiscsAndADrifterThatClosesInThereIsNoWayOut) {
  std::vector<ObstacleSpec> trap{disc({0, 0, 0}, 4), disc({0, 13, 0}, 4), disc({14, 6.5, 0}, 7)};  // a pocket
  const Vec3 inside{5.5, 6.5, 0};
  EXPECT_TRUE(can_stay_clear(trap, {-5, 30, 0}, 0.0));
  trap.push_back(disc({-6, 6.5, 0}, 6, {0.1, 0, 0}));
  EXPECT_FALSE(can_stay_clear(trap, inside, 0.0));
}

}  // namespace
}  // namespace fairway::transport
