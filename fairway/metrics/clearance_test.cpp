// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "fairway/core/rng.hpp"
#include "fairway/core/testing/random_obstacles.hpp"
#include "fairway/metrics/run_metrics.hpp"

namespace fairway {
namespace {

/// The least clearance of a vehicle, by going through all obstacles: of those that are equally near the first
/// one, at the first instant.
struct LeastClearance {
  double value = std::numeric_limits<double>::infinity();
  int obstacle = Occasion::none;
  double time = 0.0;

  void see(const std::vector<DriftingObstacle>& obstacles, const Vec3& place, double now) {
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      const double clearance = nearest_point(obstacles[k].at(now), place).distance;
      if (clearance < value) *this = {clearance, static_cast<int>(k), now};
    }
  }
};

TEST(FleetMetric, AmongManyObstaclesClearancesAreThoseOfGoingThroughAll) {
  for (const std::size_t count : {5U, 60U, 800U}) {
    RandomObstacles scene{count, 400.0, Rng{count}};
    std::vector<DriftingObstacle> obstacles;
    for (const Obstacle& each : scene.all) {
      const bool drifts = each.kind == Obstacle::Kind::sphere && obstacles.size() % 4 == 0;
      obstacles.push_back({each, drifts ? Vec3{1.0, -0.5, 0.0} : Vec3{Vec3::Zero()}});
    }
    RunMetrics metrics{{6, 3}, {.obstacles = obstacles}};
    std::array<VehicleFrame, 20> vehicles{};
    std::array<LeastClearance, 20> least{};
    Rng rng{9};
    for (VehicleFrame& vehicle : vehicles) {
      vehicle.phase = Phase::under_way;
      vehicle.state.p_n = RandomObstacles::place(500.0, rng);
    }
    for (int tick = 0; tick < 60; ++tick) {
      metrics.write({Tick{tick}, 1.0 * tick, 1.0, vehicles});
      for (std::size_t i = 0; i < vehicles.size(); ++i) {
        least[i].see(obstacles, vehicles[i].state.p_n, 1.0 * tick);
        if (tick % 3 != 0) vehicles[i].state.p_n += RandomObstacles::place(20.0, rng);
      }
    }
    for (const Measure& m : metrics.measures()) {
      if (m.quantity != "obstacle_clearance_m") continue;
      const LeastClearance& expected = least[static_cast<std::size_t>(m.vehicle)];
      EXPECT_EQ(m.value, expected.value) << m.vehicle << " of " << count;
      EXPECT_EQ(m.occasion.obstacle, expected.obstacle) << m.vehicle << " of " << count;
      EXPECT_EQ(m.occasion.time, expected.time) << m.vehicle << " of " << count;
    }
  }
}

}  // namespace
}  // namespace fairway
