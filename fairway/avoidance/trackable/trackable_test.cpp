// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/trackable/trackable.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/avoidance/testing/boat.hpp"
#include "fairway/avoidance/trackable/testing/plans.hpp"

namespace fairway {
namespace {

using encounters::buoy;
using encounters::of_a_boat;
using encounters::of_a_torpedo;
using encounters::OwnedSituation;
using encounters::sail;
using encounters::Sailed;
using encounters::under_way;
using trackable::Foresight;
using trackable::foresight_of;
using trackable::Plan;
using trackable::Prospect;
using trackable::prospect_of;
using trackable::TurnLaw;

Avoider around_direct_trackable() { return Avoider{Trackable{{}}, Avoider{Direct{{}}}}; }

/// At rest in the water, which sets it aside, its bow and its goal to the north.
OwnedSituation adrift(const Envelope& boat, const Vec3& current) {
  OwnedSituation e = under_way(boat);
  e.situation.own.position = {0.0, 0.0, 50.0};
  e.situation.current = current;
  e.situation.own.velocity = current;
  e.situation.goal = {.position = {60.0, 0.0, 50.0}, .cruise_speed = 1.0};
  return e;
}

TEST(Trackable, WithoutAnEnvelopeItShowsAMarginAndIsNothingElse) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    OwnedSituation e = encounters::crowd(8, Rng{i});
    e.situation.own.position_sigma = 0.125;
    Avoider wrapped = builtin_avoiders().make("orca3d+trackable", {{"shown_margin_m", 0.25}}, Rng{7});
    const Command command = wrapped.decide(e);
    e.situation.own.radius += 0.25 + 2 * 0.125;
    EXPECT_EQ(command, builtin_avoiders().make("orca3d", {}, Rng{7}).decide(e)) << i;
  }
}

TEST(Trackable, InOpenWaterItSteersForWhatIsAsked) {
  const Envelope boat = of_a_boat();
  OwnedSituation e = under_way(boat);
  e.situation.goal = {.position = {0.0, 100.0, 50.0}, .cruise_speed = 1.0};
  const Command command = around_direct_trackable().decide(e);
  EXPECT_EQ(command.mode, Mode::cruise);
  ASSERT_TRUE(command.turn_rate);
  EXPECT_NEAR(*command.turn_rate, 0.45, 1e-9);      // nine tenths of what it has, to starboard
  EXPECT_NEAR(command.velocity.norm(), 0.0, 1e-9);  // it turns before it goes across
}

TEST(Trackable, AForeseenStopNeedsItsWay) {
  // from 1 m/s at 0.5 m/s2 it stops within 1 m, and within 0.25 m more for the lag
  const Envelope boat = of_a_boat();
  OwnedSituation e = under_way(boat);
  const TurnLaw law{boat, Limits::none};
  const auto comes_to = [&](double gap) {
    e.obstacles = {buoy(e.situation.own.position.x() + gap + 1.0 + 5.0, 0.0, 5.0)};
    const Situation s = e;
    return prospect_of(foresight_of(law, s, {.hold = 0.2, .window = 8.0, .margin = 0.1}), {.speed = 1.0});
  };
  EXPECT_EQ(comes_to(0.8), Prospect::lost);
  EXPECT_EQ(comes_to(2.0), Prospect::backed_up);
  EXPECT_EQ(comes_to(20.0), Prospect::clear);
}

TEST(Trackable, WhatPassesBetweenTwoStepsIsSeen) {
  // 0.4 m aside, where 0.5 m are kept, at 6 m/s: nearer than that for 0.6 m of the 2.4 m of each step
  const Envelope boat = of_a_boat();
  OwnedSituation e = under_way(boat);
  e.situation.own.radius = 0.1;
  const TurnLaw law{boat, Limits::none};
  for (double range = 10.0; range < 12.4; range += 0.1) {
    e.tracks = {
        encounters::track(1, e.situation.own.position + Vec3{range, 0.4, 0.0}, {-5.0, 0.0, 0.0}, 0.1)};
    const Situation s = e;
    const Foresight foresight = foresight_of(law, s, {.hold = 0.8, .window = 8.0, .margin = 0.3});
    EXPECT_FALSE(foresight.is_clear({.speed = 1.0}, 1.0)) << range;
  }
}

