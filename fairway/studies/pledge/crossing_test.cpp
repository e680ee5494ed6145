// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/pledge/crossing.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "fairway/experiment/measure_run.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::pledges {
namespace {

TEST(PledgeStudy, EveryCellIsNamedOnceAndHasDirectInItsCurrent) {
  const std::vector<Cell> cells = crossing_cells(10);
  std::set<std::string> names;
  for (const Cell& cell : cells) {
    EXPECT_TRUE(names.insert(cell.place + cell.method + cell.mode).second) << cell.place << cell.mode;
    const Cell& straight = straight_cell(cells, cell);
    EXPECT_EQ(straight.method, "direct");
    EXPECT_TRUE(cell.mode.starts_with(straight.mode));
  }
}

TEST(PledgeStudy, WhoeverAvoidsMeetsTheSame) {
  const Condition condition{
      .cycle_s = 8.0, .loss_ratio = 0.1, .current_mps = 0.2, .failure = FailureKind::stops};
  const Scenario first = crossing_scenario(condition, methods()[0], 3);
  for (const Method& method : methods()) {
    const Scenario other = crossing_scenario(condition, method, 3);
    EXPECT_EQ(other.water.current_n, Vec3(0.2, 0, 0));
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_EQ(other.vehicles[i].yaw, first.vehicles[i].yaw);
      EXPECT_EQ(other.vehicles[i].failure, first.vehicles[i].failure);
    }
    EXPECT_NO_THROW((Simulation{other, builtin_catalogs()})) << method.name;
  }
}

TEST(PledgeStudy, RocksStandInTheCubeAndNotWhereACrossingBeginsOrEnds) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Scenario scenario = crossing_scenario({.cycle_s = 3.2, .rock_count = 6}, methods()[0], seed);
    ASSERT_EQ(scenario.obstacles.size(), 6U);
    for (const ObstacleSpec& rock : scenario.obstacles) {
      EXPECT_TRUE(rock.charted);
      for (const VehicleSpec& vehicle : scenario.vehicles)
        for (const Leg& leg : vehicle.mission) {
          if (leg.kind == LegKind::rendezvous) continue;
          EXPECT_GT(nearest_point(rock.view(), leg.position).distance, 3.0);
        }
    }
    const Scenario without = crossing_scenario({.cycle_s = 3.2}, methods()[0], seed);
    EXPECT_EQ(without.vehicles[3].yaw, scenario.vehicles[3].yaw) << "all else is the same";
  }
}

// Each of these had a collision where it stood still, or was taken to know of who had stopped.
TEST(PledgeStudy, WhoStopsBesideAPlanGoesOutOfTheWayOfWhoGoesByIt) {
  const Condition condition{
      .cycle_s = 10.0, .loss_ratio = 0.5, .current_mps = 0.2, .failure = FailureKind::stops};
  for (const auto& [seed, broken] : {std::pair{40002, 0}, {40006, 3}, {50003, 2}, {50004, 3}}) {
    Scenario scenario = crossing_scenario(condition, methods()[0], static_cast<std::uint64_t>(seed));
    FailureSpec failure;
    for (VehicleSpec& vehicle : scenario.vehicles)
      if (vehicle.failure.kind != FailureKind::none) failure = std::exchange(vehicle.failure, {});
    scenario.vehicles[static_cast<std::size_t>(broken)].failure = failure;
    for (const Measure& measure : measure_run(scenario, builtin_catalogs()))
      if (measure.quantity == "pair_collision_count") EXPECT_EQ(measure.value, 0.0) << seed;
  }
}

TEST(PledgeStudy, ACycleIsWhatItsModemMakesOfEightSlots) {
  for (const double cycle : cycles_s) {
    const Scenario scenario = crossing_scenario({.cycle_s = cycle}, methods()[0], 1);
    EXPECT_NEAR(make_exchange(scenario).turn_period(), cycle, 1e-9);
  }
}

}  // namespace
}  // namespace fairway::pledges
