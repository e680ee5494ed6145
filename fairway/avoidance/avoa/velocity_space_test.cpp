// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/velocity_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "fairway/avoidance/avoa/testing/random_spaces.hpp"

namespace fairway::avoa {
namespace {

TEST(VelocitySpace, FeasibleIsWhatNoZoneHasAndIsFastEnough) {
  VelocitySpace space;
  for (std::uint64_t scene = 0; scene < 20; ++scene) {
    fill(space, 8, Rng{6}.stream("space", scene));
    std::vector<std::int32_t> expected;
    for (int cell = 0; cell < space.grid().cell_count(); ++cell) {
      const PolarVelocity v = PolarVelocity::of(space.grid().velocity(cell));
      const bool free = space.zones().forbidden()[static_cast<std::size_t>(cell)] == 0;
      if (free && v.speed >= 0.2 && !zarco.contains(v)) expected.push_back(cell);
      EXPECT_EQ(space.is_feasible(cell), !expected.empty() && expected.back() == cell);
    }
    EXPECT_TRUE(std::ranges::equal(space.feasible(), expected));
  }
}

TEST(VelocitySpace, DangerIsOfTheDistanceToTheObstaclesZonesAlone) {
  VelocitySpace space;
  fill(space, 3, Rng{7});
  const VelocityGrid& grid = space.grid();
  int in_danger = 0;
  for (int cell = 0; cell < grid.cell_count(); cell += 13) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int other = 0; other < grid.cell_count(); ++other) {
      if (space.zones().forbidden()[static_cast<std::size_t>(other)] == 0) continue;
      nearest = std::min(nearest, (grid.velocity(cell) - grid.velocity(other)).norm());
    }
    EXPECT_NEAR(space.danger(cell), std::max(0.0, 1.0 - nearest / 0.3), 1e-12);
    in_danger += space.danger(cell) > 0.0 && space.danger(cell) < 1.0 ? 1 : 0;
  }
  EXPECT_GT(in_danger, 50);

  space.begin({101, 1.5}, zarco, 0.2);
  space.finish(0.3);
  for (int cell = 0; cell < grid.cell_count(); ++cell) EXPECT_EQ(space.danger(cell), 0.0);
}

TEST(VelocitySpace, FollowsWhatOwnShipCanDo) {
  VelocitySpace space;
  const auto feasible = [&](int side, const KinematicZone& kinematics, double least_speed) {
    space.begin({side, 1.5}, kinematics, least_speed);
    space.finish(0.3);
    return space.feasible().size();
  };
  const std::size_t usual = feasible(101, zarco, 0.2);
  EXPECT_GT(feasible(101, zarco, 0.0), usual);
  KinematicZone strong = zarco;
  strong.thruster_speed = 3.0;
  EXPECT_GT(feasible(101, strong, 0.2), usual);
  EXPECT_LT(feasible(51, zarco, 0.2), usual);
  EXPECT_EQ(feasible(101, zarco, 0.2), usual);
  EXPECT_EQ(feasible(2, zarco, 0.2), 0U);  // its four corners are faster than 1.5 m/s
}

TEST(CheapestCell, IsTheFirstOfTheBest) {
  VelocitySpace space;
  fill(space, 6, Rng{8});
  const VelocityMetric metric{{1.0, 0.5}, 1.5, 0.4, 0.2, 0.4};
  const Candidate nobody{.cost = std::numeric_limits<double>::infinity()};
  const Candidate best = cheapest_cell(space, metric, nobody);
  ASSERT_FALSE(space.feasible().empty());
  bool found = false;
  for (const std::int32_t cell : space.feasible()) {
    const double cost = metric(space.velocity(cell), space.danger(cell));
    EXPECT_GE(cost, best.cost);
    if (cost == best.cost) {
      EXPECT_EQ(best.velocity.heading, space.velocity(cell).heading);
      found = true;
      break;
    }
  }
  EXPECT_TRUE(found);

  const Candidate as_good{{1.0, 0.5}, best.cost};
  EXPECT_EQ(cheapest_cell(space, metric, as_good).velocity.heading, 0.5);
}

TEST(CheapestCell, IsWhatItBeganWithWhereNothingIsFeasible) {
  VelocitySpace space;
  space.begin({101, 1.5}, zarco, 2.0);
  space.finish(0.3);
  const Candidate nobody{.cost = std::numeric_limits<double>::infinity()};
  const VelocityMetric metric{{1.0, 0.5}, 1.5, 0.4, 0.2, 0.4};
  EXPECT_EQ(cheapest_cell(space, metric, nobody).cost, nobody.cost);
}

}  // namespace
}  // namespace fairway::avoa