TEST(Trackable, TheLawTurnsAsFastAsTheEnvelopeSays) {
  Envelope envelope = of_a_boat();
  envelope.turn_rates = {0.2, 0.5, 0.4, 0.3};
  for (const double limit : {0.33, Limits::none}) {
    const TurnLaw law{envelope, limit};
    for (int i = -10; i <= 60; ++i) {
      const double speed = 0.05 * i;
      EXPECT_EQ(law.greatest_turn_rate(speed), std::min(0.9 * envelope.turn_rate(speed), limit)) << speed;
      EXPECT_EQ(law.order(1.0, 3.0, speed).turn_rate, law.greatest_turn_rate(speed)) << speed;
      EXPECT_EQ(law.order(1.0, 0.1, speed).turn_rate, 0.1 * law.law().gain) << speed;
    }
  }
}

TEST(Trackable, WhoseTurnTakesTheBrakingBrakesFirst) {
  // north at 1 m/s, turning by 0.1 rad/s, of at most 2 m/s: it has braked at 0.1 m/s
  Envelope boat = of_a_boat();
  OwnedSituation e = under_way(boat);
  e.situation.own.yaw_rate = 0.1;
  const auto ordered = [&](double speed, const Plan& plan) {
    e.situation.own.velocity.x() = speed;
    const TurnLaw law{boat, Limits::none};
    return foresight_of(law, e, {.hold = 0.8, .window = 8.0}).order(plan);
  };
  const Plan stop{.direction = Vec2::UnitY()}, back{.direction = -Vec2::UnitX(), .speed = 1.0};
  const Plan aside{.direction = unit_at(radians(60.0)), .speed = 1.0};
  EXPECT_EQ(ordered(1.0, stop).turn_rate, 0.45);  // nine tenths of 0.5 rad/s
  boat.deceleration_lost = 0.4;                   // of 0.5 m/s2
  for (const Plan& plan : {stop, back}) {
    EXPECT_EQ(ordered(1.0, plan).surge, 0.0);
    EXPECT_EQ(ordered(1.0, plan).turn_rate, 0.1);
    EXPECT_EQ(ordered(0.11, plan).turn_rate, 0.1);
    EXPECT_EQ(std::abs(ordered(0.09, plan).turn_rate), 0.45);
  }
  EXPECT_EQ(ordered(1.0, aside).turn_rate, 0.45);
}

TEST(Trackable, ATurnTakesOfTheBrakingThatIsForeseen) {
  // told to turn by a quarter, which brakes to a stop: while the turn rate grows by 0.5 rad/s2 to 0.45 rad/s,
  // for 0.9 s, it slows down by 0.28 instead of 0.5 m/s2, is then 0.2 m/s faster, and so it goes farther by
  // 0.09 m in that time alone
  Envelope boat = of_a_boat();
  const auto way_of = [&] {
    const OwnedSituation e = under_way(boat);
    const TurnLaw law{boat, Limits::none};
    const Foresight::Path path =
        foresight_of(law, e, {.hold = 0.8, .window = 8.0}).path({.direction = unit_at(1.5)});
    return path.points[path.count - 1].x();
  };
  const double without = way_of();
  boat.deceleration_lost = 0.22;  // not so much that it brakes first: of 0.5 m/s2
  EXPECT_GT(way_of(), without + 0.08);
}

TEST(Trackable, StepsAreAsLongAsTheVehicleIsSlow) {
  const auto steps_of = [](const Envelope& envelope, double window) {
    const OwnedSituation e = under_way(envelope);
    const TurnLaw law{envelope, Limits::none};
    const Foresight foresight = foresight_of(law, e, {.hold = 0.8, .window = window});
    EXPECT_GE(static_cast<double>(foresight.steps()) * foresight.step(), window - 1e-9);
    return foresight.steps();
  };
  Envelope boat = of_a_boat();
  EXPECT_EQ(steps_of(boat, 8.0), 20);  // 0.8 of a lag of 0.5 s; the hold is two of them
  boat.turn_lag = 0.3;                 // 0.24 s, and the hold a whole number of them: four of 0.2 s
  EXPECT_EQ(steps_of(boat, 8.0), 40);
  EXPECT_EQ(steps_of(boat, 60.0), trackable::most_steps);
}

