// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace fairway {
namespace {

/// Two vehicles and a frame a second; places of 1.5 m, and 5 m between spheres to whoever matters.
class TwoVehicles {
 public:
  explicit TwoVehicles(Surroundings surroundings = {}) : metric{30.0, std::move(surroundings)} {
    for (VehicleFrame& vehicle : vehicles) {
      vehicle.phase = Phase::under_way;
      vehicle.goal = {1000, 0, 0};
      vehicle.goal_speed = 0.5;
    }
    vehicles[1].state.p_n = {4, 0, 0};
  }

  /// Vehicle 1 moves on so far in each of `frames`.
  void see(int frames, const Vec3& way = Vec3::Zero()) {
    for (; frames > 0; --frames) {
      metric.see({tick_, seconds(tick_, 1.0), 1.0, vehicles});
      vehicles[1].state.p_n += way;
      tick_ = next(tick_);
    }
  }

  Measure measure(const std::string& quantity, int vehicle) const {
    std::vector<Measure> all;
    metric.report(all);
    return *std::ranges::find_if(
        all, [&](const Measure& m) { return m.quantity == quantity && m.vehicle == vehicle; });
  }
  double value(const std::string& quantity, int vehicle) const { return measure(quantity, vehicle).value; }

  ProgressMetric metric;
  std::array<VehicleFrame, 2> vehicles{};

 private:
  Tick tick_{0};
};

TEST(ProgressMetric, AStretchCountsFromItsBeginningOnceItIsLongerThanTheWindow) {
  TwoVehicles run;
  run.see(31);
  EXPECT_EQ(run.value("no_progress_time_s", 0), 0.0);
  run.see(1);
  EXPECT_EQ(run.value("no_progress_time_s", 0), 32.0);
  run.see(68);
  EXPECT_EQ(run.value("no_progress_time_s", 0), 100.0);
  EXPECT_EQ(run.value("deadlock_time_s", 0), 100.0);
  const Occasion occasion = run.measure("deadlock_time_s", 1).occasion;
  EXPECT_EQ(occasion.vehicle, 1);
  EXPECT_EQ(occasion.other, 0);
  EXPECT_EQ(occasion.time, 0.0);
}

TEST(ProgressMetric, ADeadlockEndsWithWhoeverLeavesItAndCountsEachSecondOnce) {
  TwoVehicles run;
  run.see(60);
  run.see(40,
          {0, 0.5, 0});  // vehicle 1 goes; its place is set anew at 62 s, and a step from there it is at 66
  EXPECT_EQ(run.value("no_progress_time_s", 1), 66.0);
  EXPECT_EQ(run.value("deadlock_time_s", 1), 66.0);
  EXPECT_EQ(run.metric.state(1).state, Headway::making);
  EXPECT_EQ(run.metric.state(0).state, Headway::trapped);
  EXPECT_EQ(run.value("no_progress_time_s", 0), 100.0);
  EXPECT_EQ(run.value("deadlock_time_s", 0), 66.0);
}

TEST(ProgressMetric, WhoHasArrivedNeitherClearsTheWayNorMissesProgress) {
  TwoVehicles run;
  run.vehicles[1].phase = Phase::arrived;
  run.see(100);
  EXPECT_EQ(run.metric.state(0).state, Headway::trapped);
  EXPECT_EQ(run.metric.state(1).state, Headway::holding);
  EXPECT_EQ(run.value("no_progress_time_s", 1), 0.0);
}

TEST(ProgressMetric, WaitsForADrifterWithinReachOfTheSpheres) {
  Surroundings surroundings{
      .obstacles = {{{.position = {0, -50, 0}, .radius = 2}, {0, 0.5, 0}}}, .radii = {1, 1}, .limits = {}};
  TwoVehicles run{surroundings};
  run.vehicles[1].state.p_n = {500, 0, 0};
  run.see(100);  // the drifter is 0.5 m short of it
  EXPECT_EQ(run.metric.state(0).state, Headway::waiting);
  EXPECT_EQ(run.metric.occasion(0).obstacle, 0);
  EXPECT_EQ(text_of(run.metric.state(0), "obstacles[0]"), "no progress since 0 s: waiting for obstacles[0]");
  EXPECT_EQ(text_of(run.metric.state(1), ""),
            "no progress since 0 s: trapped, and nobody is near who could clear the way");
  run.see(30);
  EXPECT_EQ(run.metric.state(0).state, Headway::trapped);
}

TEST(ProgressMetric, TheLimitOnSpeedIsTheCruisingSpeedWhereItIsLower) {
  Surroundings slow{
      .obstacles = {}, .radii = {}, .limits = {Limits{.max_speed = 0.1}, Limits{.max_speed = 0.1}}};
  TwoVehicles run{slow};
  run.see(200, {0.04, 0, 0});  // less than a tenth of 0.5 m/s, more than one of 0.1 m/s
  EXPECT_EQ(run.value("no_progress_time_s", 1), 0.0);
}

}  // namespace
}  // namespace fairway
