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
#include "ros/bridge/messages.hpp"

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
    last = velocity;
    if (fleet != nullptr) fleet->command(index, velocity, nanoseconds_of(time));
  }
  void send_record(const std::vector<std::uint8_t>&) override { ++records; }
  void send_speech(const std::vector<std::uint8_t>& bytes) override { said.push_back(bytes); }
  void send_status(const std::string& json) override { status = json; }
  void send_diagnosis(const Diagnosis& diagnosis, double) override { summary = diagnosis.summary; }
  void send_marks(const std::vector<Mark>&, double) override {}
  void warn(const std::string& words) override { warnings += words + "\n"; }

  AvoiderDuty duty;
  FleetDuty* fleet{};
  std::size_t index{};
  int commands{};
  BodyVelocity last{};
  int records{};
  std::vector<std::vector<std::uint8_t>> said;
  std::string status, summary, warnings;
};

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
      pilots.push_back(std::make_unique<Pilot>(of_pilot));
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
  EXPECT_EQ(pilot.commands, 2) << "it answers at least ten times a second";
}

TEST(AvoiderDuty, AMethodThatSpeaksSaysItsOwnWordsInThePlaceOfTheRecordAndHearsThoseOfMates) {
  const auto settings = [](const char* name, const char* id, const char* mate, const char* mates_id) {
    return avoider_node_settings({{"algorithm", "pledge"},
                                  {"params.team_count", "2"},
                                  {"max_speed_mps", "0.5"},
                                  {"id", id},
                                  {"team", mate},
                                  {std::string{"team."} + mate + ".id", mates_id},
                                  {"record_rate_hz", "0.5"}},
                                 name);
  };
  Pilot one{settings("one", "0", "other", "1")};
  Pilot other{settings("other", "1", "one", "0")};
  const auto tell = [](Pilot& from, Pilot& to, double now) {
    for (const std::vector<std::uint8_t>& words : from.said) {
      EXPECT_LE(words.size(), 25U);
      to.duty.hear_speech(0, words.data(), words.size(), now);
    }
    const bool spoke = !from.said.empty();
    from.said.clear();
    return spoke;
  };
  int spoken = 0;
  bool has_set_out = false;
  for (int i = 0; i < 300; ++i) {
    const double now = 0.1 * i;
    one.duty.hear_own(at(now, 0), "world", now);
    other.duty.hear_own(at(now, 40), "world", now);
    if (i == 0) {
      one.duty.go_to({40, 0, 5}, "world", 0.0);
      other.duty.go_to({0, 0, 5}, "world", 0.0);
    }
    for (Pilot* pilot : {&one, &other}) {
      pilot->duty.settle(now);
      pilot->duty.come_round(now);
    }
    spoken += tell(one, other, now) + tell(other, one, now);
    has_set_out = has_set_out || one.duty.host().order().mode == "avoid";
  }
  EXPECT_GT(spoken, 20) << "of 30 turns";
  EXPECT_LE(one.records + other.records, 4) << "while it comes to rest it has no word of its own";
  EXPECT_TRUE(has_set_out) << "they agreed";
  one.duty.hear_speech(0, nullptr, 26, 30.0);
  EXPECT_THAT(one.warnings, HasSubstr("what other says is refused: invalid"));
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

TEST(AvoiderDuty, AnOrderThatCannotBeCarriedOutIsRefusedInWordsAndChangesNothing) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Pilot pilot{alone()};
  AvoiderDuty& duty = pilot.duty;
  duty.hear_own(at(10.0, 0), "world", 10.0);
  EXPECT_EQ(duty.go_to({50, 0, 5}, "map", 10.0),
            "refused: it is in the frame 'map'; own odometry is in 'world'");
  EXPECT_EQ(duty.go_to({50, inf, 5}, "world", 10.0), "refused: a position is not a number");
  EXPECT_THAT(duty.go_to({50, 0, 5}, "", 0.0, -1.0), HasSubstr("a speed of -1.0"));
  EXPECT_EQ(duty.go_to({1e9, 0, 5}, "", 0.0, 0.4), "refused: out of what the avoider accepts");
  EXPECT_THAT(duty.follow_section({1, 1, 5}, {1, 1, 5}, 0.5), HasSubstr("refused"));
  EXPECT_EQ(duty.follow({}, {""}, 0.0), "refused: no position is given");
  EXPECT_EQ(duty.follow({{9, 0, 5}, {9, 9, 5}}, {"world", "", "map"}, 0.0),
            "refused: it is in the frames 'world' and 'map'");
  EXPECT_EQ(duty.follow({{9, 0, 5}}, {"", "map"}, 0.0),
            "refused: it is in the frame 'map'; own odometry is in 'world'");
  EXPECT_FALSE(duty.host().goal());
  EXPECT_THAT(pilot.warnings, HasSubstr("a goal is refused: it is in the frame 'map'"));
  EXPECT_EQ(duty.go_to({50, 0, 5}, "/world", 10.0), "");
  EXPECT_TRUE(duty.host().goal());
  EXPECT_EQ(duty.follow({{9, 0, 5}, {9, 9, 5}}, {"world", "/world", ""}, 0.0), "");
}