TEST(Trackable, WhoCannotStopNeedsRoomForACircle) {
  // 1 m/s at 0.5 rad/s: a radius of 2 m
  const Envelope torpedo = of_a_torpedo();
  OwnedSituation e = under_way(torpedo);
  const TurnLaw law{torpedo, Limits::none};
  const auto comes_to = [&](double gap) {
    e.obstacles = {buoy(e.situation.own.position.x() + gap + 1.0 + 50.0, 0.0, 50.0)};
    const Situation s = e;
    return prospect_of(foresight_of(law, s, {.hold = 0.2, .window = 16.0, .margin = 0.1}), {.speed = 1.0});
  };
  EXPECT_EQ(comes_to(1.5), Prospect::lost);
  EXPECT_EQ(comes_to(6.0), Prospect::backed_up);
}

TEST(Trackable, WhoCannotStopKeepsToTheSideToWhichItTurned) {
  // a buoy straight ahead; the way to the goal is a little to starboard of it, then to port, then well clear
  const Envelope torpedo = of_a_torpedo();
  OwnedSituation e = under_way(torpedo);
  e.situation.own.position = {0.0, 0.0, 50.0};
  e.obstacles = {buoy(14.0, 0.0, 2.0)};
  const auto turn_for = [&](Avoider& avoider, double east) {
    e.situation.goal = {.position = {60.0, east, 50.0}, .cruise_speed = 1.0};
    return avoider.decide(e).turn_rate.value();
  };
  Avoider avoider = around_direct_trackable(), anew = around_direct_trackable();
  EXPECT_GT(turn_for(avoider, 4.0), 0.0);
  EXPECT_LT(turn_for(anew, -4.0), 0.0);
  EXPECT_GT(turn_for(avoider, -4.0), 0.0);
  EXPECT_LT(turn_for(avoider, -40.0), 0.0);
}

TEST(Trackable, WhoCannotStopGoesOnAlongTheOnlyWayThatIsClear) {
  // 2 m to the walls on either side: the course that is asked for later meets one, and so do all that differ
  // from it by steps of 15 degrees
  const Envelope torpedo = of_a_torpedo();
  OwnedSituation e = under_way(torpedo);
  e.situation.own.position = {0.0, 0.0, 50.0};
  e.obstacles = {encounters::wall({-40.0, 3.0, 50.0}, {60.0, 3.0, 50.0}),
                 encounters::wall({-40.0, -3.0, 50.0}, {60.0, -3.0, 50.0})};
  const auto go_for = [&](Avoider& avoider, double north, double east) {
    e.situation.goal = {.position = {north, east, 50.0}, .cruise_speed = 1.0};
    return avoider.decide(e);
  };
  Avoider avoider = around_direct_trackable(), anew = around_direct_trackable();
  EXPECT_EQ(go_for(avoider, 100.0, 0.0).mode, Mode::cruise);
  const Command command = go_for(avoider, 80.0, 60.0);
  EXPECT_EQ(command.mode, Mode::avoid);
  EXPECT_NEAR(command.turn_rate.value(), 0.0, 1e-9);
  EXPECT_EQ(go_for(anew, 80.0, 60.0).mode, Mode::infeasible);
}

TEST(Trackable, WhoCannotStopGoesOnUntilItCanTurnForItsGoal) {
  // at 1 m/s and 0.45 rad/s it goes round a circle of 2.2 m
  const Envelope torpedo = of_a_torpedo();
  OwnedSituation e = under_way(torpedo);
  e.situation.own.position = {0.0, 0.0, 50.0};
  const auto turn_for = [&](double north, double east, double arrival) {
    e.situation.goal = {.position = {north, east, 50.0}, .cruise_speed = 1.0, .arrival = arrival};
    return around_direct_trackable().decide(e).turn_rate.value();
  };
  EXPECT_EQ(turn_for(0.5, 2.0, 0.5), 0.0);
  EXPECT_GT(turn_for(0.5, 2.0, 2.0), 0.1);
  EXPECT_GT(turn_for(-4.0, 4.0, 0.5), 0.1);
  EXPECT_LT(turn_for(-4.0, -4.0, 0.5), -0.1);
}

