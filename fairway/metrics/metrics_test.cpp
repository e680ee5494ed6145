// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fairway/metrics/run_metrics.hpp"

namespace fairway {
namespace {

/// Plays positions of vehicles on a line, one frame a second.
class Script {
 public:
  explicit Script(EncounterRules rules = {6.0, 3.0}) : metrics_{rules} {}

  /// Vehicle 0 at the origin, vehicle 1 at `x`.
  Script& pair(double x, Phase first = Phase::under_way, Phase second = Phase::under_way) {
    std::array<VehicleFrame, 2> vehicles{};
    vehicles[0].id = VehicleId{0};
    vehicles[1].id = VehicleId{1};
    vehicles[0].phase = first;
    vehicles[1].phase = second;
    vehicles[1].state.p_n = {x, 0, 0};
    vehicles[0].goal = {100, 0, 0};
    vehicles[0].power = 10;
    metrics_.write({tick_, seconds(tick_, 1.0), 1.0, vehicles});
    tick_ = next(tick_);
    return *this;
  }

  double value(const std::string& quantity, int vehicle = Measure::fleet) const {
    return measure(quantity, vehicle).value;
  }

  Measure measure(const std::string& quantity, int vehicle = Measure::fleet) const {
    for (const Measure& m : metrics_.measures()) {
      if (m.quantity == quantity && m.vehicle == vehicle) return m;
    }
    ADD_FAILURE() << "no " << quantity;
    return {.quantity = quantity, .value = std::nan("")};
  }

