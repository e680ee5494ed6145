// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/distance_transform.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "fairway/core/rng.hpp"

namespace fairway::avoa {
namespace {

std::vector<std::int32_t> by_looking_everywhere(const std::vector<std::uint8_t>& marked, int side) {
  std::vector<std::int32_t> squared(marked.size(), DistanceTransform::infinite);
  for (int i = 0; i < side * side; ++i) {
    for (int j = 0; j < side * side; ++j) {
      if (marked[static_cast<std::size_t>(j)] == 0) continue;
      const int down = i / side - j / side;
      const int across = i % side - j % side;
      auto& nearest = squared[static_cast<std::size_t>(i)];
      nearest = std::min(nearest, down * down + across * across);
    }
  }
  return squared;
}

std::vector<std::int32_t> transformed(const std::vector<std::uint8_t>& marked, int side) {
  DistanceTransform transform;
  transform.compute(marked, side);
  std::vector<std::int32_t> squared;
  for (int cell = 0; cell < side * side; ++cell) squared.push_back(transform.squared(cell));
  return squared;
}

TEST(DistanceTransform, IsWhatLookingEverywhereGives) {
  Rng rng{1};
  for (const double share : {0.001, 0.01, 0.1, 0.5, 0.99}) {
    for (const int side : {1, 2, 3, 7, 20, 41}) {
      for (int repetition = 0; repetition < 10; ++repetition) {
        std::vector<std::uint8_t> marked(static_cast<std::size_t>(side * side));
        for (std::uint8_t& cell : marked) cell = rng.uniform(0.0, 1.0) < share ? 1 : 0;
        EXPECT_EQ(transformed(marked, side), by_looking_everywhere(marked, side)) << side << " " << share;
      }
    }
  }
}

TEST(DistanceTransform, OfRunsOfCellsToo) {
  Rng rng{2};
  constexpr int side = 31;
  for (int repetition = 0; repetition < 200; ++repetition) {
    std::vector<std::uint8_t> marked(side * side);
    for (int run = 0; run < 5; ++run) {
      const auto from = static_cast<std::ptrdiff_t>(rng.index(side * side - side));
      std::fill_n(marked.begin() + from, rng.index(side), std::uint8_t{1});
    }
    EXPECT_EQ(transformed(marked, side), by_looking_everywhere(marked, side));
  }
}

TEST(DistanceTransform, IsExactUpToWhatIsEnough) {
  constexpr int side = 31;
  constexpr std::int32_t enough = 20;
  Rng rng{3};
  DistanceTransform transform;
  int near = 0;
  for (int repetition = 0; repetition < 50; ++repetition) {
    std::vector<std::uint8_t> marked(side * side);
    for (int mark = 0; mark < 4; ++mark) marked[rng.index(side * side)] = 1;
    transform.compute(marked, side);
    const std::vector<std::int32_t> exact = by_looking_everywhere(marked, side);
    for (int cell = 0; cell < side * side; ++cell) {
      const std::int32_t expected = exact[static_cast<std::size_t>(cell)];
      if (expected < enough) {
        EXPECT_EQ(transform.squared(cell, enough), expected);
        ++near;
      } else {
        EXPECT_GE(transform.squared(cell, enough), enough);
      }
    }
  }
  EXPECT_GT(near, 1000);
}

TEST(DistanceTransform, OfOneCellIsExactToTheFarCornerOfTheLargestPicture) {
  constexpr int side = 1000;
  std::vector<std::uint8_t> marked(side * side);
  marked.front() = 1;
  const std::vector<std::int32_t> squared = transformed(marked, side);
  for (std::size_t i = 0; i < squared.size(); i += 997) {
    const auto row = static_cast<std::int32_t>(i / side);
    const auto column = static_cast<std::int32_t>(i % side);
    ASSERT_EQ(squared[i], row * row + column * column);
  }
  EXPECT_EQ(squared.back(), 2 * 999 * 999);
}

TEST(DistanceTransform, IsInfiniteWhereNothingIsMarked) {
  const std::vector<std::uint8_t> marked(25);
  EXPECT_EQ(std::ranges::count(transformed(marked, 5), DistanceTransform::infinite), 25);
}

TEST(DistanceTransform, OfOnePictureKnowsNothingOfTheLast) {
  DistanceTransform transform;
  std::vector<std::uint8_t> marked(49, 1);
  transform.compute(marked, 7);
  std::ranges::fill(marked, std::uint8_t{0});
  marked[24] = 1;
  transform.compute(marked, 7);
  EXPECT_EQ(transform.squared(0), 18);
}

}  // namespace
}  // namespace fairway::avoa
