// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/planar_map.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/error.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/planning/testing/four_obstacles.hpp"

namespace fairway {
namespace {

using encounters::sphere;
using encounters::wall;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A square with corners (0, 0) and (side, side), counter-clockwise with n as x and e as y.
constexpr auto square = [](double side) {
  return std::array<Vec3, 4>{Vec3{0, 0, 0}, Vec3{side, 0, 0}, Vec3{side, side, 0}, Vec3{0, side, 0}};
};

TEST(PlanarMap, ASphereIsADiscOfItsRadiusWhateverItsDepth) {
  const std::array obstacles{sphere(10, 0, 2, 300)};
  const PlanarMap map{obstacles, 1.5};
  EXPECT_DOUBLE_EQ(map.clearance({0, 0}), 10 - 2 - 1.5);
  EXPECT_DOUBLE_EQ(map.clearance({10, 1}), -1 - 1.5);
  EXPECT_DOUBLE_EQ(map.clearance({0, -5}, {20, -5}), 5 - 2 - 1.5);
  EXPECT_DOUBLE_EQ(map.clearance({0, -5}, {5, 0}), 5 - 2 - 1.5);
}

TEST(PlanarMap, AWallHasAnInflatedSideAndRoundEnds) {
  const std::array obstacles{wall({0, 0, 5}, {0, 10, 90})};
  const PlanarMap map{obstacles, 1.0};
  EXPECT_DOUBLE_EQ(map.clearance({3, 5}), 2.0);
  EXPECT_DOUBLE_EQ(map.clearance({3, 14}), 4.0);
  EXPECT_DOUBLE_EQ(map.clearance({3, 5}, {8, 5}), 2.0);
  EXPECT_DOUBLE_EQ(map.clearance({-3, 5}, {3, 5}), -1.0);  // crosses it
  EXPECT_DOUBLE_EQ(map.clearance({-2, 2}, {-2, 8}), 1.0);  // beside it
}

TEST(PlanarMap, APolygonIsSolid) {
  const auto corners = square(4);
  const std::array obstacles{Obstacle{.kind = Obstacle::Kind::polygon, .vertices = corners}};
  const PlanarMap map{obstacles, 0.5};
  EXPECT_DOUBLE_EQ(map.clearance({6, 2}), 1.5);
  EXPECT_DOUBLE_EQ(map.clearance({3, 2}), -1.5);
  EXPECT_DOUBLE_EQ(map.clearance({7, 8}), 4.5);                             // 3-4-5 from a corner
  EXPECT_DOUBLE_EQ(map.clearance({1, 1}, {3, 2}), -0.5);                    // wholly inside
  EXPECT_DOUBLE_EQ(map.clearance({-1, 2}, {5, 2}), -0.5);                   // right through
  EXPECT_DOUBLE_EQ(map.clearance({6, -9}, {6, 9}), 1.5);                    // past a side
  EXPECT_NEAR(map.clearance({0, 9}, {9, 0}), std::sqrt(0.5) - 0.5, 1e-15);  // past a corner: n + e = 9
}

TEST(PlanarMap, OwnsItsObstacles) {
  std::vector<Vec3> corners{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  std::vector<Obstacle> obstacles{{.kind = Obstacle::Kind::polygon, .vertices = corners}};
  const PlanarMap map{obstacles, 0.0};
  const PlanarMap copy = map;
  EXPECT_EQ(map, copy);
  corners.assign(4, Vec3::Zero());
  obstacles.clear();
  EXPECT_DOUBLE_EQ(map.clearance({6, 2}), 2.0);
  EXPECT_DOUBLE_EQ(copy.clearance({6, 2}), 2.0);
}

TEST(PlanarMap, OverlappingObstaclesAreAUnion) {
  const std::array obstacles{sphere(0, 0, 3), sphere(4, 0, 3)};
  const PlanarMap both{obstacles, 0.0};
  EXPECT_DOUBLE_EQ(both.clearance({-5, 0}), 2.0);
  EXPECT_DOUBLE_EQ(both.clearance({9, 0}), 2.0);
  EXPECT_FALSE(both.is_free({2, -9}, {2, 9}));
}

TEST(PlanarMap, AStraightLineIsAsClearAsItsNearestPoint) {
  // against 4001 points of it: the distance to the nearest is at most half a step less
  const auto corners = square(3);
  for (std::uint64_t i = 0; i < 300; ++i) {
    Rng rng = Rng{3}.stream("line", i);
    const auto somewhere = [&] { return Vec3{rng.uniform(-9, 9), rng.uniform(-9, 9), 0.0}; };
    const std::array obstacles{sphere(rng.uniform(-9, 9), 5, rng.uniform(0, 3)),
                               wall(somewhere(), somewhere()),
                               Obstacle{.kind = Obstacle::Kind::polygon, .vertices = corners}};
    const PlanarMap map{obstacles, 0.7};
    const Vec2 a = seen_from_above(somewhere()), b = seen_from_above(somewhere());
    double least = infinity;
    for (int k = 0; k <= 4000; ++k) least = std::fmin(least, map.clearance(a + k / 4000.0 * (b - a)));
    const double exact = map.clearance(a, b);
    if (exact > -0.7) {
      EXPECT_LE(exact, least + 1e-12);
      EXPECT_GE(exact, least - (b - a).norm() / 8000);
    } else {
      EXPECT_LE(least, -0.7 + (b - a).norm() / 8000);
    }
  }
}

TEST(PlanarMap, WithoutInflationTouchingIsNotFree) {
  const std::array obstacles{wall({0, -5, 0}, {0, 5, 0})};
  const PlanarMap thin{obstacles, 0.0};
  EXPECT_FALSE(thin.is_free({-1, 0}, {1, 0}));
  EXPECT_FALSE(thin.is_free({0, 2}));
  EXPECT_TRUE(thin.is_free({1, 0}, {2, 0}));
  const PlanarMap grown{obstacles, 1.0};
  EXPECT_TRUE(grown.is_free({1, 0}, {2, 0}));  // the inflated rim may be touched
}

TEST(PlanarMap, OutwardIsWhereClearanceGrows) {
  const auto corners = square(4);
  const std::array obstacles{sphere(10, 10, 2),
                             Obstacle{.kind = Obstacle::Kind::polygon, .vertices = corners}};
  const PlanarMap map{obstacles, 1.0};
  for (std::uint64_t i = 0; i < 200; ++i) {
    Rng rng = Rng{4}.stream("outward", i);
    const Vec2 p{rng.uniform(-3, 14), rng.uniform(-3, 14)};
    const Vec2 out = map.outward(p);
    EXPECT_NEAR(out.norm(), 1.0, 1e-12);
    EXPECT_NEAR(map.clearance(p + 1e-7 * out), map.clearance(p) + 1e-7, 1e-9);
  }
  EXPECT_EQ(PlanarMap({}, 1.0).outward({3, 4}), Vec2(1, 0));
}

TEST(PlanarMap, BoundsContainTheInflatedObstacles) {
  const Eigen::AlignedBox2d box = four_obstacles::map().bounds();
  EXPECT_TRUE(box.min().isApprox(Vec2(10 - 4.2, 12 - 4.2)));
  EXPECT_TRUE(box.max().isApprox(Vec2(20 + 4.2, 33 + 4.2)));
  EXPECT_TRUE(PlanarMap({}, 1.0).bounds().isEmpty());
  EXPECT_EQ(PlanarMap({}, 1.0).clearance({0, 0}), infinity);
}

TEST(PlanarMap, GrownIsTheSameMapWithMoreInflation) {
  const PlanarMap grown = four_obstacles::map().grown(0.5);
  const PlanarMap expected{four_obstacles::obstacles(), four_obstacles::inflation_m + 0.5};
  EXPECT_EQ(grown, expected);
  EXPECT_TRUE(grown.bounds().isApprox(expected.bounds()));
  EXPECT_TRUE(PlanarMap({}, 1.0).grown(0.5).bounds().isEmpty());
}

TEST(PlanarMap, RefusesWhatHasNoShape) {
  const std::array<Vec3, 2> two{Vec3{0, 0, 0}, Vec3{1, 0, 0}};
  const std::array line{Obstacle{.kind = Obstacle::Kind::polygon, .vertices = two}};
  const std::array negative{sphere(0, 0, -1)};
  const std::array nowhere{sphere(std::nan(""), 0, 1)};
  EXPECT_THROW(PlanarMap(line, 1.0), InputError);
  EXPECT_THROW(PlanarMap(negative, 1.0), InputError);
  EXPECT_THROW(PlanarMap(nowhere, 1.0), InputError);
  EXPECT_THROW(PlanarMap({}, -1.0), InputError);
  EXPECT_THROW(PlanarMap({}, infinity), InputError);
}

}  // namespace
}  // namespace fairway