 private:
  RunMetrics metrics_;
  Tick tick_{0};
};

TEST(FleetMetric, CommandsBeyondAVehicleCountForAsLongAsItIsUnderWayByThem) {
  Surroundings surroundings;
  surroundings.limits = {Limits{.min_speed = 1.0, .sternway = false, .sway = false}, {}};
  RunMetrics metrics{{6.0, 3.0}, surroundings};
  std::array<VehicleFrame, 2> vehicles{};
  std::int64_t tick = 0;
  const auto see = [&](const Vec3& velocity, Phase phase) {
    for (VehicleFrame& vehicle : vehicles) {
      vehicle.phase = phase;
      vehicle.command.velocity = velocity;
    }
    metrics.write({Tick{tick}, 0.5 * static_cast<double>(tick), 0.5, vehicles});
    ++tick;
  };
  see({-1.5, 0, 0}, Phase::waiting);    // nobody avoids yet
  see({1.5, 0, 0}, Phase::under_way);   // as it can
  see({-1.5, 0, 0}, Phase::under_way);  // astern
  see({0.5, 0, 0}, Phase::under_way);   // too slow
  see({0, 0, 0}, Phase::arrived);

  std::vector<double> seconds;
  for (const Measure& m : metrics.measures()) {
    if (m.quantity == "unattainable_time_s") seconds.push_back(m.value);
  }
  EXPECT_EQ(seconds, (std::vector<double>{1.0, 0.0}));
}

TEST(EncounterMetric, AnEncounterCountsOnceAsTheNeighbourLeavesForEachOfTheTwo) {
  Script s;
  s.pair(10).pair(5).pair(4).pair(5).pair(7);
  EXPECT_EQ(s.value("avoided_count", 0), 1);
  EXPECT_EQ(s.value("avoided_count", 1), 1);
  EXPECT_EQ(s.value("collision_count", 0), 0);
  EXPECT_EQ(s.value("avoidance_time_s", 0), 3);
}

TEST(EncounterMetric, TheWorstStateOfAnEncounterIsWhatCounts) {
  Script s;
  s.pair(10).pair(5).pair(2.9).pair(5).pair(7).pair(2).pair(7);
  EXPECT_EQ(s.value("collision_count", 0), 2);
  EXPECT_EQ(s.value("avoided_count", 0), 0);
  EXPECT_EQ(s.value("pair_collision_count"), 2);
}

TEST(EncounterMetric, ALimitItselfCountsAsReached) {
  Script s;
  s.pair(6.0).pair(6.001).pair(3.0).pair(9);
  EXPECT_EQ(s.value("avoided_count", 0), 1);
  EXPECT_EQ(s.value("collision_count", 0), 1);
}

TEST(EncounterMetric, AnEncounterStillOpenOnArrivalCounts) {
  Script s;
  s.pair(10).pair(5).pair(5, Phase::arrived);
  EXPECT_EQ(s.value("avoided_count", 0), 1);
  EXPECT_EQ(s.value("navigation_time_s", 0), 2);
  s.pair(2, Phase::arrived);  // after arrival nothing counts any more for the one that arrived
  EXPECT_EQ(s.value("collision_count", 0), 0);
}

TEST(EncounterMetric, ShowsItsOpenEncountersUntilTheyAreCounted) {
  using Contact = EncounterMetric::Contact;
  EncounterMetric metric{{6.0, 3.0}};
  Tick tick{0};
  const auto worst = [&](double x, Phase phase) {
    std::array<VehicleFrame, 2> vehicles{};
    vehicles[0].phase = phase;
    vehicles[1].state.p_n = {x, 0, 0};
    metric.see({tick, seconds(tick, 1.0), 1.0, vehicles});
    tick = next(tick);
    return metric.contacts(0).empty() ? Contact::none : metric.contacts(0)[0].worst;
  };
  EXPECT_EQ(worst(5, Phase::waiting), Contact::none);
  EXPECT_EQ(worst(5, Phase::under_way), Contact::near);
  EXPECT_EQ(worst(2, Phase::under_way), Contact::collided);
  EXPECT_EQ(worst(5, Phase::under_way), Contact::collided) << "latched";
  EXPECT_EQ(worst(7, Phase::under_way), Contact::none);
  EXPECT_EQ(worst(5, Phase::under_way), Contact::near);
  EXPECT_EQ(worst(5, Phase::arrived), Contact::none);
}

TEST(EncounterMetric, AStuckVehicleIsCountedUpToThenAndItsOpenEncountersAreNot) {
  Script s;
  s.pair(10).pair(5).pair(5, Phase::stuck).pair(9, Phase::stuck);
  EXPECT_EQ(s.value("stuck_count", 0), 1);
  EXPECT_EQ(s.value("navigation_time_s", 0), 2);
  EXPECT_EQ(s.value("avoided_count", 0), 0);
}

TEST(EncounterMetric, DeploymentDoesNotCount) {
  Script s;
  s.pair(1, Phase::deploying, Phase::deploying).pair(1, Phase::waiting, Phase::deploying).pair(20).pair(20);
  EXPECT_EQ(s.value("collision_count", 0), 0);
  EXPECT_EQ(s.value("navigation_time_s", 0), 2);
  EXPECT_EQ(s.value("min_separation_m"), 20);
  EXPECT_EQ(s.value("start_distance_m", 0), 100);
}

TEST(EncounterMetric, DistanceIsThePathLength) {
  Script s;
  s.pair(20).pair(22).pair(21).pair(21);
  EXPECT_NEAR(s.value("distance_m", 1), 3.0, 1e-12);
}

TEST(FleetMetric, EnergyIsPowerOverTimeUnderWay) {
  Script s;
  s.pair(20, Phase::waiting).pair(20).pair(20).pair(20, Phase::arrived);
  EXPECT_NEAR(s.value("energy_j", 0), 20.0, 1e-12);
}

TEST(FleetMetric, WhomAMoverMeetsCountsBeforeItHasSetOutItself) {
  for (const bool mover_is_first : {true, false}) {
    const auto pair = [&](Script& s, double x, Phase mover, Phase other) {
      s.pair(x, mover_is_first ? mover : other, mover_is_first ? other : mover);
    };
    const int mover = mover_is_first ? 0 : 1;
    for (const Phase other : {Phase::waiting, Phase::deploying}) {
      Script s;
      pair(s, 1, other, other);  // nobody has set out
      pair(s, 5, Phase::under_way, other);
      pair(s, 2, Phase::under_way, other);
      pair(s, 2.5, Phase::under_way, Phase::under_way);  // the same collision
      pair(s, 4, Phase::under_way, Phase::under_way);
      EXPECT_EQ(s.value("pair_collision_count"), 1);
      EXPECT_EQ(s.value("min_separation_m"), 2);
      EXPECT_EQ(s.measure("min_separation_m").occasion.time, 2);
      EXPECT_EQ(s.value("nearest_m", mover), 2);
      EXPECT_EQ(s.value("nearest_m", 1 - mover), 2.5);
      EXPECT_EQ(s.measure("pair_collision_count").occasion.vehicle, 0);
      EXPECT_EQ(s.measure("pair_collision_count").occasion.other, 1);
    }
  }
}

TEST(FleetMetric, WhoeverIsThereFromTheBeginningCounts) {
  const Script s = Script{}.pair(2, Phase::arrived, Phase::arrived).pair(2, Phase::arrived, Phase::arrived);
  EXPECT_EQ(s.value("pair_collision_count"), 1);
  EXPECT_EQ(s.value("min_separation_m"), 2);
  EXPECT_EQ(s.value("arrived_ratio"), 1);
  EXPECT_EQ(s.value("makespan_s"), 0);
}

TEST(FleetMetric, MakespanEndsWithTheLastArrival) {
  Script s;
  s.pair(20).pair(20, Phase::arrived).pair(20, Phase::arrived).pair(20, Phase::arrived, Phase::arrived);
  s.pair(20, Phase::arrived, Phase::arrived);
  EXPECT_EQ(s.value("makespan_s"), 3);
  EXPECT_EQ(s.value("arrived_ratio"), 1.0);
}

/// The first of the measures of `quantity`.
Measure measure_of(const RunMetrics& metrics, std::string_view quantity) {
  for (const Measure& m : metrics.measures()) {
    if (m.quantity == quantity) return m;
  }
  return {.quantity = "none", .value = std::nan("")};
}

double measured(const RunMetrics& metrics, std::string_view quantity) {
  return measure_of(metrics, quantity).value;
}

TEST(FleetMetric, ClearanceIsNegativeInsideAnObstacle) {
  const Obstacle ball{.kind = Obstacle::Kind::sphere, .position = {4, 0, 0}, .radius = 3};
  RunMetrics metrics{{6, 3}, {.obstacles = {{.start = ball}}, .radii = {0.5}}};
  std::array<VehicleFrame, 1> vehicles{};
  vehicles[0].phase = Phase::under_way;
  for (const double x : {-4.0, 0.0, 2.0}) {
    vehicles[0].state.p_n = {x, 0, 0};
    metrics.write({Tick{0}, 0.0, 1.0, vehicles});
  }
  EXPECT_NEAR(measured(metrics, "obstacle_clearance_m"), -1.0, 1e-12);
  EXPECT_NEAR(measured(metrics, "footprint_clearance_m"), -1.5, 1e-12);
}

TEST(Metrics, EveryQuantityIsDescribedAndNothingElseIsReported) {
  RunMetrics metrics{{6, 3}};
  std::array<VehicleFrame, 1> one{};
  metrics.write({Tick{0}, 0.0, 1.0, one});
  const auto quantities = all_quantities();
  for (const Measure& m : metrics.measures()) {
    const bool known = std::ranges::any_of(quantities, [&](const QuantityInfo& q) {
      return q.name == m.quantity && q.per_vehicle == (m.vehicle != Measure::fleet);
    });
    EXPECT_TRUE(known) << m.quantity;
  }
  // of one vehicle there is one measure of each
  EXPECT_EQ(metrics.measures().size(), quantities.size());
}

TEST(FleetMetric, ClearanceFollowsAnObstacleThatDrifts) {
  const Obstacle ball{.kind = Obstacle::Kind::sphere, .position = {10, 0, 0}, .radius = 1};
  RunMetrics metrics{{6, 3}, {.obstacles = {{ball, {-1, 0, 0}}}, .radii = {2.0}}};
  std::array<VehicleFrame, 1> vehicles{};
  vehicles[0].phase = Phase::under_way;
  for (int i = 0; i < 5; ++i) metrics.write({Tick{i}, 1.0 * i, 1.0, vehicles});
  EXPECT_NEAR(measured(metrics, "obstacle_clearance_m"), 5.0, 1e-12);   // 10 - 4 - 1
  EXPECT_NEAR(measured(metrics, "footprint_clearance_m"), 3.0, 1e-12);  // 2 m less
}

TEST(EffortMetric, PowersAreForceTimesVelocityAlongEachAxis) {
  RunMetrics metrics{{6, 3}};
  std::array<VehicleFrame, 1> vehicles{};
  vehicles[0].phase = Phase::under_way;
  vehicles[0].power = 7.0;
  const auto see = [&](int tick, double surge, double force, double yaw_rate, double moment) {
    vehicles[0].state.p_n.x() += surge;
    vehicles[0].state.v_b.x() = surge;
    vehicles[0].state.omega_b.z() = yaw_rate;
    vehicles[0].wrench << force, 0, 0, 0, 0, moment;
    metrics.write({Tick{tick}, 1.0 * tick, 1.0, vehicles});
  };
  see(0, 2.0, 3.0, 0.0, 0.0);   // drives with 6 W
  see(1, 2.0, -4.0, 0.5, 8.0);  // brakes with 8 W, turns with 4 W
  EXPECT_NEAR(measured(metrics, "rms_surge_power_w"), std::sqrt((36.0 + 64.0) / 2), 1e-12);
  EXPECT_NEAR(measured(metrics, "mean_surge_power_w"), 7.0, 1e-12);
  EXPECT_NEAR(measured(metrics, "rms_yaw_power_w"), std::sqrt(16.0 / 2), 1e-12);
  EXPECT_NEAR(measured(metrics, "body_energy_j"), 6.0 + 8.0 + 4.0, 1e-12);
  EXPECT_NEAR(measured(metrics, "mean_thruster_power_w"), 7.0, 1e-12);
  EXPECT_NEAR(measured(metrics, "path_length_m"), 2.0, 1e-12);
  EXPECT_NEAR(measured(metrics, "displacement_m"), 2.0, 1e-12);
}

TEST(SmoothnessMetric, TurnsAndChangesOfSpeedAddUpWhileUnderWay) {
  RunMetrics metrics{{6.0, 3.0}};
  const auto see = [&](int tick, double yaw, double surge, Phase phase) {
    std::array<VehicleFrame, 1> vehicles{};
    vehicles[0].phase = phase;
    vehicles[0].state.q_nb = quaternion_of({.yaw = yaw});
    vehicles[0].state.v_b.x() = surge;
    metrics.write({Tick{tick}, seconds(Tick{tick}, 1.0), 1.0, vehicles});
  };
  see(0, 2.0, 0.5, Phase::deploying);  // does not count
  see(1, 3.0, 1.0, Phase::under_way);
  see(2, -3.0, 1.5, Phase::under_way);  // through south: 0.283 rad
  see(3, 3.0, 0.75, Phase::under_way);
  see(4, 0.0, 0.0, Phase::arrived);  // nor does this
  EXPECT_NEAR(measured(metrics, "heading_change_rad"), 2 * (2 * pi - 6.0), 1e-12);
  EXPECT_NEAR(measured(metrics, "speed_change_mps"), 1.25, 1e-12);
}

// ---- who, with whom and when

TEST(Occasion, OfACollisionIsItsFirstInstantWithWhomItWas) {
  RunMetrics metrics{{6, 3}};
  const auto see = [&](int tick, double first, double second) {
    std::array<VehicleFrame, 3> vehicles{};
    for (VehicleFrame& vehicle : vehicles) vehicle.phase = Phase::under_way;
    vehicles[1].state.p_n = {first, 0, 0};
    vehicles[2].state.p_n = {0, second, 0};
    metrics.write({Tick{tick}, 1.0 * tick, 1.0, vehicles});
  };
  see(0, 20, 20);
  see(1, 20, 2.5);  // the first: with 2
  see(2, 1, 2);     // then with 1 too, nearer
  see(3, 20, 20);
  const Measure own = measure_of(metrics, "collision_count");
  EXPECT_EQ(own.value, 2.0);
  EXPECT_EQ(own.occasion.other, 2);
  EXPECT_EQ(own.occasion.time, 1.0);
  const Measure pair = measure_of(metrics, "pair_collision_count");
  EXPECT_EQ(pair.occasion.vehicle, 0);
  EXPECT_EQ(pair.occasion.other, 2);
  EXPECT_EQ(pair.occasion.time, 1.0);
  const Measure least = measure_of(metrics, "min_separation_m");
  EXPECT_EQ(least.value, 1.0);
  EXPECT_EQ(least.occasion.vehicle, 0);
  EXPECT_EQ(least.occasion.other, 1);
  EXPECT_EQ(least.occasion.time, 2.0);
  EXPECT_EQ(measure_of(metrics, "nearest_m").occasion.other, 1);
}

TEST(Occasion, OfWhatDidNotHappenIsNone) {
  Script s;
  s.pair(20);
  const Measure none = s.measure("collision_count", 0);
  EXPECT_EQ(none.occasion.other, Occasion::none);
  EXPECT_TRUE(std::isnan(none.occasion.time));
  EXPECT_TRUE(std::isnan(s.measure("pair_collision_count").occasion.time));
}

TEST(Occasion, OfAClearanceIsTheObstacleAndTheInstantOfTheLeast) {
  const auto ball = [](double x) {
    return DriftingObstacle{.start = {.kind = Obstacle::Kind::sphere, .position = {x, 0, 0}, .radius = 1}};
  };
  RunMetrics metrics{{6, 3}, {.obstacles = {ball(-50), ball(10)}, .radii = {1.0}}};
  std::array<VehicleFrame, 1> vehicles{};
  vehicles[0].phase = Phase::under_way;
  for (const int tick : {0, 1, 2, 3}) {
    vehicles[0].state.p_n = {tick == 2 ? 8.0 : 0.0, 0, 0};
    vehicles[0].command.mode = tick > 0 ? Mode::infeasible : Mode::cruise;
    metrics.write({Tick{tick}, 1.0 * tick, 1.0, vehicles});
  }
  for (const char* quantity : {"obstacle_clearance_m", "footprint_clearance_m"}) {
    EXPECT_EQ(measure_of(metrics, quantity).occasion.obstacle, 1) << quantity;
    EXPECT_EQ(measure_of(metrics, quantity).occasion.time, 2.0) << quantity;
  }
  EXPECT_EQ(measure_of(metrics, "infeasible_count").occasion.time, 1.0);
}

TEST(Occasion, OfArrivalsIsTheFirstWhoDidNotArrive) {
  Script s;
  s.pair(20).pair(20, Phase::arrived);
  EXPECT_EQ(s.measure("arrived_ratio").occasion.vehicle, 1);
  EXPECT_EQ(s.measure("makespan_s").occasion.vehicle, 1);
  s.pair(20, Phase::arrived, Phase::arrived);
  EXPECT_EQ(s.measure("arrived_ratio").occasion.vehicle, Occasion::none);
}

}  // namespace
}  // namespace fairway
