// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/pilot.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

const Ownship start{.position = {10, 20, 5}};
const Ownship adrift{.position = {10, 20, 6}};  // 1 m too deep

TEST(Pilot, AsksAtTheInstantNearestToOnePeriodAfterTheLastDecision) {
  Pilot pilot{{}, 1.0};
  EXPECT_TRUE(pilot.is_due(-5.0, 0.0));
  pilot.note_decision(10.0);
  EXPECT_FALSE(pilot.is_due(10.7, 0.4));
  EXPECT_TRUE(pilot.is_due(10.9, 0.4)) << "the next instant, at 11.3, would be farther from 11";
  EXPECT_FALSE(pilot.is_due(10.4, 60.0)) << "no interval counts for more than a period";
  pilot.ask_at_once();
  EXPECT_TRUE(pilot.is_due(10.1, 0.1));
}

TEST(Pilot, HoldsWhereItWasToldToUntilItIsToldOtherwise) {
  Pilot pilot{{}, 1.0};
  pilot.obey({.mode = Mode::hold}, start, Vec3::Zero());
  pilot.obey({.mode = Mode::hold}, {.position = {500, 20, 5}}, Vec3::Zero());
  EXPECT_NEAR(pilot.request(adrift, Vec3::Zero()).heave_mps, -0.3, 1e-12) << "back to the first place";
  EXPECT_EQ(pilot.request(adrift, Vec3::Zero()).surge_mps, 0.0);

  pilot.end_hold();
  pilot.obey({.mode = Mode::hold}, {.position = {10.5, 20, 6}}, Vec3::Zero());
  EXPECT_EQ(pilot.request(adrift, Vec3::Zero()).heave_mps, 0.0);
  EXPECT_GT(pilot.request(adrift, Vec3::Zero()).surge_mps, 0.0);

  pilot.obey({.velocity = {0.5, 0, 0}}, start, Vec3::Zero());
  EXPECT_EQ(pilot.request(adrift, Vec3::Zero()).surge_mps, 0.5);
}

TEST(Pilot, HoldsItsHeadingUntilACurrentHasSetItAsideAndThenTurnsItsBowToItsPlace) {
  const auto turn_rate = [](const Vec3& current, const Ownship& first, const Ownship& then) {
    Pilot pilot{{}, 1.0};
    for (const Ownship& own : {start, first, then}) pilot.obey({.mode = Mode::hold}, own, current);
    return pilot.request(then, current).yaw_rate_radps;
  };
  const Vec3 still = Vec3::Zero(), to_starboard{0, 0.1, 0};
  const Ownship astern{.position = {15, 21.9, 5}}, aside{.position = {10, 22.1, 5}};
  EXPECT_EQ(turn_rate(to_starboard, start, astern), 0.0) << "it goes back by its propeller";
  EXPECT_LT(turn_rate(to_starboard, start, aside), 0.0) << "to port, where its place is";
  EXPECT_EQ(turn_rate(still, start, aside), 0.0) << "nothing carries it farther";
  EXPECT_LT(turn_rate(to_starboard, aside, {.position = {10, 20.5, 5}}), 0.0) << "until its bow is there";
  const Ownship unsure{.position = {10, 22.1, 5}, .position_sigma = 0.1};
  EXPECT_EQ(turn_rate(to_starboard, start, unsure), 0.0) << "it may be there";
}

TEST(Pilot, ReckonsWithTheCurrentOnlyWhereTheVehicleCannotStop) {
  const Vec3 ahead{0.2, 0, 0};
  for (const SteeringKind kind : {SteeringKind::holonomic, SteeringKind::crab}) {
    Pilot pilot{{.steering = SteeringParams{.kind = kind, .min_speed_mps = 0.1}}, 1.0};
    pilot.obey({.velocity = {0.5, 0, 0}}, start, Vec3::Zero());
    const BodyRequest request = pilot.request(adrift, ahead);
    EXPECT_EQ(request.through_water, kind == SteeringKind::crab);
    EXPECT_NEAR(request.surge_mps, request.through_water ? 0.3 : 0.5, 1e-12);
    EXPECT_EQ(pilot.blind_request().surge_mps, request.through_water ? 0.1 : 0.0);
  }
}

TEST(Pilot, ShowsASectionByTheVelocityOfItsLineAndWhoArrivedAsTheLastInRank) {
  const Pilot pilot{{.radius = 2.5, .priority = 3, .limits = Limits{.max_speed = 0.7}}, 1.0};
  const Ownship own = pilot.own_ship({.p_n = {5, 1, 5}}, 0.25, false);
  EXPECT_EQ(own.priority, 3);
  EXPECT_EQ(own.radius, 2.5);
  EXPECT_EQ(own.position_sigma, 0.25);
  EXPECT_EQ(pilot.own_ship({}, 0.0, true).priority, last_priority);

  Leg leg{.kind = LegKind::section, .position = {50, 0, 5}, .from = {0, 0, 5}, .speed_mps = 0.5};
  const Situation along = pilot.situation(7.0, own, leg, {}, {});
  EXPECT_EQ(along.goal.velocity, follow_section(leg, own).velocity);
  EXPECT_EQ(along.limits.max_speed, 0.7);
  EXPECT_EQ(along.period, 1.0);
  leg.kind = LegKind::transit;
  EXPECT_FALSE(pilot.situation(7.0, own, leg, {}, {}).goal.velocity);
}

}  // namespace
}  // namespace fairway
