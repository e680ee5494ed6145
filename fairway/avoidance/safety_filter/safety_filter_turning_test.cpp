// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/avoidance/safety_filter/safety_filter.hpp"
#include "fairway/avoidance/testing/boat.hpp"

namespace fairway {
namespace {

using encounters::buoy;
using encounters::of_a_boat;
using encounters::of_a_torpedo;
using encounters::OwnedSituation;
using encounters::Sailed;
using encounters::under_way;

Avoider filtered_direct() { return Avoider{SafetyFilter{{}}, Avoider{Direct{{}}}}; }

/// A hundred and twenty metres of it, north of own ship and across its way.
Obstacle wall_ahead(double north) {
  return {.kind = Obstacle::Kind::segment, .from = {north, -60.0, 50.0}, .to = {north, 60.0, 50.0}};
}

OwnedSituation bound_north(const Envelope& envelope) {
  OwnedSituation e = under_way(envelope);
  e.situation.own.position = {0.0, 0.0, 50.0};
  e.situation.goal = {.position = {60.0, 0.0, 50.0}, .cruise_speed = 1.0};
  return e;
}

TEST(SafetyFilterOfWhoMustTurn, InFrontOfAWallItStopsAndWhoCannotStopTurnsAway) {
  for (const Envelope& envelope : {of_a_boat(), of_a_torpedo()}) {
    OwnedSituation e = bound_north(envelope);
    e.obstacles = {wall_ahead(25.0)};
    const Sailed sailed = encounters::sail(e, filtered_direct(), 200.0);
    EXPECT_GT(sailed.clearance, 0.45) << envelope.least;  // the margin is 0.5 m
    EXPECT_EQ(sailed.infeasible, 0) << envelope.least;
  }
}

TEST(SafetyFilterOfWhoMustTurn, BetweenTwoWallsACircleIsAlwaysLeft) {
  // a basin 24 m wide and long; the torpedo turns on a radius of 2 m
  const Envelope torpedo = of_a_torpedo();
  OwnedSituation e = bound_north(torpedo);
  const auto side = [](double n0, double e0, double n1, double e1) {
    return Obstacle{.kind = Obstacle::Kind::segment, .from = {n0, e0, 50.0}, .to = {n1, e1, 50.0}};
  };
  e.obstacles = {side(12, -12, 12, 12), side(12, 12, -12, 12), side(-12, 12, -12, -12),
                 side(-12, -12, 12, -12)};
  const Sailed sailed = encounters::sail(e, filtered_direct(), 300.0);
  EXPECT_GT(sailed.clearance, 0.4);
  EXPECT_EQ(sailed.infeasible, 0);
}

TEST(SafetyFilterOfWhoMustTurn, SaysItAtTheInstantAtWhichNoBackupIsLeft) {
  for (const Envelope& envelope : {of_a_boat(), of_a_torpedo()}) {
    OwnedSituation e = bound_north(envelope);
    e.obstacles = {wall_ahead(1.6)};  // 0.6 m beyond own sphere, at 1 m/s
    const Command command = filtered_direct().decide(e);
    EXPECT_EQ(command.mode, Mode::infeasible) << envelope.least;
    EXPECT_EQ(std::string(command.note), "no manoeuvre is left that keeps clear of all") << envelope.least;
  }
}

TEST(SafetyFilterOfWhoMustTurn, WhatIsFarOffChangesNothingButHowItIsSteered) {
  const Envelope boat = of_a_boat();
  OwnedSituation e = bound_north(boat);
  e.obstacles = {buoy(50.0, 0.0)};
  const Command command = filtered_direct().decide(e);
  EXPECT_EQ(command.mode, Mode::cruise);
  EXPECT_NEAR(command.velocity.x(), 1.0, 1e-9);
  EXPECT_NEAR(command.turn_rate.value_or(1.0), 0.0, 1e-9);
}

TEST(SafetyFilterOfWhoMustTurn, WithoutAnEnvelopeBarriersAreKept) {
  const Envelope boat = of_a_boat();
  OwnedSituation e = bound_north(boat);
  e.situation.envelope = nullptr;
  e.obstacles = {buoy(5.0, 0.0, 2.0)};
  EXPECT_FALSE(filtered_direct().decide(e).turn_rate);
}

}  // namespace
}  // namespace fairway