TEST(AvoiderDuty, WhatItWasToldToDoIsDroppedWhenItsOdometryChangesItsFrame) {
  for (const std::string frame : {"map", "world", "/world", ""}) {
    Pilot pilot{alone()};
    pilot.duty.hear_own(at(10.0, 0), "world", 10.0);
    EXPECT_EQ(pilot.duty.go_to({50, 0, 5}, "world", 0.0), "");
    pilot.duty.hear_own(at(10.1, 0), frame, 10.1);
    EXPECT_EQ(pilot.duty.host().goal().has_value(), frame != "map") << frame;
    if (frame == "map")
      EXPECT_THAT(pilot.warnings, HasSubstr("own odometry was in the frame 'world' and is in 'map' now"));
    else
      EXPECT_EQ(pilot.warnings, "");
    pilot.duty.settle(10.1);
    EXPECT_EQ(pilot.commands, frame == "map" ? 0 : 1);
  }
}

TEST(AvoiderDuty, ALatchedOrderThatComesAgainIsNoNewOne) {
  Pilot pilot{alone()};
  AvoiderDuty& duty = pilot.duty;
  duty.hear_own(at(10.0, 0), "world", 10.0);
  duty.hear_goal({50, 0, 5}, "world", 9.9);
  EXPECT_TRUE(duty.host().goal());
  duty.keep_position();
  duty.hear_goal({50, 0, 5}, "world", 9.9);
  EXPECT_FALSE(duty.host().goal()) << "its connection was made anew";
  EXPECT_THAT(pilot.warnings, HasSubstr("a goal is passed over: it is the last one again"));
  duty.hear_goal({50, 0, 5}, "world", 11.0);
  EXPECT_TRUE(duty.host().goal()) << "by another stamp it is meant anew";
  duty.hear_path({{50, 0, 5}, {50, 50, 5}}, {"world", "", ""}, 12.0);
  duty.keep_position();
  duty.hear_path({{50, 0, 5}, {50, 50, 5}}, {"world", "", ""}, 12.0);
  EXPECT_FALSE(duty.host().goal());
  duty.go_to({50, 0, 5}, "", 0.0);
  duty.keep_position();
  EXPECT_EQ(duty.go_to({50, 0, 5}, "", 0.0), "");
  EXPECT_TRUE(duty.host().goal()) << "a service is never asked by itself";
}

TEST(AvoiderDuty, WhenItLetsGoBecauseOfItsDataTheLastCommandIsToStandStill) {
  for (const bool by_order : {true, false}) {
    Pilot pilot{alone()};
    pilot.duty.hear_own(at(10.0, 0), "world", 10.0);
    pilot.duty.go_to({50, 0, 5}, "world", 0.0);
    pilot.duty.settle(10.0);
    EXPECT_GT(pilot.last.surge_mps, 0.1);
    if (by_order) pilot.duty.stand_by();
    pilot.duty.come_round(15.0);  // the clock was set ahead, and navigation is 5 s old
    EXPECT_EQ(pilot.commands, by_order ? 1 : 2);
    if (!by_order) EXPECT_EQ(pilot.last.surge_mps, 0.0);
    pilot.duty.come_round(16.0);
    EXPECT_EQ(pilot.commands, by_order ? 1 : 2) << "once";
  }
}

