// SPDX-License-Identifier: Apache-2.0
// What a helm makes of others, and what it tells them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fairway/onboard/testing/fixes.hpp"

namespace fairway {
namespace {

using fixes::h;
using fixes::helm_of;
using fixes::infinity;
using fixes::on_course;
using fixes::setup;
using fixes::under_way;

TEST(HelmInATeam, ANeighbourIsPredictedByItsVelocityAndGrowsWhenItIsStale) {
  Helm helm = under_way(0.0);
  Fix fix = on_course(0.0, {30, 20, 10}, 0.4);
  helm.neighbour_fix(VehicleId{1}, fix, 0.0);
  for (int i = 1; i <= 600; ++i) {
    const double now = h * i;
    helm.own_fix(on_course(now), now);
    helm.update(now);
    const HelmReport::Neighbour one = helm.report(now).neighbours[0];
    const double reckoned = 30 + 0.4 * std::fmin(now, 30.0);
    EXPECT_NEAR(one.distance, std::hypot(reckoned - 0.5 * now, 20.0), 1e-9) << now;
    EXPECT_NEAR(one.growth, std::clamp(0.25 * (now - 1.0), 0.0, 10.0), 1e-9) << now;
    EXPECT_EQ(one.stale, now > 1.0) << now;
    EXPECT_EQ(one.lost, now > 30.0) << now;
    EXPECT_TRUE(one.shown);
  }
}

TEST(HelmInATeam, WhoStandsBeforeAMateThatStandsTooIsDeadlockedAndSaysSo) {
  Helm helm = helm_of(setup());
  helm.go_to({500, 0, 10}, 0.5);
  const Fix stands{.time = 0.0, .state = {.p_n = {0, 0, 10}}};
  const auto update_until = [&](double until, double from, double mate_speed) {
    for (double now = from; now < until; now += h) {
      Fix own = stands, mate = on_course(now - from, {3.5, 0, 10}, mate_speed);
      own.time = mate.time = now;
      helm.own_fix(own, now);
      helm.neighbour_fix(VehicleId{1}, mate, now);
      helm.update(now);
    }
    return helm.order().progress;
  };
  EXPECT_EQ(update_until(30.0, 0.0, 0.0).state, Headway::making);
  const ProgressReport stuck = update_until(31.0, 30.0, 0.0);
  EXPECT_EQ(stuck.state, Headway::deadlocked);
  EXPECT_EQ(stuck.with, TrackId{1});
  EXPECT_EQ(stuck.last_progress, 0.0);
  EXPECT_EQ(helm.report(31.0).order.progress.state, Headway::deadlocked);
  EXPECT_EQ(update_until(35.0, 31.0, 0.5).state, Headway::waiting) << "the mate moves on";
  EXPECT_EQ(update_until(50.0, 35.0, 0.5).state, Headway::trapped) << "it has gone, and did not hinder";

  helm.keep_position();
  EXPECT_EQ(helm.update(50.1).progress.state, Headway::holding);
}

TEST(HelmInATeam, ALostNeighbourIsInflatedHeldForOrForgotten) {
  for (const LostPolicy lost : {LostPolicy::inflate, LostPolicy::hold, LostPolicy::forget}) {
    auto with = setup();
    with.policy.neighbour_lost = lost;
    Helm helm = under_way(0.0, with);
    helm.neighbour_fix(VehicleId{1}, on_course(0.0, {0, 20, 10}), 0.0);
    for (int i = 1; i <= 310; ++i) {
      helm.own_fix(on_course(h * i), h * i);
      const HelmState state = helm.update(h * i).state;
      const bool holds = lost == LostPolicy::hold && i > 300;
      EXPECT_EQ(state, holds ? HelmState::holding : HelmState::under_way) << i;
    }
    const HelmReport report = helm.report(31.0);
    EXPECT_TRUE(report.neighbours[0].lost);
    EXPECT_EQ(report.order.reason, lost == LostPolicy::hold ? "a neighbour is lost" : "");
    EXPECT_NE(report.neighbours[0].shown, lost == LostPolicy::forget);

    // heard again it is as before
    helm.own_fix(on_course(31.1), 31.1);
    helm.neighbour_fix(VehicleId{1}, on_course(31.1, {0, 20, 10}), 31.1);
    EXPECT_EQ(helm.update(31.1).state, HelmState::under_way);
    EXPECT_EQ(helm.report(31.1).neighbours[0].growth, 0.0);
  }
}

TEST(HelmInATeam, ANeighbourThatWasNeverHeardIsNotThereButReported) {
  auto with = setup();
  with.policy.neighbour_lost = LostPolicy::hold;
  Helm helm = under_way(60.0, with);
  EXPECT_EQ(helm.order().state, HelmState::under_way);
  const HelmReport::Neighbour one = helm.report(60.0).neighbours[0];
  EXPECT_FALSE(one.heard || one.shown);
  EXPECT_EQ(one.age, infinity);
}

TEST(HelmInATeam, BeyondItsRangeANeighbourIsLeftOut) {
  auto with = setup();
  with.range = 30.0;
  Helm helm = under_way(0.0, with);
  for (const double east : {29.9, 30.1}) {
    helm = under_way(0.0, with);
    helm.neighbour_fix(VehicleId{1}, on_course(0.1, {0, east, 10}), 0.1);
    helm.own_fix(on_course(0.1), 0.1);
    helm.update(0.1);
    EXPECT_EQ(helm.report(0.1).neighbours[0].shown, east < 30.0);
  }
}

TEST(HelmInATeam, AStrangerIsIgnored) {
  Helm helm = under_way(1.0);
  EXPECT_EQ(helm.neighbour_fix(VehicleId{7}, on_course(1.0), 1.0), FixVerdict::invalid);
  helm.neighbour_goal(VehicleId{7}, Vec3{1, 2, 3});
  EXPECT_FALSE(helm.report(1.0).neighbours[0].heard);
}

TEST(HelmInATeam, ANeighbourThatCameToItsGoalGivesWay) {
  // one has the right of way, until it has arrived
  auto with = setup();
  with.ship.priority = 5;
  with.team[0].arrival = 1.0;
  Helm helm = helm_of(with, "direct+stop_and_wait", {{"crit_dist_m", 20.0}});
  helm.go_to({500, 0, 10}, 0.5);
  helm.neighbour_goal(VehicleId{1}, Vec3{10, 5, 10});
  for (int i = 0; i <= 40; ++i) {
    const double now = h * i;
    helm.own_fix(fixes::north(now, {0, 0, 10}, 0.0), now);
    helm.neighbour_fix(VehicleId{1}, on_course(now, {8, 5, 10}), now);  // at its goal, to a metre, after 2 s
    const Mode mode = helm.update(now).command.mode;
    EXPECT_EQ(mode, now < 2.05 ? Mode::hold : Mode::cruise) << now;
    if (i == 30) helm.neighbour_goal(VehicleId{1}, std::nullopt);
  }
  helm.neighbour_goal(VehicleId{1}, Vec3{50, 5, 10});
  EXPECT_EQ(helm.update(4.1).command.mode, Mode::hold) << "with another goal it goes first again";
}

TEST(HelmInATeam, ANeighbourThatLeavesItsGoalHasNotArrivedThereAnyMore) {
  auto with = setup();
  with.ship.priority = 5;
  with.team[0].arrival = 1.0;
  for (const bool falls_silent : {false, true}) {
    Helm helm = helm_of(with, "direct+stop_and_wait", {{"crit_dist_m", 20.0}});
    helm.go_to({500, 0, 10}, 0.5);
    helm.neighbour_goal(VehicleId{1}, Vec3{10, 5, 10});
    const auto mode_beside = [&](double now, double north) {
      helm.own_fix(fixes::north(now, {0, 0, 10}, 0.0), now);
      helm.neighbour_fix(VehicleId{1}, fixes::north(now, {north, 5, 10}, 0.0), now);
      return helm.update(now).command.mode;
    };
    mode_beside(0.1, 10.0);
    if (falls_silent) helm.neighbour_goal(VehicleId{1}, std::nullopt);
    EXPECT_EQ(mode_beside(0.2, 10.0), Mode::cruise) << "it is at its goal";
    EXPECT_EQ(mode_beside(0.3, 11.2), Mode::cruise) << "it drifts about it";
    EXPECT_EQ(mode_beside(0.4, 12.4), Mode::hold) << "it has gone on, wherever to";
  }
}

TEST(HelmInATeam, ATeamRecordIsAFixWithPriorityRadiusAndGoal) {
  Helm helm = under_way(1.0);
  const Message message{.from = VehicleId{1},
                        .sent = Tick{20},
                        .position = {10, 20, 5},
                        .velocity = {0.3, 0, 0},
                        .radius = 2.0,
                        .priority = -3,
                        .destination = Vec3{50, 20, 5}};
  const TeamRecord record = encode(message, 0.05);
  EXPECT_EQ(helm.team_record(record, 1.5), FixVerdict::accepted);
  EXPECT_EQ(helm.team_record(record, 1.5), FixVerdict::backwards);
  EXPECT_EQ(helm.team_record(std::span{record}.first(24), 1.5), FixVerdict::invalid);
  TeamRecord stranger = encode({.from = VehicleId{9}, .sent = Tick{21}}, 0.05);
  EXPECT_EQ(helm.team_record(stranger, 1.5), FixVerdict::invalid);
  helm.own_fix(on_course(1.5), 1.5);
  helm.update(1.5);
  const HelmReport report = helm.report(1.5);
  EXPECT_EQ(report.records_refused, 2);
  EXPECT_NEAR(report.neighbours[0].age, 0.5, 1e-9);
  EXPECT_NEAR(report.neighbours[0].distance, (Vec3{10.15, 20, 5} - helm.own().position).norm(), 0.02);
}

TEST(HelmInATeam, RecordsPassByAClockThatCountsFrom1970) {
  constexpr double today = 1.78e9;
  Helm helm = helm_of(setup());
  helm.own_fix(fixes::north(today, {0, 0, 10}), today);
  const std::optional<TeamRecord> own = helm.own_record(today);
  ASSERT_TRUE(own);
  const Tick now{std::llround(today / 0.05)};
  EXPECT_NEAR(static_cast<double>(count(decode(*own, now, 0.05).sent) - count(now)), 0.0, 1.0);
  const TeamRecord other = encode({.from = VehicleId{1}, .sent = now, .position = {9, 9, 9}}, 0.05);
  EXPECT_EQ(helm.team_record(other, today), FixVerdict::accepted);
  EXPECT_NEAR(helm.report(today).neighbours[0].age, 0.0, 0.05);
}

TEST(HelmInATeam, ARecordOfAClockThatIsALittleAheadIsOfNow) {
  Helm helm = under_way(10.0);
  const TeamRecord record = encode({.from = VehicleId{1}, .sent = Tick{202}, .position = {9, 9, 9}}, 0.05);
  EXPECT_EQ(helm.team_record(record, 10.0), FixVerdict::accepted);
  EXPECT_NEAR(helm.report(10.0).neighbours[0].age, -0.1, 1e-9);
}

TEST(HelmInATeam, ARecordOfAClockThatIsTooFarAheadIsRefusedAndNotTakenForOld) {
  Helm helm = under_way(10.0);
  const TeamRecord record = encode({.from = VehicleId{1}, .sent = Tick{206}, .position = {9, 9, 9}}, 0.05);
  EXPECT_EQ(helm.team_record(record, 10.0), FixVerdict::ahead);
  EXPECT_FALSE(helm.report(10.0).neighbours[0].heard);
}

TEST(HelmInATeam, APlaceThatARecordCannotTellIsNeitherToldNorBelieved) {
  for (const double north : {83'000.0, 84'000.0, -4.6e6}) {
    Helm helm = helm_of(setup());
    helm.own_fix(fixes::north(1.0, {north, 0, 10}), 1.0);
    helm.update(1.0);
    const bool is_near = std::fabs(north) < 83'886.0;
    EXPECT_EQ(helm.own_record(1.0).has_value(), is_near) << north;
    const TeamRecord other =
        encode({.from = VehicleId{1}, .sent = Tick{20}, .position = {north, 9, 9}}, 0.05);
    EXPECT_EQ(helm.team_record(other, 1.0), is_near ? FixVerdict::accepted : FixVerdict::invalid) << north;
  }
}

TEST(HelmInATeam, WhoIsAsLargeAsARecordTellsAtMostIsAsLargeAsWasKnownBefore) {
  auto with = setup();
  with.team[0].radius = 80.0;
  Helm helm = helm_of(with, "orca3d", {{"crit_dist_m", 200.0}});
  helm.go_to({500, 0, 10}, 0.5);
  const Message message{.from = VehicleId{1}, .sent = Tick{20}, .position = {60, 0, 10}, .radius = 80.0};
  helm.team_record(encode(message, 0.05), 1.0);
  helm.own_fix(on_course(1.1), 1.1);
  EXPECT_EQ(helm.update(1.1).command.mode, Mode::infeasible) << "it lies within that sphere";
}

TEST(HelmInATeam, WhatItTellsIsItsLastFixStampedWithThatFixesTime) {
  Helm helm = under_way(10.0);
  const Message told = decode(*helm.own_record(11.0), Tick{220}, 0.05);
  EXPECT_EQ(count(told.sent), 200);
  EXPECT_NEAR((told.position - on_course(10.0).state.p_n).norm(), 0.0, 0.01);
  EXPECT_TRUE(told.destination);
  EXPECT_FALSE(helm.own_record(13.5)) << "lost, and not told any more";
}

TEST(HelmInATeam, KnowsTheInstantOfWhichEveryoneWasHeard) {
  Helm helm = helm_of(setup());
  EXPECT_EQ(helm.common_time(), -infinity);
  helm.own_fix(on_course(0.2), 0.2);
  EXPECT_EQ(helm.common_time(), -infinity);
  helm.neighbour_fix(VehicleId{1}, on_course(0.1, {0, 20, 10}), 0.2);
  EXPECT_EQ(helm.common_time(), 0.1);
}

}  // namespace
}  // namespace fairway
