// SPDX-License-Identifier: Apache-2.0
// The nodes' duties wired to each other without a middleware.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"
#include "ros/bridge/avoider_duty.hpp"
#include "ros/bridge/fleet_duty.hpp"

namespace fairway::bridge {
namespace {

using testing::HasSubstr;

/// What passes through a stamp.
double through_stamp(double seconds) {
  const std::int64_t ns = nanoseconds_of(seconds);
  return static_cast<double>(ns / 1000000000) + static_cast<double>(ns % 1000000000) / 1e9;
}

/// An avoider whose commands are handed to a fleet.
class Pilot final : public AvoiderOutlet {
 public:
  explicit Pilot(const AvoiderNodeSettings& settings) : duty{settings, *this} {}

  void send_command(const BodyVelocity& velocity, double time) override {
    ++commands;
    if (fleet != nullptr) fleet->command(index, velocity, nanoseconds_of(time));
  }
  void send_record(const std::vector<std::uint8_t>&) override {}
  void send_status(const std::string& json) override { status = json; }
  void send_diagnosis(const Diagnosis& diagnosis, double) override { summary = diagnosis.summary; }
  void send_marks(const std::vector<Mark>&, double) override {}
  void warn(const std::string& words) override { warnings += words + "\n"; }

  AvoiderDuty duty;
  FleetDuty* fleet{};
  std::size_t index{};
  int commands{};
  std::string status, summary, warnings;
};

/// A fleet whose instants are handed to pilots, and compared with a plain run.
class Sea final : public FleetOutlet {
 public:
  Sea(const std::string& file, bool lockstep)
      : plain{load_scenario(file), builtin_catalogs()}, duty{settings(file, lockstep)} {
    for (std::size_t i = 0; i < duty.fleet().size(); ++i) {
      AvoiderNodeSettings of_pilot;
      of_pilot.host.scenario = file;
      of_pilot.host.vehicle = duty.fleet().vehicle(i).name;
      of_pilot.lockstep = lockstep;
      pilots.push_back(std::make_unique<Pilot>(of_pilot));
      pilots[i]->fleet = &duty;
      pilots[i]->index = i;
    }
  }