TEST(AvoiderDuty, AWallClockThatIsSetBackEndsInAHoldAndNotInTheEndOfItsMission) {
  for (const bool wall_clock : {true, false}) {
    AvoiderNodeSettings settings = alone();
    settings.wall_clock = wall_clock;
    Pilot pilot{settings};
    const auto hear = [&](double time) {
      pilot.duty.hear_own(at(time, 0.05 * time), "world", time);
      pilot.duty.settle(time);
      pilot.duty.come_round(time);
    };
    hear(10.0);
    pilot.duty.go_to({50, 0, 5}, "world", 0.0);
    for (int i = 1; i <= 10; ++i) hear(10.0 + 0.1 * i);
    EXPECT_GT(pilot.last.surge_mps, 0.1);
    hear(7.0);
    EXPECT_EQ(pilot.last.surge_mps, 0.0);
    for (int i = 1; i <= 15; ++i) hear(7.0 + 0.1 * i);
    EXPECT_EQ(pilot.duty.host().order().state, wall_clock ? "under_way" : "idle");
  }
}

TEST(AvoiderDuty, AGoalThatCameBeforeTheFirstOdometryIsDroppedIfItWasInAnotherFrame) {
  for (const std::string frame : {"map", "world", "/world", ""}) {
    Pilot pilot{alone()};
    EXPECT_EQ(pilot.duty.go_to({50, 0, 5}, frame, 0.0), "");
    pilot.duty.hear_own(at(10.0, 0), "world", 10.0);
    EXPECT_EQ(pilot.duty.host().goal().has_value(), frame != "map") << frame;
    if (frame == "map") EXPECT_THAT(pilot.warnings, HasSubstr("is dropped: it is in the frame 'map'"));
  }
}

TEST(AvoiderDuty, InLockstepItWaitsForWhoeverIsBehindAndAnswersAnOrderOfTheInstantAgain) {
  AvoiderNodeSettings settings = alone();
  settings.lockstep = true;
  Pilot pilot{settings};
  AvoiderDuty& duty = pilot.duty;
  const auto settles = [&](double clock) {
    const int before = pilot.commands;
    duty.settle(clock);
    return pilot.commands - before;
  };
  duty.go_to({50, 0, 5}, "", 0.0);
  duty.hear_own(at(0.0, 0), "world", 0.0);
  EXPECT_EQ(settles(0.0), 0) << "the other is missing";
  duty.hear_mate(0, at(0.0, 100), 0.0);
  EXPECT_EQ(settles(0.0), 1);
  EXPECT_EQ(settles(0.0), 0) << "once";
  duty.go_to({-50, 0, 5}, "", 0.0);
  EXPECT_EQ(settles(0.0), 1) << "an order without a stamp is of now";
  duty.go_to({50, 0, 5}, "", 0.5);
  EXPECT_EQ(settles(0.0), 0) << "this one is of an instant to come";
  for (const double time : {0.1, 0.2}) duty.hear_mate(0, at(time, 100), time);
  EXPECT_EQ(settles(0.2), 0) << "the own navigation is behind";
}

TEST(AvoiderDuty, TimeIsTheClocksOrThatOfNavigationNoMoreThanATenthAhead) {
  Pilot pilot{alone()};
  const auto time_at = [&](double clock, double stamp) {
    pilot.duty.hear_own(at(stamp, 0), "world", clock);
    pilot.duty.settle(clock);
    return pilot.duty.host().order().time;
  };
  EXPECT_EQ(time_at(10.0, 10.05), 10.05);
  EXPECT_EQ(time_at(10.0, 10.06), 10.06) << "it does not go back when the clock is asked again";
  EXPECT_EQ(time_at(10.2, 20.0), 10.2) << "not from the future";
  EXPECT_EQ(time_at(10.2, 3.0), 10.2) << "nor from the past";
  EXPECT_EQ(time_at(10.2, std::numeric_limits<double>::quiet_NaN()), 10.2);
  EXPECT_EQ(time_at(0.05, 0.05), 0.05) << "a simulation has begun again";
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

}  // namespace
}  // namespace fairway::bridge