TEST(Trackable, WhoCanStopSlowsForAGoalThatItWouldGoRound) {
  const Envelope boat = of_a_boat();
  OwnedSituation e = under_way(boat);
  e.situation.own.position = {0.0, 0.0, 50.0};
  const auto speed_for = [&](double north, double east) {
    e.situation.goal = {.position = {north, east, 50.0}, .cruise_speed = 1.0};
    return around_direct_trackable().decide(e).velocity.norm();
  };
  // 45 degrees off the heading the law makes half of what is asked
  EXPECT_NEAR(speed_for(30.0, 30.0), 0.5, 1e-9);
  EXPECT_LT(speed_for(0.5, 0.5), 0.3);
  EXPECT_NEAR(speed_for(0.5, 0.0), 1.0, 1e-9);
}

TEST(Trackable, ABuoyStraightAheadIsPassedByWhoStopsAndByWhoCannot) {
  for (const Envelope& envelope : {of_a_boat(), of_a_torpedo()}) {
    OwnedSituation e = under_way(envelope);
    e.situation.goal = {.position = {60.0, 0.0, 50.0}, .cruise_speed = 1.0};
    e.situation.own.position = {0.0, 0.0, 50.0};
    e.obstacles = {buoy(25.0, 0.0, 2.0)};
    const Sailed sailed = sail(e, around_direct_trackable(), 50.0);
    EXPECT_GT(sailed.clearance, 0.25) << envelope.least;
    EXPECT_EQ(sailed.infeasible, 0) << envelope.least;
    EXPECT_GT(sailed.end.x(), 40.0) << envelope.least;
  }
}

TEST(Trackable, WhatDriftsAcrossIsNotMet) {
  const Envelope boat = of_a_boat();
  OwnedSituation e = under_way(boat);
  e.situation.own.position = {0.0, 0.0, 50.0};
  e.situation.goal = {.position = {60.0, 0.0, 50.0}, .cruise_speed = 1.0};
  e.tracks = {encounters::track(1, {20.0, -10.0, 50.0}, {0.0, 0.5, 0.0}, 1.5)};
  e.tracks[0].reacts = false;
  EXPECT_LT(sail(e, Avoider{Direct{{}}}, 40.0).clearance, 0.0);
  EXPECT_GT(sail(e, around_direct_trackable(), 40.0).clearance, 0.25);
}

TEST(Trackable, WhoHasNoRoomToGoStandsWithItsBowUpIntoTheCurrent) {
  // twelve buoys around it, and a current that sets it to starboard; how much room it needs
  const Envelope boat = of_a_boat();
  OwnedSituation e = adrift(boat, {0.0, 0.1, 0.0});
  const auto asked_among = [&](double gap) {
    e.obstacles.clear();
    for (int i = 0; i < 12; ++i) {
      const Vec2 at = (e.situation.own.radius + 3.0 + gap) * unit_at(pi / 6 * i);
      e.obstacles.push_back(buoy(at.x(), at.y(), 3.0));
    }
    return around_direct_trackable().decide(e);
  };
  EXPECT_EQ(asked_among(0.56).mode, Mode::infeasible);
  const Command command = asked_among(0.57);  // 0.58 if it went on for a while first
  EXPECT_EQ(command.mode, Mode::avoid);
  EXPECT_EQ(command.velocity.head<2>().norm(), 0.0);
  EXPECT_LT(command.turn_rate.value(), 0.0);  // to port, up into it
}

TEST(Trackable, WhoCanNeitherStopNorTurnInTimeGoesAsternFromWhatStands) {
  // a current sets it on a wall: told to stop it would come nearer than the 0.3 m that it keeps
  const Envelope boat = of_a_boat();
  OwnedSituation e = adrift(boat, {0.3, 0.0, 0.0});
  e.obstacles = {buoy(e.situation.own.radius + 100.0 + 0.45, 0.0, 100.0)};
  const auto decided = [&] { return around_direct_trackable().decide(e); };
  EXPECT_EQ(decided().mode, Mode::avoid);
  EXPECT_EQ(decided().velocity, Vec3(-0.5, 0.0, 0.0));  // half of its cruise speed
  EXPECT_EQ(decided().turn_rate, 0.0);
  e.situation.limits.sternway = false;
  EXPECT_EQ(decided().mode, Mode::infeasible);
  e.situation.limits.sternway = true;
  e.tracks = {encounters::track(1, e.obstacles[0].position, {-0.1, 0.0, 0.0}, 100.0)};  // it would follow
  e.obstacles.clear();
  EXPECT_EQ(decided().mode, Mode::infeasible);
}