  static FleetNodeSettings settings(const std::string& file, bool lockstep) {
    FleetNodeSettings made;
    made.fleet.scenario = file;
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
    const double clock = through_stamp(duty.fleet().time());
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

  Simulation plain;
  FleetDuty duty;
  std::vector<std::unique_ptr<Pilot>> pilots;
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

INSTANTIATE_TEST_SUITE_P(Scenarios, Lockstep,
                         testing::Values("head_on.yaml", "cube20_4.yaml", "cube20_8.yaml"));

TEST(FleetDuty, InLockstepItWaitsForTheMissingNoLongerThanItIsToldAndSaysWho) {
  Sea sea{std::string{FAIRWAY_SOURCE_DIR} + "/scenarios/head_on.yaml", true};
  sea.pilots[1]->fleet = nullptr;
  sea.duty.run(sea);
  EXPECT_THAT(sea.warnings, HasSubstr("no command of south_bound at 0.000000 s"));
  EXPECT_TRUE(sea.is_apart) << "who is not commanded holds, so it is not where the plain run is";
}

AvoiderNodeSettings alone() {
  return avoider_node_settings({{"algorithm", "orca3d"}, {"max_speed_mps", "0.5"}, {"team", "other"}}, "own");
}

Motion at(double time, double north) { return {.time = time, .position_n = {north, 0, 5}}; }

TEST(AvoiderDuty, NewNavigationIsAnsweredAtOnceWithItsOwnTime) {
  Pilot pilot{alone()};
  pilot.duty.hear_own(at(10.0, 0), "world", 10.02);
  pilot.duty.go_to({50, 0, 5}, "world", 10.0);
  pilot.duty.settle(10.02);
  EXPECT_EQ(pilot.commands, 1);
  pilot.duty.settle(10.03);
  EXPECT_EQ(pilot.commands, 1) << "nothing is new";
  pilot.duty.come_round(10.2);
  EXPECT_EQ(pilot.commands, 2) << "it answers at least twenty times a second";
}

TEST(AvoiderDuty, NavigationThatIsRefusedIsCountedAndSaid) {
  Pilot pilot{alone()};
  pilot.duty.hear_own(at(10.0, 0), "world", 10.0);
  pilot.duty.hear_own(at(10.1, std::numeric_limits<double>::quiet_NaN()), "world", 10.1);
  pilot.duty.hear_own(at(10.0, 0), "world", 10.2);
  pilot.duty.settle(10.2);
  pilot.duty.come_round(10.2);
  EXPECT_THAT(pilot.warnings, HasSubstr("own odometry is refused: invalid"));
  EXPECT_THAT(pilot.status, HasSubstr("\"refused_count\":2"));
}

TEST(AvoiderDuty, AGoalOfAnotherFrameOrThatIsNoPlaceIsRefused) {
  Pilot pilot{alone()};
  pilot.duty.hear_own(at(10.0, 0), "world", 10.0);
  pilot.duty.go_to({50, 0, 5}, "map", 10.0);
  EXPECT_FALSE(pilot.duty.host().goal());
  EXPECT_THAT(pilot.warnings, HasSubstr("a goal in the frame 'map' is refused; own odometry is in 'world'"));
  pilot.duty.go_to({50, std::numeric_limits<double>::infinity(), 5}, "world", 10.0);
  EXPECT_FALSE(pilot.duty.host().goal());
  EXPECT_THAT(pilot.warnings, HasSubstr("a goal is refused: not a place"));
  pilot.duty.go_to({50, 0, 5}, "/world", 10.0);
  EXPECT_TRUE(pilot.duty.host().goal());
}

TEST(AvoiderDuty, TheWatchdogTellsTheVehicleToStandStillOnlyWhileItIsInCharge) {
  Pilot pilot{alone()};
  pilot.duty.raise_alarm(1.5, 9.0);
  EXPECT_EQ(pilot.commands, 0);
  pilot.duty.hear_own(at(10.0, 0), "world", 10.0);
  pilot.duty.go_to({50, 0, 5}, "world", 10.0);
  pilot.duty.settle(10.0);
  pilot.duty.raise_alarm(1.5, 11.5);
  EXPECT_EQ(pilot.commands, 2);
  EXPECT_THAT(pilot.summary, HasSubstr("watchdog: the loop has stood still"));
}

TEST(NodeSettings, WhatIsNotTheNodesOwnGoesToTheAvoiderOrIsRefusedWithTheNearestName) {
  const AvoiderNodeSettings made =
      avoider_node_settings({{"frame", "ned"}, {"params.time_horizon_s", "7"}}, "auv");
  EXPECT_EQ(made.frame, Frame::ned);
  EXPECT_EQ(made.host.vehicle, "auv");
  EXPECT_EQ(made.host.settings, (Settings{{"params.time_horizon_s", "7"}}));
  const FleetNodeSettings fleet = fleet_node_settings({{"scenario", "a.yaml"}, {"override.duration_s", "9"}});
  EXPECT_EQ(fleet.fleet.overrides, (Settings{{"duration_s", "9"}}));
  EXPECT_EQ(topic_name("AUV 1-b"), "AUV_1_b");
  EXPECT_THROW(fleet_node_settings({{"scenario", "a.yaml"}, {"locksteps", "true"}}), std::runtime_error);
  EXPECT_THROW(fleet_node_settings({{"scenario", "a.yaml"}, {"speed", "-1"}}), std::runtime_error);
  EXPECT_THROW(avoider_node_settings({{"lockstep", "true"}, {"input", "team_record"}}, "auv"),
               std::runtime_error);
}

}  // namespace
}  // namespace fairway::bridge
