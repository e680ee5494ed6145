// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/divergence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "fairway/sim/simulation.hpp"
#include "fairway/sim/testing/runaway.hpp"

namespace fairway {
namespace {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

struct LastFrame final : FrameSink {
  void write(const Frame& frame) override {
    ++count;
    time = frame.time;
    speed = frame.vehicles.back().state.v_b.x();
  }
  int count{};
  double time{};
  double speed{};
};

TEST(Divergence, ARunEndsAtTheTickAtWhichAVehicleLeavesWhatIsPossible) {
  Simulation simulation{breaking_scenario(), catalogs_with_runaway()};
  LastFrame last;
  const std::array<FrameSink*, 1> sinks{&last};
  while (!simulation.is_done()) simulation.step(sinks);

  // exp(t) is beyond 200 from t = 5.298 s on, and so at the tick at 5.3 s; the frame before is the last
  ASSERT_TRUE(simulation.divergence());
  EXPECT_EQ(simulation.divergence()->vehicle, 1U);
  EXPECT_EQ(simulation.divergence()->tick, Tick{106});
  EXPECT_DOUBLE_EQ(simulation.divergence()->time, 5.3);
  EXPECT_EQ(simulation.divergence()->why, "its speed is beyond 200 m/s");
  EXPECT_EQ(last.count, 106);
  EXPECT_DOUBLE_EQ(last.time, 5.25);
  EXPECT_LT(last.speed, 200.0);

  // nothing more happens
  simulation.step(sinks);
  EXPECT_EQ(last.count, 106);
  EXPECT_EQ(simulation.tick(), Tick{106});
}

TEST(Divergence, WhoeverRunsToTheEndIsToldInOneLine) {
  Simulation simulation{breaking_scenario(), catalogs_with_runaway()};
  try {
    simulation.run({});
    FAIL() << "the run was taken as whole";
  } catch (const RunDiverged& error) {
    EXPECT_STREQ(error.what(), "diverged: broken at 5.3 s: its speed is beyond 200 m/s");
  }
}

TEST(Divergence, WhatOverflowsInOneStepIsNoticedAtOnce) {
  // growth by R(1e4 h) = (500^4 / 24 + ...) = 2.6e9 a step, from 1 m/s
  Simulation simulation{breaking_scenario(1e4), catalogs_with_runaway()};
  EXPECT_THROW(simulation.run({}), RunDiverged);
  EXPECT_EQ(simulation.divergence()->tick, Tick{1});
}

TEST(Divergence, ACommandThatIsNotFiniteIsNeitherCarriedOutNorRecorded) {
  Scenario scenario = breaking_scenario();
  scenario.vehicles[1].model = scenario.vehicles[0].model;
  for (const bool by_request : {false, true}) {
    Simulation simulation{scenario, builtin_catalogs()};
    LastFrame last;
    const std::array<FrameSink*, 1> sinks{&last};
    simulation.step(sinks);
    simulation.look();
    if (by_request) {
      simulation.order(1, {}, BodyRequest{.surge_mps = nan});
    } else {
      simulation.order(1, {.velocity = {0, infinity, 0}});
    }
    simulation.act(sinks);
    ASSERT_TRUE(simulation.is_done());
    EXPECT_EQ(simulation.divergence()->vehicle, 1U);
    EXPECT_EQ(simulation.divergence()->tick, Tick{1});
    EXPECT_EQ(simulation.divergence()->why,
              by_request ? "what is asked of its controller is not finite" : "its command is not finite");
    EXPECT_EQ(last.count, 1);
    EXPECT_TRUE(is_finite(simulation.agents()[1].vehicle.state()));
  }
}

TEST(Divergence, EveryPartOfAStateIsLookedAt) {
  EXPECT_EQ(why_impossible(VehicleState{}), "");
  for (int part = 0; part < 13; ++part) {
    for (const double broken : {nan, infinity, -infinity, 1e300}) {
      VehicleState x;
      (part < 3   ? x.p_n[part]
       : part < 6 ? x.v_b[part - 3]
       : part < 9 ? x.omega_b[part - 6]
                  : x.q_nb.coeffs()[part - 9]) = broken;
      EXPECT_NE(why_impossible(x), "") << part << " " << broken;
    }
  }
  EXPECT_EQ(why_impossible(VehicleState{.p_n = {1e7, -1e7, 100}}), "");
  EXPECT_EQ(why_impossible(VehicleState{.p_n = {0, 2.1e7, 0}}), "its position is beyond 20000 km");
  EXPECT_EQ(why_impossible(VehicleState{.v_b = {0, 0, 201}}), "its speed is beyond 200 m/s");
  EXPECT_EQ(why_impossible(VehicleState{.omega_b = {-201, 0, 0}}), "its turn rate is beyond 200 rad/s");
}

TEST(Divergence, EveryPartOfACommandAndOfADemandIsLookedAt) {
  Wrench wrench = Wrench::Zero();
  EXPECT_EQ(why_impossible(Command{.heading = 1.0, .turn_rate = 1.0, .wrench = wrench}), "");
  wrench[5] = nan;
  for (const Command& command : {Command{.velocity = {0, 0, nan}}, Command{.heading = nan},
                                 Command{.turn_rate = infinity}, Command{.wrench = wrench}}) {
    EXPECT_THAT(std::string(why_impossible(command)), HasSubstr("command"));
  }
  ActuatorValues demand = ActuatorValues::Zero(3);
  EXPECT_EQ(why_impossible(demand), "");
  demand[2] = nan;
  EXPECT_THAT(std::string(why_impossible(demand)), HasSubstr("demanded of its actuators"));
}

}  // namespace
}  // namespace fairway
