// SPDX-License-Identifier: Apache-2.0
// A helm by a clock that begins again, stands, runs back or is set.
#include <gtest/gtest.h>

#include "fairway/onboard/testing/fixes.hpp"

namespace fairway {
namespace {

using fixes::h;
using fixes::nan;
using fixes::on_course;
using fixes::setup;
using fixes::under_way;

TEST(Helm, AClockThatBeginsAgainMakesItForgetEverythingHeard) {
  Helm helm = under_way(10.0);
  helm.neighbour_fix(VehicleId{1}, on_course(10.0, {0, 20, 10}), 10.0);
  EXPECT_EQ(helm.update(0.0).state, HelmState::waiting);
  EXPECT_EQ(helm.report(0.0).clock_restarts, 1);
  EXPECT_FALSE(helm.report(0.0).neighbours[0].heard);
  EXPECT_FALSE(helm.goal());
  EXPECT_EQ(helm.own_fix(on_course(0.1), 0.1), FixVerdict::accepted);
  ASSERT_TRUE(helm.go_to({500, 0, 10}, 0.5));
  EXPECT_EQ(helm.update(0.1).state, HelmState::under_way);
}

TEST(Helm, AClockThatStepsBackALittleStandsStill) {
  Helm helm = under_way(10.0);
  EXPECT_EQ(helm.update(9.9).time, 10.0);
  EXPECT_EQ(helm.update(nan).time, 10.0);
  EXPECT_EQ(helm.report(10.0).clock_restarts, 0);
}

TEST(Helm, AClockThatRunsBackOrSaysNoTimeEndsInAHold) {
  for (const double stopped : {nan, 9.9}) {
    Helm helm = under_way(10.0);
    for (int i = 0; i < 20; ++i) {
      helm.own_fix(on_course(10.0 + h * i), stopped);
      helm.update(stopped);
    }
    EXPECT_EQ(helm.order().state, HelmState::holding) << stopped;
    EXPECT_EQ(helm.order().reason, "the clock runs back or says no time");
    for (int i = 1; i <= 20; ++i) {
      helm.own_fix(on_course(10.0 + h * i), 10.0 + h * i);
      helm.update(10.0 + h * i);
    }
    EXPECT_EQ(helm.order().state, HelmState::under_way) << "and it goes on when that does";
  }
}

TEST(Helm, AClockThatStandsWhileOwnNavigationGoesOnEndsInAHold) {
  Helm helm = under_way(10.0);
  for (int i = 1; i <= 4; ++i)
    EXPECT_EQ(helm.update(10.0).state, HelmState::under_way) << "a simulation pauses";
  for (int i = 1; i <= 9; ++i) {
    helm.own_fix(on_course(10.0 + h * i), 10.0);
    helm.update(10.0);
  }
  EXPECT_EQ(helm.order().state, HelmState::holding);
  EXPECT_EQ(helm.order().reason, "own navigation goes on and is ahead of the clock, which stands");
  for (int i = 10; i <= 30; ++i) {
    helm.own_fix(on_course(10.0 + h * i), 10.0 + h * i);
    helm.update(10.0 + h * i);
  }
  EXPECT_EQ(helm.order().state, HelmState::under_way) << "and it goes on when that does";
}

TEST(Helm, NavigationThatIsAheadOfAClockThatGoesOnIsStale) {
  Helm helm = under_way(10.0);
  for (int i = 1; i <= 15; ++i) {
    helm.own_fix(on_course(20.0 + h * i), 10.0 + h * i);
    helm.update(10.0 + h * i);
  }
  EXPECT_EQ(helm.order().state, HelmState::holding);
  EXPECT_EQ(helm.order().reason, "own navigation is stale");
}

TEST(Helm, AWallClockThatIsSetBackLeavesItsGoal) {
  auto with = setup();
  with.wall_clock = true;
  Helm helm = under_way(10.0, with);
  helm.neighbour_fix(VehicleId{1}, on_course(10.0, {0, 20, 10}), 10.0);
  const HelmOrder& order = helm.update(8.0);
  EXPECT_EQ(order.state, HelmState::holding);
  EXPECT_EQ(order.reason, "the clock was set back");
  EXPECT_TRUE(order.in_charge);
  EXPECT_EQ(order.request.surge_mps, 0.0);
  EXPECT_FALSE(helm.report(8.0).neighbours[0].heard) << "its time is of another clock";
  for (int i = 1; i <= 13; ++i) {
    helm.own_fix(on_course(8.0 + h * i), 8.0 + h * i);
    EXPECT_EQ(helm.update(8.0 + h * i).state, i < 11 ? HelmState::holding : HelmState::under_way) << i;
  }
  EXPECT_EQ(helm.goal(), (Vec3{500, 0, 10}));
  EXPECT_EQ(helm.report(9.3).clock_restarts, 1);
}

}  // namespace
}  // namespace fairway
