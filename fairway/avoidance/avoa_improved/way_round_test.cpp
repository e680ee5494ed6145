// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/way_round.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <queue>
#include <vector>

#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::avoa_improved {
namespace {

const Vec2 origin = Vec2::Zero();
const Vec2 goal{20.0, 0.0};

Capsule disc(double north, double east, double radius) { return {{north, east}, {north, east}, radius}; }

/// Length of the shortest way over a grid of `pitch` with steps to the 32 nearest directions, at least the
/// true one and at most 2.8 % and a bit longer; negative if there is none.
double over_grid(const std::vector<Capsule>& solids, double pitch) {
  constexpr int rows = 131;
  constexpr int columns = 121;
  const auto place = [&](int i, int j) { return Vec2{(i - 15) * pitch, (j - 60) * pitch}; };
  const auto is_free = [&](const Vec2& p, const Vec2& q) {
    return std::ranges::all_of(solids,
                               [&](const Capsule& s) { return distance_to_axis(s, p, q) >= s.radius; });
  };
  std::vector<double> length(rows * columns, 1e9);
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> open;
  open.emplace(length[15 * columns + 60] = 0.0, 15 * columns + 60);
  while (!open.empty()) {
    const auto [cost, at] = open.top();
    open.pop();
    const int i = at / columns;
    const int j = at % columns;
    if (cost > length[static_cast<std::size_t>(at)]) continue;
    if ((place(i, j) - goal).norm() < 1e-9) return cost;
    for (int di = -3; di <= 3; ++di) {
      for (int dj = -3; dj <= 3; ++dj) {
        if (i + di < 0 || i + di >= rows || j + dj < 0 || j + dj >= columns) continue;
        const auto next = static_cast<std::size_t>((i + di) * columns + j + dj);
        const double longer = cost + pitch * std::hypot(di, dj);
        if (longer >= length[next] || !is_free(place(i, j), place(i + di, j + dj))) continue;
        length[next] = longer;
        open.emplace(longer, static_cast<int>(next));
      }
    }
  }
  return -1.0;
}

TEST(AvoaImprovedWayRound, IsStraightWhereNothingIsInTheWay) {
  const std::vector<Capsule> solids{disc(10, 3, 2.9)};
  const auto way = way_round(solids, origin, goal, {});
  ASSERT_TRUE(way);
  EXPECT_TRUE(way->is_straight);
  EXPECT_EQ(way->length, 20.0);
  EXPECT_EQ(way->direction, Vec2(1, 0));
}

TEST(AvoaImprovedWayRound, RoundADiscIsTheTautString) {
  const std::vector<Capsule> solids{disc(10, 0, 2)};
  const auto way = way_round(solids, origin, goal, {});
  ASSERT_TRUE(way);
  const double line = std::sqrt(10.0 * 10.0 - 2.0 * 2.0);
  const double arc = 2.0 * 2.0 * std::asin(2.0 / 10.0);
  EXPECT_NEAR(way->length, 2.0 * line + arc, 1e-9);
  EXPECT_NEAR(std::atan2(way->direction.y(), way->direction.x()), std::asin(0.2), 1e-12);  // to starboard
}

TEST(AvoaImprovedWayRound, RoundAWallTouchesItsEndsOnly) {
  const std::vector<Capsule> solids{{{10, -6}, {10, 3}, 1.0}};
  const auto way = way_round(solids, origin, goal, {});
  ASSERT_TRUE(way);
  const double apart = std::hypot(10.0, 3.0);
  const double bend = 2.0 * (std::asin(1.0 / apart) + std::atan2(3.0, 10.0));
  EXPECT_NEAR(way->length, 2.0 * std::sqrt(apart * apart - 1.0) + bend, 1e-9);
}

TEST(AvoaImprovedWayRound, IsAsLongAsThatOverAFineGrid) {
  int blocked = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    Rng rng = Rng{8}.stream("solids", i);
    std::vector<Capsule> solids;
    while (solids.size() < 14) {
      const Vec2 p{rng.uniform(0, 20), rng.uniform(-5, 5)};
      const Vec2 q = rng.index(2) == 0 ? p : Vec2{p + Vec2{rng.uniform(-2, 2), rng.uniform(-2, 2)}};
      const Capsule solid{p, q, rng.uniform(0.4, 1.4)};
      if (distance_to_axis(solid, origin) > solid.radius && distance_to_axis(solid, goal) > solid.radius)
        solids.push_back(solid);
    }
    const auto way = way_round(solids, origin, goal, {});
    const double grid = over_grid(solids, 0.2);
    SCOPED_TRACE(i);
    if (grid < 0.0) continue;
    ASSERT_TRUE(way);
    blocked += way->is_straight ? 0 : 1;
    EXPECT_LE(way->length, grid + 0.051);  // it may cost 0.05 m to port
    EXPECT_GE(way->length, 0.96 * grid - 0.5);
  }
  EXPECT_GT(blocked, 25);
}

TEST(AvoaImprovedWayRound, ThereIsNoneOutOfARing) {
  std::vector<Capsule> ring;
  for (int k = 0; k < 12; ++k) {
    const double angle = k * pi / 6;
    ring.push_back(disc(4 * std::cos(angle), 4 * std::sin(angle), 1.1));
  }
  EXPECT_FALSE(way_round(ring, origin, goal, {}));
  ring.pop_back();
  ring.pop_back();
  EXPECT_TRUE(way_round(ring, origin, goal, {}));
}

TEST(AvoaImprovedWayRound, WithinASolidItLeadsOnAlongItsSurface) {
  const std::vector<Capsule> solids{disc(1, 0, 1.5)};
  const auto way = way_round(solids, origin, goal, {});
  ASSERT_TRUE(way);
  EXPECT_LT(std::abs(way->direction.x()), 1e-4);
  EXPECT_TRUE(way_round(solids, Vec2(1, 0), goal, {})) << "even from its middle";
}

TEST(AvoaImprovedWayRound, KeepsToTheSideChosenUntilTheOtherIsMuchShorter) {
  const auto heads_to_starboard = [](double middle, double commitment) {
    const std::vector<Capsule> solids{disc(10, middle, 3)};
    const Preference to_port{.committed = Vec2{0.8, -0.6}, .commitment = commitment};
    return way_round(solids, origin, goal, to_port)->direction.y() > 0.0;
  };
  EXPECT_TRUE(heads_to_starboard(-0.5, 0.0));
  EXPECT_FALSE(heads_to_starboard(-0.5, 4.0));  // the way to port is 0.6 m longer
  EXPECT_TRUE(heads_to_starboard(-2.5, 4.0));   // 3 m longer, of which the first lines differ by 0.75 rad
}

TEST(AvoaImprovedWayRound, PrefersAWayWithoutBendsThatIsALittleLonger) {
  const std::vector<Capsule> slalom{disc(6, -1.5, 2), disc(12, 1.5, 2)};
  const auto bends = [&](double bend) {
    const Preference preference{.heading = Vec2{1, 0}, .bend = bend};
    return way_round(slalom, origin, goal, preference)->point_count / 2 - 1;
  };
  EXPECT_EQ(bends(0.0), 2U);
  EXPECT_LE(bends(50.0), 2U);
}

}  // namespace
}  // namespace fairway::avoa_improved
