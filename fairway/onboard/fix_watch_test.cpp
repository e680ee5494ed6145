// SPDX-License-Identifier: Apache-2.0
#include "fairway/onboard/fix_watch.hpp"

#include <gtest/gtest.h>

#include "fairway/onboard/testing/fixes.hpp"

namespace fairway {
namespace {

using fixes::infinity;
using fixes::nan;
using fixes::north;
using fixes::on_course;
using enum FixVerdict;

const OnboardPolicy policy;

/// That has seen a vehicle on its course ten times a second up to and with `until` [s].
FixWatch watch_until(double until) {
  FixWatch watch;
  for (int i = 0; 0.1 * i <= until + 1e-9; ++i) watch.see(on_course(0.1 * i), 0.1 * i, policy);
  return watch;
}

TEST(FixWatch, BeforeTheFirstFixNothingIsKnown) {
  const FixWatch watch;
  EXPECT_FALSE(watch.last());
  EXPECT_EQ(watch.age(5.0), infinity);
  EXPECT_EQ(watch.good_since(), infinity);
  EXPECT_EQ(watch.refused_at(), -infinity);
}

TEST(FixWatch, GoodFixesAreAcceptedAndTheLastOneKept) {
  const FixWatch watch = watch_until(1.0);
  EXPECT_EQ(watch.count(accepted), 11);
  EXPECT_EQ(watch.last()->state.p_n, on_course(1.0).state.p_n);
  EXPECT_NEAR(watch.age(1.3), 0.3, 1e-12);
  EXPECT_EQ(watch.good_since(), 0.0);
}

TEST(FixWatch, WhatIsNotANumberOrNoAttitudeOrAbsurdIsInvalid) {
  const auto broken = [](auto&& change) {
    Fix fix = on_course(1.1);
    change(fix);
    FixWatch watch = watch_until(1.0);
    const FixVerdict verdict = watch.see(fix, 1.1, policy);
    EXPECT_EQ(watch.last()->time, watch_until(1.0).last()->time) << "it changes nothing but a count";
    EXPECT_EQ(watch.count(verdict), verdict == accepted ? 12 : 1);
    return verdict;
  };
  EXPECT_EQ(broken([](Fix& f) { f.time = nan; }), invalid);
  EXPECT_EQ(broken([](Fix& f) { f.state.p_n.y() = nan; }), invalid);
  EXPECT_EQ(broken([](Fix& f) { f.state.v_b.z() = infinity; }), invalid);
  EXPECT_EQ(broken([](Fix& f) { f.state.omega_b.x() = nan; }), invalid);
  EXPECT_EQ(broken([](Fix& f) { f.state.q_nb.coeffs() *= 1.002; }), invalid);
  EXPECT_EQ(broken([](Fix& f) { f.state.q_nb.coeffs().setZero(); }), invalid);
  EXPECT_EQ(broken([](Fix& f) { f.state.p_n.x() = 1e9; }), invalid);
  EXPECT_EQ(broken([](Fix& f) { f.state.v_b.x() = 1e300; }), invalid);
  EXPECT_EQ(broken([](Fix& f) { f.through_water_b = Vec3{0, nan, 0}; }), invalid);
  EXPECT_EQ(broken([](Fix& f) { f.through_water_b = Vec3{1e300, 0, 0}; }), invalid);
  EXPECT_EQ(broken([](Fix& f) { f.position_sigma = nan; }), invalid);
  EXPECT_EQ(broken([](Fix& f) { f.position_sigma = -0.1; }), invalid);
}

TEST(FixWatch, AnAttitudeThatIsUnitToWithinAThousandthIsOne) {
  FixWatch watch = watch_until(1.0);
  Fix fix = on_course(1.1);
  fix.state.q_nb.coeffs() *= 1.0009;
  EXPECT_EQ(watch.see(fix, 1.1, policy), accepted);
}

TEST(FixWatch, AnEarlierOrEqualTimeIsBackwardsAndALaterOneThanTheClockAhead) {
  FixWatch watch = watch_until(1.0);
  EXPECT_EQ(watch.see(on_course(0.9), 1.1, policy), backwards);
  EXPECT_EQ(watch.see(*watch.last(), 1.1, policy), backwards);
  EXPECT_EQ(watch.see(on_course(1.1 + policy.max_ahead_s + 0.01), 1.1, policy), ahead);
  EXPECT_EQ(watch.see(on_course(1.1 + policy.max_ahead_s - 0.01), 1.1, policy), accepted);
}

TEST(FixWatch, OneJumpIsRefused) {
  FixWatch watch = watch_until(1.0);
  Fix away = on_course(1.1);
  away.state.p_n.y() += 20.0;
  EXPECT_EQ(watch.see(away, 1.1, policy), jumped);
  EXPECT_EQ(watch.see(on_course(1.2), 1.2, policy), accepted);
  EXPECT_EQ(watch.refused_at(), 1.1);
}

TEST(FixWatch, AJumpIsFartherThanTheAllowanceAndTheSpeedMakePossible) {
  // from where it is expected 0.1 s later: 1 m and 3 m/s for 0.1 s
  for (const double distance : {1.29, 1.31}) {
    FixWatch watch = watch_until(1.0);
    Fix away = on_course(1.1);
    away.state.p_n.y() += distance;
    EXPECT_EQ(watch.see(away, 1.1, policy), distance < 1.3 ? accepted : jumped) << distance;
  }
}

TEST(FixWatch, AfterAGapAVehicleMayBeFarther) {
  FixWatch watch = watch_until(1.0);
  Fix away = on_course(5.0);
  away.state.p_n.y() += 12.9;  // 1 m + 3 m/s x 4 s
  EXPECT_EQ(watch.see(away, 5.0, policy), accepted);
}

TEST(FixWatch, AsManyJumpsAsItTakesThatAgreeAreBelieved) {
  FixWatch watch = watch_until(1.0);
  for (int i = 1; i <= policy.jump_confirmations_count; ++i) {
    const double time = 1.0 + 0.1 * i;
    const FixVerdict verdict = watch.see(on_course(time, {0, 50, 10}), time, policy);
    EXPECT_EQ(verdict, i < policy.jump_confirmations_count ? jumped : accepted) << i;
  }
  EXPECT_EQ(watch.last()->state.p_n.y(), 50.0);
  EXPECT_EQ(watch.see(on_course(1.6, {0, 50, 10}), 1.6, policy), accepted);
  EXPECT_EQ(watch.see(on_course(1.7), 1.7, policy), jumped) << "the old place is the jump now";
}

TEST(FixWatch, JumpsThatDoNotAgreeAreNeverBelieved) {
  FixWatch watch = watch_until(1.0);
  for (int i = 1; i <= 100; ++i) {
    const double time = 1.0 + 0.02 * i;
    EXPECT_EQ(watch.see(on_course(time, {0, 50.0 * i, 10}), time, policy), jumped) << i;
  }
}

TEST(FixWatch, AJumpToldTwiceIsNoConfirmation) {
  FixWatch watch = watch_until(1.0);
  const Fix away = on_course(1.1, {0, 50, 10});
  EXPECT_EQ(watch.see(away, 1.1, policy), jumped);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(watch.see(away, 1.1, policy), backwards);
}

TEST(FixWatch, TheSamePositionToTheBitForTooLongIsFrozenIfItSaysThatItMoves) {
  FixWatch watch = watch_until(1.0);
  const Vec3 stuck = watch.last()->state.p_n;
  int taken = 0;
  double refused = infinity;
  for (int i = 1; i <= 40; ++i) {
    const double time = 1.0 + 0.1 * i;
    const FixVerdict verdict = watch.see(north(time, stuck), time, policy);
    if (verdict == frozen) refused = std::fmin(refused, time);
    taken += verdict == accepted ? 1 : 0;
  }
  EXPECT_NEAR(refused, 1.0 + policy.frozen_s, 0.11);
  EXPECT_EQ(watch.count(frozen), 40 - taken);
  EXPECT_EQ(watch.see(north(5.1, stuck + Vec3{0.01, 0, 0}), 5.1, policy), accepted) << "it moves again";
}

TEST(FixWatch, AFrozenPositionIsNotBelievedAgainBecauseTheVehicleStopsForIt) {
  const Vec3 stuck{1, 0, 5};
  FixWatch watch;
  double time = 1.0;
  while (watch.see(north(time, stuck), time, policy) == accepted) time += 0.1;
  ASSERT_EQ(watch.verdict(), frozen);
  for (int i = 0; i < 100; ++i) {
    time += 0.1;
    EXPECT_EQ(watch.see(north(time, stuck, 0.0), time, policy), frozen);
  }
  time += 0.1;
  EXPECT_EQ(watch.see(north(time, stuck + Vec3{0.01, 0, 0}, 0.0), time, policy), accepted)
      << "it moves again";
}

TEST(FixWatch, OneClaimToMoveOfAVehicleAtRestIsNoFrozenPosition) {
  FixWatch watch;
  for (int i = 0; i < 1000; ++i)
    EXPECT_EQ(watch.see(north(0.1 * i, {0, 0, 5}, i % 10 == 0 ? 0.06 : 0.0), 0.1 * i, policy), accepted);
}

TEST(FixWatch, AVehicleAtRestMayStandForEver) {
  FixWatch watch;
  for (int i = 0; i < 1000; ++i)
    EXPECT_EQ(watch.see(north(0.1 * i, {0, 0, 5}, 0.04), 0.1 * i, policy), accepted);
}

TEST(FixWatch, GoodDataBeginAgainAfterAGapAndAfterARefusal) {
  FixWatch watch = watch_until(1.0);
  watch.see(on_course(1.0 + policy.own_stale_s + 0.1), 2.0, policy);
  EXPECT_NEAR(watch.good_since(), 1.6, 1e-12);
  watch.see(on_course(0.5), 2.0, policy);
  EXPECT_EQ(watch.good_since(), infinity);
  watch.see(on_course(1.8), 2.0, policy);
  EXPECT_NEAR(watch.good_since(), 1.8, 1e-12);
}

}  // namespace
}  // namespace fairway
