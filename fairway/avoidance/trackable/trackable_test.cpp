// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/trackable/trackable.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/avoidance/testing/boat.hpp"

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
using trackable::Plan;
using trackable::Prospect;
using trackable::TurnLaw;

Avoider around_direct_trackable() { return Avoider{Trackable{{}}, Avoider{Direct{{}}}}; }

TEST(Trackable, WithoutAnEnvelopeItShowsAMarginAndIsNothingElse) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    OwnedSituation e = encounters::crowd(8, Rng{i});
    Avoider wrapped = builtin_avoiders().make("orca3d+trackable", {{"shown_margin_m", 0.25}}, Rng{7});
    const Command command = wrapped.decide(e);
    e.situation.own.radius += 0.25;
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
    return Foresight{law, s, {.hold = 0.2, .window = 8.0, .margin = 0.1}}.of({.speed = 1.0});
  };
  EXPECT_EQ(comes_to(0.8), Prospect::lost);
  EXPECT_EQ(comes_to(2.0), Prospect::backed_up);
  EXPECT_EQ(comes_to(20.0), Prospect::clear);
}

TEST(Trackable, WhatIsNotAskedForIsNotForeseenAndAllElseIsTheSame) {
  const Envelope boat = of_a_boat();
  OwnedSituation e = under_way(boat);
  const TurnLaw law{boat, Limits::none};
  const double any = -std::numeric_limits<double>::infinity();
  int backed_up = 0, too_little = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    Rng rng = Rng{3}.stream("plans", i);
    const double bearing = rng.uniform(-1.0, 1.0), distance = rng.uniform(6.2, 12.0);
    e.obstacles = {buoy(e.situation.own.position.x() + distance * std::cos(bearing),
                        e.situation.own.position.y() + distance * std::sin(bearing), 5.0)};
    const Situation s = e;
    const Foresight foresight{law, s, {.hold = 0.2, .window = 8.0, .margin = 0.1}};
    const double course = rng.uniform(-1.0, 1.0), bound = rng.uniform(-2.0, 2.0);
    const Plan plan{.direction = {std::cos(course), std::sin(course)}, .speed = 1.0};

    const Prospect prospect = foresight.of(plan);
    backed_up += prospect == Prospect::backed_up ? 1 : 0;
    EXPECT_EQ(foresight.of(plan, false), prospect == Prospect::backed_up ? Prospect::lost : prospect) << i;

    const double room = foresight.room_of(plan, any), bounded = foresight.room_of(plan, bound);
    too_little += room <= bound ? 1 : 0;
    EXPECT_TRUE(room > bound ? bounded == room : bounded <= bound) << i;
  }
  EXPECT_GT(backed_up, 20);
  EXPECT_GT(too_little, 20);
}

TEST(Trackable, WhoCannotStopNeedsRoomForACircle) {
  // 1 m/s at 0.5 rad/s: a radius of 2 m
  const Envelope torpedo = of_a_torpedo();
  OwnedSituation e = under_way(torpedo);
  const TurnLaw law{torpedo, Limits::none};
  const auto comes_to = [&](double gap) {
    e.obstacles = {buoy(e.situation.own.position.x() + gap + 1.0 + 50.0, 0.0, 50.0)};
    const Situation s = e;
    return Foresight{law, s, {.hold = 0.2, .window = 16.0, .margin = 0.1}}.of({.speed = 1.0});
  };
  EXPECT_EQ(comes_to(1.5), Prospect::lost);
  EXPECT_EQ(comes_to(6.0), Prospect::backed_up);
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
  const Envelope boat = of_a_boat();
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
}

}  // namespace
}  // namespace fairway
