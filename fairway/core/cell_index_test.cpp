// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/cell_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/core/rng.hpp"
#include "fairway/core/testing/allocations.hpp"

namespace fairway {
namespace {

using ::testing::IsEmpty;
using ::testing::UnorderedElementsAreArray;

constexpr double endless = std::numeric_limits<double>::infinity();

CellIndex index_of(const std::vector<Vec3>& points, double edge) {
  CellIndex index;
  index.rebuild(points.size(), edge, [&](std::size_t i) { return points[i]; });
  return index;
}

std::vector<std::size_t> found(const CellIndex& index, const Vec3& place, double reach) {
  std::vector<std::size_t> all;
  index.visit(place, reach, [&](std::size_t i, double) { all.push_back(i); });
  return all;
}

/// By comparing with every point.
std::vector<std::size_t> compared(const std::vector<Vec3>& points, const Vec3& place, double reach) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((points[i] - place).squaredNorm() <= reach * reach) all.push_back(i);
  }
  return all;
}

std::vector<Vec3> scene(std::size_t count, const Vec3& size, Rng& rng) {
  std::vector<Vec3> points(count);
  for (Vec3& point : points) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) point[axis] = rng.uniform(-0.5, 0.5) * size[axis];
  }
  return points;
}

/// `side` cubed points, one a metre apart from the next.
std::vector<Vec3> cube(int side) {
  std::vector<Vec3> points;
  for (int i = 0; i < side * side * side; ++i)
    points.emplace_back(i % side, i / side % side, i / (side * side));
  return points;
}

TEST(CellIndex, FindsWhatAComparisonWithEveryPointFinds) {
  Rng rng{1};
  for (const Vec3& size : {Vec3{100, 100, 100}, Vec3{300, 200, 0}, Vec3{1e4, 1, 1}, Vec3{2e7, 2e7, 2e7}}) {
    for (const std::size_t count : {0U, 1U, 25U, 200U, 1500U}) {
      std::vector<Vec3> points = scene(count, size, rng);
      for (std::size_t i = 0; i + 1 < count; i += 7) points[i + 1] = points[i];               // at one place
      for (std::size_t i = 3; i + 1 < count; i += 11) points[i] = points[i].array().round();  // equally far
      for (const double edge : {0.0, 1.0, 15.0, endless}) {
        const CellIndex index = index_of(points, edge);
        for (const double reach : {0.0, 1.0, 7.0, 40.0, 1e5, endless}) {
          const Vec3 anywhere = scene(1, 1.2 * size, rng)[0];
          const Vec3 somebody = count > 0 ? points[rng.index(count)] : anywhere;
          for (const Vec3& place : {anywhere, somebody}) {
            ASSERT_THAT(found(index, place, reach), UnorderedElementsAreArray(compared(points, place, reach)))
                << count << " points, cells of " << index.edge() << ", reach " << reach;
          }
        }
      }
    }
  }
}

TEST(CellIndex, APointAtTheVeryLimitIsFound) {
  const std::vector<Vec3> points = cube(8);
  for (const double edge : {1.0, 0.1, 3.0}) {
    const CellIndex index = index_of(points, edge);
    for (const Vec3& place : points) {
      for (const double reach : {1.0, std::sqrt(2.0), 2.0})
        ASSERT_THAT(found(index, place, reach), UnorderedElementsAreArray(compared(points, place, reach)));
    }
  }
}

TEST(CellIndex, WhatIsNotFiniteIsNowhere) {
  std::vector<Vec3> points = cube(4);
  points[5].x() = std::nan("");
  points[6].z() = endless;
  const CellIndex index = index_of(points, 1.0);
  EXPECT_EQ(index.size(), 62U);
  EXPECT_THAT(found(index, {1, 1, 0}, 0.1), IsEmpty());
  EXPECT_EQ(found(index, {0, 0, 0}, endless).size(), 62U);
  EXPECT_THAT(found(index_of({Vec3::Constant(endless)}, 1.0), {0, 0, 0}, endless), IsEmpty());
}

TEST(CellIndex, LookingRoundCostsWhatIsNearAndNotWhatThereIs) {
  struct Looks {
    double mean;
    std::size_t most;
  };
  const auto looks = [](int side, double reach) {
    const std::vector<Vec3> points = cube(side);
    const CellIndex index = index_of(points, reach);
    Looks all{};
    for (const Vec3& place : points) {
      const std::size_t looked_at = index.visit(place, reach, [](std::size_t, double) {});
      all.mean += static_cast<double>(looked_at) / static_cast<double>(points.size());
      all.most = std::max(all.most, looked_at);
    }
    return all;
  };
  // at most the 27 cells round one's own of eight each, and what shares their buckets; the fewer are at the
  // rim the more are looked at
  for (const double reach : {1.0, 1.5, 2.0}) {
    const Looks thousand = looks(10, reach), many = looks(20, reach), most = looks(30, reach);
    for (const Looks& each : {thousand, many, most}) EXPECT_LT(each.most, 3U * 27U * 8U) << reach;
    EXPECT_LT(many.mean, 1.5 * thousand.mean) << reach;
    EXPECT_LT(most.mean, 1.5 * many.mean) << reach;
  }
}

TEST(CellIndex, AnOutlierDoesNotMakeTheCellsLarge) {
  std::vector<Vec3> points = cube(12);
  points.emplace_back(1e6, 1e6, 1e6);
  const CellIndex index = index_of(points, 1.0);
  EXPECT_LE(index.edge(), 4.0);
  EXPECT_LT(index.visit({6, 6, 6}, 1.0, [](std::size_t, double) {}), 200U);
}

TEST(CellIndex, TheReachOfSomeHoldsThemAndIsNotMuchMore) {
  Rng rng{2};
  const std::vector<Vec3> points = scene(1000, {500, 500, 100}, rng);
  const CellIndex index = index_of(points, 5.0);
  const auto is_even = [](std::size_t i) { return i % 2 == 0; };
  for (const std::size_t count : {1U, 10U, 100U, 500U}) {
    const Vec3& place = points[rng.index(points.size())];
    const double reach = index.reach_of(count, place, is_even);
    const auto near = [&](double within) {
      return std::ranges::count_if(found(index, place, within), is_even);
    };
    EXPECT_GE(near(reach), count);
    if (reach < endless && reach > index.edge()) {
      EXPECT_LT(near(0.5 * reach), count);
    }
  }
  EXPECT_EQ(index.reach_of(501, points[0], is_even), endless);
}

TEST(CellIndex, RebuildingAndLookingDoNotAllocate) {
  Rng rng{3};
  CellIndex index;
  index.reserve(2000);
  std::size_t sum = 0;
  long allocated = 0;
  for (int turn = 0; turn < 20; ++turn) {
    const std::vector<Vec3> points =
        scene(2000 - 90 * static_cast<std::size_t>(turn), {200, 200, 50.0 * turn}, rng);
    const long before = allocation_count();
    index.rebuild(points.size(), 10.0, [&](std::size_t i) { return points[i]; });
    for (const Vec3& place : points) index.visit(place, 10.0, [&](std::size_t i, double) { sum += i; });
    allocated += allocation_count() - before;
  }
  EXPECT_EQ(allocated, 0);
  EXPECT_GT(sum, 0U);
}

}  // namespace
}  // namespace fairway
