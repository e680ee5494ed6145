// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/obstacle_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "fairway/core/testing/allocations.hpp"
#include "fairway/core/testing/random_obstacles.hpp"

namespace fairway {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double endless_reach = std::numeric_limits<double>::infinity();

ObstacleIndex tree_of(const std::vector<Obstacle>& obstacles) {
  return {obstacles.size(), [&](std::size_t i) { return &obstacles[i]; }};
}

/// Those whose surface is within `reach`, as the index finds them and as going through all of them does.
std::vector<std::size_t> found_by(const ObstacleIndex& index, const std::vector<Obstacle>& obstacles,
                                  const Vec3& place, double reach) {
  std::vector<std::size_t> all;
  index.visit(place, reach, [&](std::size_t i) {
    if (nearest_point(obstacles[i], place).distance <= reach) all.push_back(i);
    return reach;
  });
  std::ranges::sort(all);
  return all;
}

std::vector<std::size_t> found_one_by_one(const std::vector<Obstacle>& obstacles, const Vec3& place,
                                          double reach) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (nearest_point(obstacles[i], place).distance <= reach) all.push_back(i);
  }
  return all;
}

/// How many it looks at.
std::size_t looks_at(const ObstacleIndex& index, const Vec3& place, double reach) {
  std::size_t count = 0;
  index.visit(place, reach, [&](std::size_t) {
    ++count;
    return reach;
  });
  return count;
}

TEST(ObstacleIndex, FindsWhatGoingThroughAllOfThemFinds) {
  Rng rng{3};
  for (const double size : {50.0, 2000.0, 2e7}) {
    for (const std::size_t count : {0U, 1U, 5U, 40U, 700U}) {
      const RandomObstacles scene{count, size, rng.stream("scene", count)};
      const ObstacleIndex index = tree_of(scene.all);
      ASSERT_EQ(index.size(), count);
      for (int look = 0; look < 40; ++look) {
        const Vec3 place = RandomObstacles::place(1.3 * size, rng);
        // as far as one of them, to the bit, and by other distances
        const double exactly = count > 0 ? nearest_point(scene.all[rng.index(count)], place).distance : 1.0;
        for (const double reach : {-1.0, 0.0, exactly, 0.03 * size, size, endless_reach})
          ASSERT_EQ(found_by(index, scene.all, place, reach), found_one_by_one(scene.all, place, reach))
              << count << " in " << size << ", reach " << reach;
      }
    }
  }
}

TEST(ObstacleIndex, TheNearestIsFoundByLookingLessFarEachTime) {
  Rng rng{4};
  const RandomObstacles scene{500, 1000.0, Rng{5}};
  const ObstacleIndex index = tree_of(scene.all);
  for (int look = 0; look < 300; ++look) {
    const Vec3 place = RandomObstacles::place(1200.0, rng);
    double least = endless_reach, nearest = endless_reach;
    index.visit(place, endless_reach, [&](std::size_t i) {
      return least = std::min(least, nearest_point(scene.all[i], place).distance);
    });
    for (const Obstacle& each : scene.all) nearest = std::min(nearest, nearest_point(each, place).distance);
    ASSERT_EQ(least, nearest);
  }
}

TEST(ObstacleIndex, OnlyThosePointedToAreInIt) {
  const RandomObstacles scene{60, 100.0, Rng{6}};
  const ObstacleIndex index{scene.all.size(), [&](std::size_t i) -> const Obstacle* {
                              return i == 7 || i == 50 ? &scene.all[i] : nullptr;
                            }};
  EXPECT_THAT(found_by(index, scene.all, Vec3::Zero(), endless_reach), ElementsAre(7, 50));
  EXPECT_THAT(found_by({}, scene.all, Vec3::Zero(), endless_reach), IsEmpty());
}

TEST(ObstacleIndex, WhatHasNoShapeIsNearEverywhere) {
  RandomObstacles scene{40, 100.0, Rng{7}};
  scene.all[11] = {.kind = Obstacle::Kind::sphere, .position = {std::nan(""), 0, 0}, .radius = 1.0};
  scene.all[12] = {.kind = Obstacle::Kind::polygon};
  const ObstacleIndex index = tree_of(scene.all);
  std::vector<std::size_t> all;
  index.visit({1e6, 1e6, 0}, 1.0, [&](std::size_t i) {
    all.push_back(i);
    return 1.0;
  });
  EXPECT_THAT(all, ::testing::IsSupersetOf(std::vector<std::size_t>{11, 12}));
}

TEST(ObstacleIndex, LookingRoundCostsWhatIsNearAndNotWhatThereIs) {
  const auto mean_looks = [](std::size_t side) {
    std::vector<Obstacle> buoys;
    for (std::size_t i = 0; i < side * side; ++i)
      buoys.push_back(
          {.kind = Obstacle::Kind::sphere,
           .position = {10.0 * static_cast<double>(i % side), 10.0 * static_cast<double>(i / side), 0},
           .radius = 1.0});
    const ObstacleIndex index = tree_of(buoys);
    std::size_t sum = 0;
    for (const Obstacle& buoy : buoys) sum += looks_at(index, buoy.position, 15.0);
    return static_cast<double>(sum) / static_cast<double>(buoys.size());
  };
  const double few = mean_looks(20), many = mean_looks(100);
  EXPECT_LT(few, 40.0);
  EXPECT_LT(many, 1.2 * few);
}

TEST(ObstacleIndex, LookingRoundDoesNotAllocate) {
  const RandomObstacles scene{500, 1000.0, Rng{8}};
  const ObstacleIndex index = tree_of(scene.all);
  const long before = allocation_count();
  std::size_t sum = 0;
  for (int i = 0; i < 100; ++i) sum += looks_at(index, {10.0 * i, 0, 0}, 100.0);
  EXPECT_EQ(allocation_count(), before);
  EXPECT_GT(sum, 0U);
}

}  // namespace
}  // namespace fairway
