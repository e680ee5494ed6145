// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/orca2d/shore.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace fairway::orca2d {
namespace {

using Kind = Landmark::Kind;

const std::vector<Vec3> square{{2, -1, 0}, {4, -1, 0}, {4, 1, 0}, {2, 1, 0}};

/// North from (0, 0) a step of 2 m, east of it another: solid is north and west of the corner at (2, 2).
const std::vector<Vec3> step{{0, -6, 0}, {6, -6, 0}, {6, 6, 0}, {2, 6, 0}, {2, 2, 0}, {0, 2, 0}};

Obstacle polygon(const std::vector<Vec3>& vertices) {
  return {.kind = Obstacle::Kind::polygon, .vertices = vertices};
}

std::vector<Landmark> seen(const std::vector<Obstacle>& obstacles, const Vec2& position,
                           double range = 100.0) {
  const Shore shore{obstacles, {position, range, range}};
  return {shore.landmarks().begin(), shore.landmarks().end()};
}

TEST(OrcaShore, OfASolidOnlyTheWallsThatFaceOwnShipAreSeenNearestFirst) {
  const std::vector<Landmark> ahead = seen({polygon(square)}, {0.0, 0.0});
  ASSERT_EQ(ahead.size(), 1U);
  EXPECT_EQ(ahead[0].edge, 3U);  // (2, 1) to (2, -1)
  EXPECT_EQ(ahead[0].distance, 2.0);

  const std::vector<Landmark> slanting = seen({polygon(square)}, {0.0, 2.0});
  ASSERT_EQ(slanting.size(), 2U);
  EXPECT_EQ(slanting[0].edge, 2U);
  EXPECT_EQ(slanting[1].edge, 3U);
}

TEST(OrcaShore, FromInsideThereIsOnlyTheNearestWayOut) {
  for (const Vec2& position : {Vec2{2.1, 0.0}, Vec2{2.1, 0.5}}) {
    const std::vector<Landmark> inside = seen({polygon(square)}, position);
    ASSERT_EQ(inside.size(), 1U);
    EXPECT_EQ(inside[0].kind, Kind::wall_from_inside);
    EXPECT_EQ(inside[0].edge, 3U);
  }
}

TEST(OrcaShore, NearestToAReflexCornerIsInsideAndNearestToAConvexOneIsNot) {
  EXPECT_EQ(seen({polygon(step)}, {2.5, 1.5})[0].kind, Kind::wall_from_inside);
  EXPECT_EQ(seen({polygon(step)}, {1.5, 2.5})[0].kind, Kind::wall);
  EXPECT_EQ(seen({polygon(step)}, {-0.5, 2.5})[0].kind, Kind::wall);
}

TEST(OrcaShore, TellsConvexFromReflexCorners) {
  const std::vector<Obstacle> obstacles{polygon(step)};
  const Vec2 own{1.0, 4.0};
  const auto landmarks = seen(obstacles, own);
  const auto third = std::ranges::find(landmarks, 3U, &Landmark::edge);  // (2, 6) to (2, 2)
  ASSERT_NE(third, landmarks.end());
  const Wall wall = wall_at(obstacles[0], *third, own);
  EXPECT_TRUE(wall.starboard.is_convex);
  EXPECT_FALSE(wall.port.is_convex);
  EXPECT_EQ(wall.port.p, Vec2(1.0, -2.0));
  EXPECT_EQ(wall.port.beyond, Vec2(-1.0, 0.0));
  EXPECT_EQ(wall.starboard.beyond, Vec2(1.0, 0.0));
}

TEST(OrcaShore, AWallThatStandsFreeIsSeenFromBothSides) {
  const std::vector<Obstacle> obstacles{
      {.kind = Obstacle::Kind::segment, .from = {2, 5, 0}, .to = {2, -5, 0}}};
  for (const Vec2& own : {Vec2{0.0, 0.0}, Vec2{4.0, 0.0}}) {
    const Wall wall = wall_at(obstacles[0], seen(obstacles, own)[0], own);
    EXPECT_EQ(wall.starboard.p.y(), own.x() < 2.0 ? 5.0 : -5.0);
  }
}

TEST(OrcaShore, VerticesThatAllCoincideAreAPost) {
  const std::vector<Vec3> point(4, Vec3{3, 0, 0});
  const std::vector<Obstacle> obstacles{polygon(point)};
  const std::vector<Landmark> post = seen(obstacles, {0.0, 0.0});
  ASSERT_EQ(post.size(), 1U);
  const Wall wall = wall_at(obstacles[0], post[0], {0.0, 0.0});
  EXPECT_EQ(wall.starboard.p, Vec2(3.0, 0.0));
  EXPECT_EQ(wall.port.p, Vec2(3.0, 0.0));
}

TEST(OrcaShore, BeyondItsRangeNothingIsSeen) {
  const std::vector<Obstacle> obstacles{
      polygon(square), {.kind = Obstacle::Kind::sphere, .position = {0, 5, 0}, .radius = 3.0}};
  EXPECT_EQ(seen(obstacles, {0.0, 0.0}, 1.99).size(), 0U);
  EXPECT_EQ(seen(obstacles, {0.0, 0.0}, 2.0).size(), 2U);
}

TEST(OrcaShore, OfMoreThanItCanHoldItKeepsTheNearest) {
  std::vector<Obstacle> obstacles;
  for (int i = 0; i < 2000; ++i) {
    const double at = 3.0 + (i * 7919) % 2000;
    obstacles.push_back({.kind = Obstacle::Kind::sphere, .position = {at, 0, 0}, .radius = 1.0});
  }
  const std::vector<Landmark> kept = seen(obstacles, {0.0, 0.0}, 1e6);
  ASSERT_EQ(kept.size(), max_landmarks);
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(kept[i].distance, 2.0 + static_cast<double>(i));
}

}  // namespace
}  // namespace fairway::orca2d
