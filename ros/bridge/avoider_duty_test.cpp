// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/avoider_duty.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "ros/bridge/testing/wired_avoider.hpp"

namespace fairway::bridge {
namespace {

using testing::HasSubstr;
using testing::Not;

AvoiderNodeSettings alone() {
  return avoider_node_settings({{"algorithm", "orca3d"}, {"max_speed_mps", "0.5"}, {"team", "other"}}, "own");
}

Motion at(double time, double north) { return {.time = time, .position_n = {north, 0, 5}}; }

TEST(AvoiderDuty, NewNavigationIsAnsweredAtOnceWithItsOwnTime) {
  WiredAvoider pilot{alone()};
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
  WiredAvoider one{settings("one", "0", "other", "1")};
  WiredAvoider other{settings("other", "1", "one", "0")};
  const auto tell = [](WiredAvoider& from, WiredAvoider& to, double now) {
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
    for (WiredAvoider* pilot : {&one, &other}) {
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
  WiredAvoider pilot{alone()};
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
  WiredAvoider pilot{alone()};
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
    WiredAvoider pilot{alone()};
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
  WiredAvoider pilot{alone()};
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

TEST(AvoiderDuty, AnOrderThatWasRefusedMayComeAgain) {
  WiredAvoider pilot{alone()};
  pilot.duty.hear_own(at(10.0, 0), "world", 10.0);
  for (int i = 0; i < 2; ++i) pilot.duty.hear_goal({50, 0, 5}, "map", 9.9);
  EXPECT_THAT(pilot.warnings, Not(HasSubstr("passed over")));
}

TEST(AvoiderDuty, WhenItLetsGoBecauseOfItsDataTheLastCommandIsToStandStill) {
  for (const bool by_order : {true, false}) {
    WiredAvoider pilot{alone()};
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
    WiredAvoider pilot{settings};
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
    WiredAvoider pilot{alone()};
    EXPECT_EQ(pilot.duty.go_to({50, 0, 5}, frame, 0.0), "");
    pilot.duty.hear_own(at(10.0, 0), "world", 10.0);
    EXPECT_EQ(pilot.duty.host().goal().has_value(), frame != "map") << frame;
    if (frame == "map") EXPECT_THAT(pilot.warnings, HasSubstr("is dropped: it is in the frame 'map'"));
  }
}

TEST(AvoiderDuty, InLockstepItWaitsForWhoeverIsBehindAndAnswersAnOrderOfTheInstantAgain) {
  AvoiderNodeSettings settings = alone();
  settings.lockstep = true;
  WiredAvoider pilot{settings};
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
  WiredAvoider pilot{alone()};
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
  WiredAvoider pilot{alone()};
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
