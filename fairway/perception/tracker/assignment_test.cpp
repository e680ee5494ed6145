// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/tracker/assignment.hpp"

#include <gtest/gtest.h>

#include "fairway/core/rng.hpp"
#include "fairway/core/testing/allocations.hpp"

namespace fairway {
namespace {

using Gains = std::vector<std::vector<double>>;

Gains drawn(std::size_t rows, std::size_t columns, double share, Rng& rng) {
  Gains gains(rows, std::vector<double>(columns, 0.0));
  for (auto& row : gains) {
    for (double& gain : row) {
      if (rng.uniform(0, 1) < share) gain = rng.uniform(0.1, 10);
    }
  }
  return gains;
}

/// The greatest sum there is, by trying everything.
double best_sum(const Gains& gains, std::size_t row, std::vector<bool>& taken) {
  if (row == gains.size()) return 0.0;
  double best = best_sum(gains, row + 1, taken);
  for (std::size_t column = 0; column < taken.size(); ++column) {
    if (taken[column] || gains[row][column] == 0.0) continue;
    taken[column] = true;
    best = std::max(best, gains[row][column] + best_sum(gains, row + 1, taken));
    taken[column] = false;
  }
  return best;
}

double sum_of(Assignment& assignment, const Gains& gains, std::size_t columns) {
  assignment.begin(gains.size(), columns);
  for (std::size_t i = 0; i < gains.size(); ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      if (gains[i][j] > 0.0) assignment.offer(i, j, gains[i][j]);
    }
  }
  double sum = 0.0;
  std::vector<bool> taken(columns, false);
  const auto pairs = assignment.solve();
  EXPECT_EQ(pairs.size(), gains.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!pairs[i]) continue;
    EXPECT_FALSE(taken[*pairs[i]]) << "two rows have one column";
    EXPECT_GT(gains[i][*pairs[i]], 0.0) << "a pair that gains nothing";
    taken[*pairs[i]] = true;
    sum += gains[i][*pairs[i]];
  }
  return sum;
}

TEST(Assignment, IsAsGoodAsTheBestOfAll) {
  Rng rng{1};
  Assignment assignment{7, 7};
  for (int i = 0; i < 2000; ++i) {
    const std::size_t rows = rng.index(7);
    const std::size_t columns = rng.index(7);
    const Gains gains = drawn(rows, columns, rng.uniform(0, 1), rng);
    std::vector<bool> taken(columns, false);
    ASSERT_NEAR(sum_of(assignment, gains, columns), best_sum(gains, 0, taken), 1e-9)
        << rows << "x" << columns;
  }
}

TEST(Assignment, ADetourOfAllIsFoundWhereGreedWouldFail) {
  Assignment assignment{2, 2};
  assignment.begin(2, 2);
  assignment.offer(0, 0, 10);
  assignment.offer(0, 1, 9);
  assignment.offer(1, 0, 9);
  const auto pairs = assignment.solve();
  EXPECT_EQ(pairs[0], 1U);
  EXPECT_EQ(pairs[1], 0U);
}

TEST(Assignment, WithoutOffersNobodyIsPaired) {
  Assignment assignment{3, 2};
  assignment.begin(3, 2);
  const auto pairs = assignment.solve();
  EXPECT_EQ(pairs.size(), 3U);
  for (const auto& pair : pairs) EXPECT_FALSE(pair);
  assignment.begin(0, 2);
  EXPECT_TRUE(assignment.solve().empty());
}

TEST(Assignment, AllocatesNothingWithinItsSizes) {
  Rng rng{2};
  const Gains gains = drawn(20, 40, 0.3, rng);
  Assignment assignment{20, 40};
  const long before = allocation_count();
  for (int i = 0; i < 10; ++i) {
    assignment.begin(20, 40);
    for (std::size_t row = 0; row < 20; ++row) {
      for (std::size_t column = 0; column < 40; ++column) {
        if (gains[row][column] > 0.0) assignment.offer(row, column, gains[row][column]);
      }
    }
    assignment.solve();
  }
  EXPECT_EQ(allocation_count() - before, 0);
}

}  // namespace
}  // namespace fairway
