// SPDX-License-Identifier: Apache-2.0
#include "fairway/onboard/helm.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "fairway/core/testing/allocations.hpp"
#include "fairway/onboard/testing/fixes.hpp"

namespace fairway {
namespace {

using fixes::h;
using fixes::helm_of;
using fixes::infinity;
using fixes::nan;
using fixes::on_course;
using fixes::setup;
using fixes::under_way;

bool is_zero(const BodyRequest& r) {
  return r.surge_mps == 0.0 && r.sway_mps == 0.0 && r.heave_mps == 0.0 && r.yaw_rate_radps == 0.0;
}

TEST(Helm, WaitsForNavigationIdlesWithoutAGoalAndThenGoes) {
  Helm helm = helm_of(setup());
  EXPECT_EQ(helm.update(0.0).state, HelmState::waiting);
  EXPECT_FALSE(helm.order().in_charge);
  helm.own_fix(on_course(0.1), 0.1);
  EXPECT_EQ(helm.update(0.1).state, HelmState::idle);
  EXPECT_FALSE(helm.order().in_charge);
  ASSERT_TRUE(helm.go_to({500, 0, 10}, 0.5));
  const HelmOrder& order = helm.update(0.1);
  EXPECT_EQ(order.state, HelmState::under_way);
  EXPECT_TRUE(order.in_charge && order.decided);
  EXPECT_NEAR(order.request.surge_mps, 0.5, 1e-9);
  helm.stand_by();
  EXPECT_FALSE(helm.update(0.2).in_charge);
}

TEST(Helm, DecidesEveryPeriodAndSteersInBetween) {
  auto with = setup();
  with.period = 0.4;
  Helm helm = helm_of(with);
  helm.go_to({500, 0, 10}, 0.5);
  int decided = 0;
  for (int i = 0; i < 400; ++i) {
    helm.own_fix(on_course(h * i), h * i);
    const HelmOrder& order = helm.update(h * i);
    EXPECT_EQ(order.decided, i % 4 == 0) << i;
    EXPECT_GT(order.request.surge_mps, 0.4);
    decided += order.decided ? 1 : 0;
  }
  EXPECT_EQ(decided, 100);
}

TEST(Helm, UpdatesThatComeALittleEarlyDoNotHalveTheRateOfDecisions) {
  Helm helm = helm_of(setup());
  helm.go_to({500, 0, 10}, 0.5);
  for (int i = 0; i < 1000; ++i) {
    const double time = h * i + (i % 3 == 0 ? 0.0 : -0.01 * (i % 3));
    helm.own_fix(on_course(time), time);
    helm.update(time);
  }
  EXPECT_EQ(helm.report(100).decisions, 1000);
}

TEST(Helm, BetweenFixesItReckonsWhereItIs) {
  Helm helm = under_way(1.0);
  helm.update(1.3);
  EXPECT_NEAR(helm.own().position.x(), 0.65, 1e-12);
  EXPECT_EQ(helm.order().state, HelmState::under_way);
}

TEST(Helm, HoldsWhenOwnNavigationIsStaleAndHandsBackWhenItIsLost) {
  Helm helm = under_way(10.0);
  double held = infinity;
  double handed_back = infinity;
  for (int i = 1; i <= 500; ++i) {
    const double now = 10.0 + 0.01 * i;
    const HelmOrder& order = helm.update(now);
    if (order.state == HelmState::holding && held == infinity) {
      held = now - 10.0;
      EXPECT_TRUE(is_zero(order.request));
      EXPECT_TRUE(order.in_charge);
      EXPECT_EQ(order.command.mode, Mode::hold);
      EXPECT_EQ(order.reason, "own navigation is stale");
    }
    if (order.state == HelmState::handed_back && handed_back == infinity) {
      handed_back = now - 10.0;
      EXPECT_FALSE(order.in_charge);
      EXPECT_TRUE(is_zero(order.request));
      EXPECT_EQ(order.reason, "own navigation is lost");
    }
  }
  EXPECT_NEAR(held, 0.5, 0.011) << "own_stale_s";
  EXPECT_NEAR(handed_back, 3.0, 0.011) << "own_lost_s";
}

TEST(Helm, TakesControlAgainAfterGoodDataForLongEnough) {
  for (const double gap : {1.0, 5.0}) {
    Helm helm = under_way(10.0);
    helm.update(10.0 + gap);
    const HelmState meanwhile = gap < 3.0 ? HelmState::holding : HelmState::handed_back;
    EXPECT_EQ(helm.order().state, meanwhile);
    double taken = infinity;
    for (int i = 0; i < 30; ++i) {
      const double now = 10.0 + gap + h * i;
      helm.own_fix(on_course(now), now);
      const HelmOrder& order = helm.update(now);
      if (order.state == HelmState::under_way) taken = std::fmin(taken, now - 10.0 - gap);
      EXPECT_EQ(order.state, taken == infinity ? meanwhile : HelmState::under_way) << i;
    }
    EXPECT_NEAR(taken, 1.0, 0.11) << "recovery_s, after a gap of " << gap;
  }
}

TEST(Helm, OneBadFixAmongGoodOnesIsPassedOver) {
  Helm helm = under_way(10.0);
  for (int i = 1; i <= 50; ++i) {
    const double now = 10.0 + h * i;
    Fix fix = on_course(now);
    if (i == 20) fix.state.p_n.x() = nan;
    EXPECT_EQ(helm.own_fix(fix, now), i == 20 ? FixVerdict::invalid : FixVerdict::accepted);
    EXPECT_EQ(helm.update(now).state, HelmState::under_way) << i;
  }
  EXPECT_EQ(helm.report(15).own_counts[static_cast<std::size_t>(FixVerdict::invalid)], 1);
}

TEST(Helm, FrozenNavigationEndsInAHold) {
  Helm helm = under_way(10.0);
  double held = infinity;
  for (int i = 1; i <= 60 && held == infinity; ++i) {
    const double now = 10.0 + h * i;
    helm.own_fix(fixes::north(now, on_course(10.0).state.p_n), now);
    if (helm.update(now).state == HelmState::holding) held = now - 10.0;
  }
  EXPECT_NEAR(held, 2.5, 0.11) << "frozen_s, and then own_stale_s";
}

TEST(Helm, NavigationThatRunsBackwardsOrAheadEndsInAHold) {
  for (const double offset : {-5.0, 5.0}) {
    Helm helm = under_way(10.0);
    for (int i = 1; i <= 6; ++i) {
      const double now = 10.0 + h * i;
      const FixVerdict verdict = helm.own_fix(on_course(now + offset), now);
      EXPECT_EQ(verdict, offset < 0 ? FixVerdict::backwards : FixVerdict::ahead);
      helm.update(now);
    }
    EXPECT_EQ(helm.order().state, HelmState::holding);
  }
}

TEST(Helm, ArrivedItHoldsWhereItIsIsLastOfAllAndGoesOnWhenTold) {
  Helm helm = helm_of(setup());
  helm.go_to({5, 0, 10}, 0.5);
  for (int i = 0; i <= 90; ++i) {
    helm.own_fix(on_course(h * i), h * i);
    helm.update(h * i);
    EXPECT_EQ(helm.order().state, i < 80 ? HelmState::under_way : HelmState::arrived) << i;
  }
  EXPECT_LT(helm.order().request.surge_mps, 0.0) << "back to where it arrived";
  EXPECT_FALSE(helm.goal());
  const Message told = decode(*helm.own_record(9.0), Tick{200}, 0.05);
  EXPECT_EQ(told.priority, std::numeric_limits<std::int32_t>::max());
  EXPECT_FALSE(told.destination);
  ASSERT_TRUE(helm.go_to({50, 0, 10}, 0.5));
  EXPECT_EQ(helm.update(9.1).state, HelmState::under_way);
  EXPECT_EQ(helm.own().priority, 0);
}

TEST(Helm, ASectionIsFollowedByTheVelocityOfItsLine) {
  Helm helm = helm_of(setup(), "direct");
  const Leg leg{.kind = LegKind::section, .position = {40, 0, 10}, .from = {0, 0, 10}, .speed_mps = 0.5};
  ASSERT_TRUE(helm.follow(leg));
  const Fix fix = fixes::north(0.0, {10, 2, 10});
  helm.own_fix(fix, 0.0);
  const Ownship own{.position = fix.state.p_n};
  EXPECT_EQ(helm.update(0.0).command.velocity, follow_section(leg, own).velocity);
  EXPECT_LT(helm.order().command.velocity.y(), 0.0) << "back to the line";
}

TEST(Helm, OutsideTheDepthBandEveryOrderLeadsBack) {
  auto with = setup();
  with.ship.limits.edit().min_depth = 5.0;
  with.ship.limits.edit().max_depth = 20.0;
  with.ship.limits.edit().max_climb_rate = 0.2;
  for (const double depth : {2.0, 23.0}) {
    const double back = depth < 10 ? 1.0 : -1.0;
    for (const char* algorithm : {"direct", "apf", "orca3d", "orca2d", "orca3d+stop_and_wait"}) {
      Helm helm = helm_of(with, algorithm);
      helm.own_fix(fixes::north(0.0, {0, 0, depth}), 0.0);
      // where stop-and-wait waits
      helm.neighbour_fix(VehicleId{1}, fixes::north(0.0, {3, 3, depth}, 0.0), 0.0);
      ASSERT_TRUE(helm.go_to({500, 0, back > 0 ? 5.0 : 20.0}, 0.5));
      EXPECT_NEAR(back * helm.update(0.0).request.heave_mps, 0.2, 0.11) << algorithm << " at " << depth;
      helm.keep_position();
      helm.own_fix(fixes::north(0.1, {0, 0, depth}), 0.1);
      EXPECT_GT(back * helm.update(0.1).request.heave_mps, 0.2) << "holding at " << depth;
    }
  }
}

TEST(Helm, AVehicleThatIsTooDeepOrTooShallowComesBackOnItsWay) {
  auto with = setup();
  with.ship.limits.edit().min_depth = 5.0;
  with.ship.limits.edit().max_depth = 20.0;
  for (const double depth : {2.0, 23.0}) {
    Helm helm = helm_of(with);
    ASSERT_TRUE(helm.go_to({500, 0, 12}, 0.5));
    Vec3 at{0, 0, depth};
    for (int i = 0; i < 300; ++i) {
      helm.own_fix({.time = h * i, .state = {.p_n = at}}, h * i);
      at += h * helm.update(h * i).command.velocity;
    }
    EXPECT_TRUE(at.z() > 4.99 && at.z() < 20.01) << depth << " became " << at.z();
    EXPECT_GT(at.x(), 10.0);
  }
}

TEST(Helm, AGoalOutsideTheDepthBandIsRefusedUnlessItCanBeReachedFromWithin) {
  auto with = setup();
  with.ship.limits.edit().max_depth = 20.0;
  Helm helm = helm_of(with);
  EXPECT_FALSE(helm.go_to({50, 0, 21.5}, 0.5));
  EXPECT_TRUE(helm.go_to({50, 0, 20.5}, 0.5)) << "arrival is at 1 m";
}

TEST(Helm, AVehicleThatCannotStopHoldsInACircle) {
  auto with = setup();
  with.ship.steering =
      SteeringParams{.kind = SteeringKind::crab, .min_speed_mps = 0.8, .circle_radius_m = 20.0};
  with.ship.limits.edit().max_speed = 1.5;
  Helm helm = under_way(1.0, with);
  EXPECT_GE(helm.order().request.surge_mps, 0.8);
  helm.keep_position();
  helm.own_fix(on_course(1.1), 1.1);
  EXPECT_EQ(helm.update(1.1).state, HelmState::keeping);
  EXPECT_NEAR(helm.order().request.surge_mps, 0.8, 1e-9);
  EXPECT_GT(helm.order().request.yaw_rate_radps, 0.0) << "to starboard";
  const HelmOrder& blind = helm.update(2.0);
  EXPECT_EQ(blind.state, HelmState::holding);
  EXPECT_NEAR(blind.request.surge_mps / blind.request.yaw_rate_radps, 20.0, 1e-9) << "the circle's radius";
}

TEST(Helm, EstimatesTheCurrentFromTheVelocityThroughTheWaterAndFiltersIt) {
  auto with = setup();
  with.ship.steering = SteeringParams{.kind = SteeringKind::crab, .min_speed_mps = 0.1};
  Helm helm = helm_of(with, "direct");
  helm.go_to({500, 0, 10}, 0.5);
  const auto surge_at = [&](int instant, std::optional<double> through_water) {
    Fix fix = on_course(h * instant);
    if (through_water) fix.through_water_b = Vec3{*through_water, 0, 0};
    EXPECT_EQ(helm.own_fix(fix, fix.time), FixVerdict::accepted);
    return helm.update(fix.time).request.surge_mps;
  };
  EXPECT_NEAR(surge_at(0, {}), 0.5, 1e-9) << "in still water, as far as it knows";
  EXPECT_NEAR(surge_at(1, 0.7), 0.7, 1e-9) << "against 0.2 m/s, which it takes as it is told first";
  EXPECT_NEAR(surge_at(2, {}), 0.7, 1e-9) << "kept while it is told nothing";
  double surge{};
  for (int i = 3; i <= 101; ++i) surge = surge_at(i, 0.5);
  EXPECT_NEAR(surge, 0.5 + 0.2 * std::exp(-1.0), 1e-9) << "10 s later, the time constant of the filter";
  helm.update(0.0);
  helm.go_to({500, 0, 10}, 0.5);
  EXPECT_NEAR(surge_at(0, {}), 0.5, 1e-9) << "forgotten by a clock that begins again";
}

TEST(Helm, NoOrderTurnsFasterThanTheLimit) {
  fixes::Parts with = setup();
  with.ship.limits.edit().max_turn_rate = 0.05;
  Helm helm = helm_of(with);
  helm.own_fix(on_course(0.0), 0.0);
  ASSERT_TRUE(helm.go_to({-500, 10, 10}, 0.5));
  EXPECT_EQ(std::fabs(helm.update(0.0).request.yaw_rate_radps), 0.05);
}

TEST(Helm, ALegWithoutAnArrivalIsRefused) {
  Helm helm = helm_of(setup());
  for (const double arrival : {nan, infinity, 0.0, -1.0})
    EXPECT_FALSE(
        helm.follow({.position = {50, 0, 10}, .from = {0, 0, 10}, .speed_mps = 0.5, .arrival_m = arrival}))
        << arrival;
}

TEST(Helm, ACopyIsASnapshot) {
  Helm helm = under_way(5.0);
  Helm copy = helm;
  for (int i = 51; i < 200; ++i) {
    const double now = h * i;
    for (Helm* each : {&helm, &copy}) {
      each->own_fix(on_course(now), now);
      each->neighbour_fix(VehicleId{1}, on_course(now, {60, 1, 10}, -0.5), now);
      each->update(now);
    }
    ASSERT_EQ(helm.order().command, copy.order().command) << now;
  }
}

TEST(Helm, NothingAllocatesWhateverComesIn) {
  auto with = setup();
  with.policy.jump_confirmations_count = 2;
  for (const LostPolicy lost : {LostPolicy::inflate, LostPolicy::hold, LostPolicy::forget}) {
    with.policy.neighbour_lost = lost;
    Helm helm = helm_of(with, "orca3d+stop_and_wait");
    const TeamRecord record = encode({.from = VehicleId{1}, .sent = Tick{80}, .position = {9, 9, 9}}, 0.05);
    std::array<bool, EnumNames<FixVerdict>::names.size()> seen{};
    std::array<bool, EnumNames<HelmState>::names.size()> been{};
    const auto note = [&](FixVerdict verdict) { seen[static_cast<std::size_t>(verdict)] = true; };

    const long before = allocation_count();
    for (int i = 0; i < 1000; ++i) {
      const double now = h * i;
      Fix fix = on_course(now);
      if (i % 50 == 7) fix.state.p_n.y() = nan;
      if (i % 50 == 9) fix.state.p_n.y() += 50.0;
      if (i % 50 == 11) fix.time -= 1.0;
      if (i % 50 == 13) fix.time += 1.0;
      if (i > 200 && i < 240) fix.state.p_n = on_course(20.0).state.p_n;
      if (i < 300 || i > 350) note(helm.own_fix(fix, now));
      fix.state.p_n.y() += 20.0;
      if (i < 500) note(helm.neighbour_fix(VehicleId{1}, fix, now));
      if (i == 80) helm.team_record(record, now);
      if (i == 100) helm.keep_position();
      if (i == 20 || i == 110) helm.go_to({500, 0, 10}, 0.5);
      if (i == 900) helm.follow({.kind = LegKind::section, .position = {46, 0, 10}, .from = {40, 0, 10}});
      helm.neighbour_goal(VehicleId{1}, Vec3{100, 20, 10});
      been[static_cast<std::size_t>(helm.update(now).state)] = true;
      (void)helm.own_record(now);
      (void)helm.common_time();
    }
    EXPECT_EQ(allocation_count(), before);
    for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_TRUE(seen[i]) << EnumNames<FixVerdict>::names[i];
    helm.update(100.0);
    for (const HelmState state : {HelmState::idle, HelmState::under_way, HelmState::keeping,
                                  HelmState::holding, HelmState::handed_back, HelmState::arrived}) {
      EXPECT_TRUE(been[static_cast<std::size_t>(state)]) << enum_name(state);
    }
  }
}

}  // namespace
}  // namespace fairway