TEST(Trackable, FieldsOfBuoysAreCrossedWithoutATouch) {
  const Envelope boat = of_a_boat();
  double clearance = 1e9;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng = Rng{11}.stream("field", seed);
    OwnedSituation e = under_way(boat);
    e.situation.own.position = {0.0, 0.0, 50.0};
    e.situation.goal = {.position = {50.0, 0.0, 50.0}, .cruise_speed = 1.0};
    for (int i = 0; i < 14; ++i)
      e.obstacles.push_back(buoy(rng.uniform(8.0, 42.0), rng.uniform(-8.0, 8.0), rng.uniform(0.3, 1.2)));
    clearance = std::min(clearance, sail(e, around_direct_trackable(), 45.0).clearance);
  }
  EXPECT_GT(clearance, 0.0);
}

TEST(Trackable, WhatPassesFarAboveDoesNotCount) {
  const Envelope boat = of_a_boat();
  OwnedSituation e = under_way(boat);
  e.situation.goal = {.position = {60.0, 0.0, 50.0}, .cruise_speed = 1.0};
  e.situation.limits.max_climb_rate = 0.0;
  e.obstacles = {buoy(5.0, 0.0, 2.0)};
  e.obstacles[0].position.z() = 10.0;
  EXPECT_EQ(around_direct_trackable().decide(e).mode, Mode::cruise);
}

TEST(Trackable, ItDoesNotComeDownOnWhatItPassesOver) {
  const Envelope boat = of_a_boat();
  OwnedSituation e = under_way(boat);
  e.situation.own.position = {0.0, 0.0, 20.0};
  e.situation.goal = {.position = {60.0, 0.0, 60.0}, .cruise_speed = 1.0};
  EXPECT_GT(around_direct_trackable().decide(e).velocity.z(), 0.5);
  e.obstacles = {buoy(1.0, 0.0, 27.5)};  // its top is at 22.5 m, where own sphere ends at 21 m
  EXPECT_EQ(around_direct_trackable().decide(e).velocity.z(), 0.0);
  e.obstacles[0].position.z() = -10.0;  // its bottom is at 17.5 m
  EXPECT_GT(around_direct_trackable().decide(e).velocity.z(), 0.5);
}

TEST(Trackable, ItsMarginsAddUpAndAreDrawn) {
  const trackable::Margins margins{
      .tracking = 0.1, .perception = 0.2, .navigation = 0.3, .current = 0.05, .extra = 0.4};
  EXPECT_DOUBLE_EQ(margins.total(10.0), 0.1 + 0.2 + 0.3 + 0.5 + 0.4);
  // a buoy that is passed with 1 m to spare is gone round where the parts ask for more
  Envelope boat = of_a_boat();
  OwnedSituation e = under_way(boat);
  e.situation.own.position = {0.0, 0.0, 50.0};
  e.situation.goal = {.position = {60.0, 0.0, 50.0}, .cruise_speed = 1.0};
  e.obstacles = {buoy(8.0, 2.5, 0.5)};
  const auto mode_with = [&](Trackable::Params params) {
    return Avoider{Trackable{params}, Avoider{Direct{{}}}}.decide(e).mode;
  };
  EXPECT_EQ(mode_with({}), Mode::cruise);
  EXPECT_EQ(mode_with({.margin_m = 1.1}), Mode::avoid);
  EXPECT_EQ(mode_with({.tracking_bound_m = 0.8}), Mode::avoid);
  EXPECT_EQ(mode_with({.perception_error_m = 0.8}), Mode::avoid);
  EXPECT_EQ(mode_with({.navigation_error_m = 0.8}), Mode::avoid);
  EXPECT_EQ(mode_with({.current_error_mps = 0.2}), Mode::avoid);
  boat.foresight_error = 0.5;
  EXPECT_EQ(mode_with({}), Mode::cruise) << "so much the usual margin holds";
  boat.foresight_error = 1.3;
  EXPECT_EQ(mode_with({}), Mode::avoid) << "what its trials have shown bounds the tracking from below";
  boat.foresight_error = 0.0;
  e.situation.own.position_sigma = 0.4;
  EXPECT_EQ(mode_with({}), Mode::avoid) << "what its navigation states is kept too, twice";
}

}  // namespace
}  // namespace fairway
