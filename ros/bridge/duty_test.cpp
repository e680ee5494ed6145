// SPDX-License-Identifier: Apache-2.0
// The nodes' duties wired to each other without a middleware.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"
#include "ros/bridge/fleet_duty.hpp"
#include "ros/bridge/messages.hpp"
#include "ros/bridge/testing/wired_avoider.hpp"

namespace fairway::bridge {
namespace {

using testing::HasSubstr;

/// What passes through a stamp.
double through_stamp(double seconds) {
  const std::int64_t ns = nanoseconds_of(seconds);
  return static_cast<double>(ns / 1000000000) + static_cast<double>(ns % 1000000000) / 1e9;
}

/// A fleet whose instants are handed to pilots, and compared with a plain run.
class Sea : public FleetOutlet {
 public:
  Sea(const std::string& file, bool lockstep) : Sea{settings(file, lockstep)} {}
  explicit Sea(const FleetNodeSettings& settings)
      : plain{load_scenario(settings.scenario), builtin_catalogs()}, duty{settings} {
    for (std::size_t i = 0; i < duty.fleet().size(); ++i) {
      AvoiderNodeSettings of_pilot;
      of_pilot.scenario = settings.scenario;
      of_pilot.vehicle = duty.fleet().vehicle(i).name;
      of_pilot.lockstep = settings.lockstep;
      pilots.push_back(std::make_unique<WiredAvoider>(of_pilot));
      pilots[i]->fleet = &duty;
      pilots[i]->index = i;
    }
  }

  static FleetNodeSettings settings(const std::string& file, bool lockstep) {
    FleetNodeSettings made;
    made.scenario = file;
    made.speed = 0;
    made.lockstep = lockstep;
    made.lockstep_timeout_s = 0.01;
    made.until_done = true;
    return made;
  }

  void show_clock(double) override {}
  void show_goal(std::size_t vehicle, const Triple& goal, double time) override {
    const double stamp = through_stamp(time);
    for (std::size_t i = 0; i < pilots.size(); ++i) {
      if (i == vehicle)
        pilots[i]->duty.go_to(goal, "world", stamp);
      else
        pilots[i]->duty.hear_mate_goal(mate_of(i, vehicle), goal, stamp);
      pilots[i]->duty.settle(stamp);  // the goals are there before the odometry of the instant
    }
  }
  void deliver_goals() override {}
  void show_navigation() override {
    compare();
    const double clock = through_stamp(std::max(duty.fleet().time() - clock_lag, 0.0));
    for (std::size_t i = 0; i < pilots.size(); ++i) {
      for (std::size_t k = 0; k < pilots.size(); ++k) {
        Motion motion = duty.fleet().vehicle(k).estimate;
        motion.time = through_stamp(motion.time);
        if (i == k)
          pilots[i]->duty.hear_own(motion, "world", clock);
        else
          pilots[i]->duty.hear_mate(mate_of(i, k), motion, clock);
      }
      pilots[i]->duty.settle(clock);
      pilots[i]->duty.come_round(clock);
    }
  }
  void show_truth() override {}
  void show_state(const std::string& json) override { state = json; }
  void show_picture() override {}
  std::size_t listeners(std::size_t) override { return 1; }
  bool is_steered(std::size_t) override { return true; }
  void handle(double) override {}
  bool goes_on() override { return !is_apart; }
  void warn(const std::string& words) override { warnings += words + "\n"; }

  /// Teams are in the order of the scenario, without oneself.
  static std::size_t mate_of(std::size_t own, std::size_t other) { return other < own ? other : other - 1; }

  void compare() {
    for (std::size_t i = 0; i < pilots.size(); ++i) {
      const VehicleState& x = plain.agents()[i].vehicle.state();
      is_apart =
          is_apart || duty.fleet().vehicle(i).truth.position_n != Triple{x.p_n.x(), x.p_n.y(), x.p_n.z()};
    }
    if (!plain.is_done()) plain.step({});
  }

  double clock_lag{};  // by which the clock comes later than navigation [s]
  Simulation plain;
  FleetDuty duty;
  std::vector<std::unique_ptr<WiredAvoider>> pilots;
  std::string state, warnings;
  bool is_apart{};
};

class Lockstep : public testing::TestWithParam<const char*> {};

TEST_P(Lockstep, AFleetAndItsAvoidersDoWhatThePlainRunDoesToTheBit) {
  Sea sea{std::string{FAIRWAY_SOURCE_DIR} + "/scenarios/" + GetParam(), true};
  EXPECT_EQ(sea.duty.run(sea), 0);
  EXPECT_FALSE(sea.is_apart) << "at " << sea.duty.fleet().time();
  EXPECT_EQ(sea.warnings, "");
  EXPECT_THAT(sea.state, HasSubstr("\"missed_count\":0"));
  for (const auto& pilot : sea.pilots) EXPECT_EQ(pilot->warnings, "");
}

TEST_P(Lockstep, AClockThatIsLongOnItsWayChangesNothing) {
  Sea sea{std::string{FAIRWAY_SOURCE_DIR} + "/scenarios/" + GetParam(), true};
  sea.clock_lag = 3.0;
  EXPECT_EQ(sea.duty.run(sea), 0);
  EXPECT_FALSE(sea.is_apart) << "at " << sea.duty.fleet().time();
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Lockstep,
                         testing::Values("head_on.yaml", "cube20_4.yaml", "cube20_8.yaml"));

TEST(FleetDuty, InLockstepItWaitsForTheMissingNoLongerThanItIsToldAndSaysWho) {
  Sea sea{std::string{FAIRWAY_SOURCE_DIR} + "/scenarios/head_on.yaml", true};
  sea.pilots[1]->fleet = nullptr;
  sea.duty.run(sea);
  EXPECT_THAT(sea.warnings, HasSubstr("no command of south_bound at 0.000000 s"));
  EXPECT_TRUE(sea.is_apart) << "who is not commanded holds, so it is not where the plain run is";
}

TEST(FleetDuty, WhileItWaitsForItsListenersItIsNotBehind) {
  class Deserted final : public Sea {
   public:
    using Sea::Sea;
    std::size_t listeners(std::size_t) override { return 0; }
    bool goes_on() override { return state.empty(); }
  };
  FleetNodeSettings settings =
      Sea::settings(std::string{FAIRWAY_SOURCE_DIR} + "/scenarios/head_on.yaml", false);
  settings.speed = 1;
  settings.wait_for_subscribers = 1;
  Deserted sea{settings};
  EXPECT_EQ(sea.duty.run(sea), 130);
  EXPECT_THAT(sea.state, HasSubstr("\"behind_s\":0.0"));
}

}  // namespace
}  // namespace fairway::bridge
