// SPDX-License-Identifier: Apache-2.0
// A REMUS 100 under way by itself: steering, fin autopilot and model in one loop.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "fairway/core/angles.hpp"
#include "fairway/core/testing/allocations.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

/// Calls a function with the only vehicle of every frame and its time.
class RemusWatch : public FrameSink {
 public:
  explicit RemusWatch(std::function<void(const VehicleFrame&, double)> see) : see_{std::move(see)} {}
  void write(const Frame& frame) override { see_(frame.vehicles[0], frame.time); }

 private:
  std::function<void(const VehicleFrame&, double)> see_;
};

Scenario one_remus(const std::string& mission, const std::string& rest = "") {
  return parse_scenario(
      "fairway: 1\nname: remus\nduration_s: 600\nvehicles:\n"
      "  - model: remus100\n    avoider: direct\n"
      "    limits: {max_speed_mps: 1.5}\n"
      "    start: {position_m: [0, 0, 20], speed_mps: 1.5}\n"
      "    mission: [" +
          mission + "]\n" + rest,
      "remus");
}

void watch(const Scenario& scenario, std::function<void(const VehicleFrame&, double)> see) {
  RemusWatch sink{std::move(see)};
  const std::array<FrameSink*, 1> sinks{&sink};
  Simulation{scenario, builtin_catalogs()}.run(sinks);
}

/// The worst of a run to the north, from 60 s on.
struct Keeping {
  double course{};  ///< over ground, off the commanded one [rad]
  double abeam{};   ///< [m]
  double depth{};   ///< off 20 m [m]
  double speed{};   ///< over ground, off 1.5 m/s [m/s]
};

Keeping kept_course(const std::string& water) {
  Keeping worst;
  watch(one_remus("transit: {position_m: [5000, 0, 20], speed_mps: 1.5}", water),
        [&](const VehicleFrame& v, double time) {
          if (time < 60.0) return;
          const Vec3 over_ground = v.state.v_n();
          const Vec3& wanted = v.command.velocity;
          const double off =
              wrap_angle(std::atan2(over_ground.y(), over_ground.x()) - std::atan2(wanted.y(), wanted.x()));
          worst.course = std::fmax(worst.course, std::abs(off));
          worst.abeam = std::fmax(worst.abeam, std::abs(v.state.p_n.y()));
          worst.depth = std::fmax(worst.depth, std::abs(v.state.p_n.z() - 20.0));
          worst.speed = std::fmax(worst.speed, std::abs(horizontal_norm(over_ground) - 1.5));
        });
  return worst;
}

TEST(RemusUnderWay, HoldsCourseAndDepthInCalmWaterAndInACrossCurrent) {
  for (const char* water :
       {"", "water: {current_mps: [0, 0.2, 0]}\n", "water: {current_mps: [-0.1, -0.2, 0]}\n"}) {
    SCOPED_TRACE(water);
    const Keeping worst = kept_course(water);
    EXPECT_LT(worst.course, radians(1.0));  // measured 0.034 degrees
    EXPECT_LT(worst.abeam, 2.0);            // 0.8: what it had lost while it turned into the current
    EXPECT_LT(worst.depth, 0.2);            // 0.008
    EXPECT_LT(worst.speed, 0.02);
  }
}

TEST(RemusUnderWay, TurnsRoundOnItsCircleAndHeadsBack) {
  double widest = 0.0, last_course = 0.0, fastest = 0.0, deepest = 0.0;
  watch(one_remus("transit: {position_m: [-400, 0, 20], speed_mps: 1.5, arrival_m: 10}"),
        [&](const VehicleFrame& v, double time) {
          widest = std::fmax(widest, std::abs(v.state.p_n.y()));
          fastest = std::fmax(fastest, std::abs(v.state.omega_b.z()));
          deepest = std::fmax(deepest, std::abs(v.state.p_n.z() - 20.0));
          if (time < 120.0) last_course = yaw_of(v.state.q_nb);
        });
  EXPECT_NEAR(std::abs(last_course), pi, 0.1);
  EXPECT_LT(fastest, 0.16);  // the rudder hard over gives 0.145 at this speed
  EXPECT_GT(widest, 2 * 10.0);
  EXPECT_LT(widest, 40.0);  // measured 25
  EXPECT_LT(deepest, 0.2);  // measured 0.06
}

TEST(RemusUnderWay, DivesToTheDepthOfItsGoal) {
  double depth = 0.0, steepest = 0.0;
  watch(one_remus("transit: {position_m: [400, 0, 60], speed_mps: 1.5, arrival_m: 2}"),
        [&](const VehicleFrame& v, double) {
          if (v.phase == Phase::under_way) depth = v.state.p_n.z();
          steepest = std::fmin(steepest, euler_of(v.state.q_nb).pitch);
        });
  EXPECT_NEAR(depth, 60.0, 2.0);
  EXPECT_GT(steepest, -0.2);  // atan(40 / 400) is 0.1
}

TEST(RemusUnderWay, CirclesWhereItIsToHoldSinceItCannotStop) {
  Scenario scenario = one_remus("keep_position: {duration_s: 500}");
  double farthest = 0.0, slowest = 1e9, depth = 0.0, turned = 0.0, before = 0.0;
  watch(scenario, [&](const VehicleFrame& v, double time) {
    const double yaw = yaw_of(v.state.q_nb);
    if (time > 200.0) {
      farthest = std::fmax(farthest, horizontal_norm(v.state.p_n));
      slowest = std::fmin(slowest, v.state.v_b.x());
      depth = std::fmax(depth, std::abs(v.state.p_n.z() - 20.0));
      turned += wrap_angle(yaw - before);
    }
    before = yaw;
  });
  EXPECT_LT(farthest, 32.0);  // measured 28, of a circle of 25 m
  EXPECT_GT(slowest, 0.9);
  EXPECT_LT(depth, 0.05);
  EXPECT_GT(turned, 2 * pi);
}

TEST(RemusUnderWay, StepsWithoutAllocating) {
  const Scenario scenario = one_remus("transit: {position_m: [5000, 0, 30], speed_mps: 1.5}");
  Simulation simulation{scenario, builtin_catalogs()};
  for (int i = 0; i < 10; ++i) simulation.step({});
  const long before = allocation_count();
  for (int i = 0; i < 200; ++i) simulation.step({});
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace fairway
