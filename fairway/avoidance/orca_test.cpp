// SPDX-License-Identifier: Apache-2.0
// What ORCA in space and in the plane have in common, with each other and with velocity obstacles.
#include <gtest/gtest.h>

#include <array>

#include "fairway/avoidance/hrvo/hrvo.hpp"
#include "fairway/avoidance/orca2d/orca2d.hpp"
#include "fairway/avoidance/orca3d/orca3d.hpp"
#include "fairway/avoidance/rvo/rvo.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/avoidance/vo/vo.hpp"

namespace fairway {
namespace {

using encounters::decide;
using encounters::OwnedSituation;

template <class>
class Orca : public ::testing::Test {};
using Orcas = ::testing::Types<Orca2d, Orca3d>;
TYPED_TEST_SUITE(Orca, Orcas);

template <class>
class ByVelocity : public ::testing::Test {};
using AllByVelocity = ::testing::Types<Orca2d, Orca3d, Vo, Rvo, Hrvo>;
TYPED_TEST_SUITE(ByVelocity, AllByVelocity);

TYPED_TEST(ByVelocity, GoesWhereItWasGoingWhenNobodyIsInRange) {
  const Command expected{.velocity = {1.0, 0.0, 0.0}, .mode = Mode::cruise};
  EXPECT_EQ(decide<TypeParam>(encounters::open_water()), expected);
  EXPECT_EQ(decide<TypeParam>(encounters::head_on(20.5)), expected);
}

TYPED_TEST(ByVelocity, SomebodyInRangeIsAvoidanceEvenIfTheCourseIsClear) {
  OwnedSituation e = encounters::open_water();
  e.tracks = {encounters::track(1, {-19.0, 0.0, 50.0}, {-1.0, 0.0, 0.0})};
  const Command command = decide<TypeParam>(e);
  EXPECT_EQ(command.velocity, Vec3(1.0, 0.0, 0.0));
  EXPECT_EQ(command.mode, Mode::avoid);
  EXPECT_TRUE(command.astern);
}

TYPED_TEST(Orca, HeadOnTakesHalfOfTheLeastChangeToStarboard) {
  // p = 8 north, v = 2 north, R = 2: sin 1/4, cos sqrt(15)/4. The change is u = sin * 2 along the normal
  // (-sin, cos, 0); half of it is 1/4, and the preferred velocity (1, 0, 0) lies 1/4 beyond the plane
  const Command command = decide<TypeParam>(encounters::head_on(8.0));
  const Vec3 normal{-0.25, std::sqrt(15.0) / 4.0, 0.0};
  EXPECT_LT((command.velocity - (Vec3(1.0, 0.0, 0.0) + 0.25 * normal)).norm(), 1e-14);
  EXPECT_EQ(command.mode, Mode::avoid);
}

TYPED_TEST(Orca, FullResponsibilityTakesAllOfTheChange) {
  const Command command = decide<TypeParam>(encounters::head_on(8.0), {.responsibility_ratio = 1.0});
  const Vec3 normal{-0.25, std::sqrt(15.0) / 4.0, 0.0};
  EXPECT_LT((command.velocity - (Vec3(1.0, 0.0, 0.0) + 0.5 * normal)).norm(), 1e-14);
}

TYPED_TEST(Orca, WhatDoesNotReactLeavesAllOfTheChangeToUs) {
  OwnedSituation e = encounters::head_on(8.0);
  const Command shared = decide<TypeParam>(e);
  e.tracks[0].reacts = false;
  EXPECT_EQ(decide<TypeParam>(e), decide<TypeParam>(encounters::head_on(8.0), {.responsibility_ratio = 1.0}));
  EXPECT_EQ(decide<TypeParam>(e), decide<TypeParam>(e, {.responsibility_ratio = 0.0}));
  EXPECT_GT((decide<TypeParam>(e).velocity - shared.velocity).norm(), 0.2);
}

TYPED_TEST(Orca, WhoOverlapsIsApartAfterThePlanningInterval) {
  // 2 m within each other at rest, one half each: 1 m in the interval, where decisions come every 0.1 s
  OwnedSituation e = encounters::open_water();
  e.situation.own.velocity = Vec3::Zero();
  e.situation.goal.velocity = Vec3::Zero();
  e.situation.limits.max_speed = 100.0;
  e.tracks = {encounters::track(1, e.situation.own.position + Vec3{0.0, 1e-3, 0.0}, Vec3::Zero())};
  EXPECT_NEAR(decide<TypeParam>(e, {.planning_interval_s = 2.0}).velocity.norm(), 0.5, 1e-3);
  EXPECT_NEAR(decide<TypeParam>(e, {.planning_interval_s = 0.5}).velocity.norm(), 2.0, 4e-3);
  EXPECT_EQ(decide<TypeParam>(e, {.planning_interval_s = e.situation.period}), decide<TypeParam>(e));
}

TYPED_TEST(ByVelocity, TwoAtTheSamePlacePartAlongOneLineByTheirIds) {
  OwnedSituation e = encounters::open_water();
  e.situation.own.velocity = Vec3::Zero();
  e.situation.goal.velocity = Vec3::Zero();
  e.tracks = {encounters::track(1, e.situation.own.position, Vec3::Zero())};
  const Command first = decide<TypeParam>(e);
  e.situation.own.id = VehicleId{1};
  e.tracks[0].id = TrackId{0};
  const Command second = decide<TypeParam>(e);
  EXPECT_GT(first.velocity.norm(), 0.9);
  EXPECT_LT((first.velocity + second.velocity).norm(), 1e-12);
}

TYPED_TEST(ByVelocity, LooksAtTheNearestWhenThereAreTooMany) {
  OwnedSituation e = encounters::head_on(8.0);
  e.tracks.push_back(encounters::track(2, {0.0, 9.0, 50.0}, {0.0, -2.0, 0.0}));
  EXPECT_EQ(decide<TypeParam>(e, {.max_neighbours_count = 1}), decide<TypeParam>(encounters::head_on(8.0)));
  EXPECT_EQ(decide<TypeParam>(e, {.max_neighbours_count = 0}).mode, Mode::cruise);
}

TEST(Orca3dTracks, BeyondThoseThatItLooksAtNobodyMatters) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    OwnedSituation e = encounters::crowd(40, Rng{seed});
    Avoider avoider{Orca3d{{.max_neighbours_count = 5}}};
    ASSERT_EQ(avoider.most_tracks(), 5U);
    const Command among_all = avoider.decide(e);
    e.tracks.resize(5);
    EXPECT_EQ(avoider.decide(e), among_all) << seed;
  }
  const Avoider leaning{Orca3d{{.max_neighbours_count = 5, .symmetry = Symmetry::starboard}}};
  EXPECT_GT(leaning.most_tracks(), 500U) << "a rule for symmetric conflicts asks all of them";
}

TYPED_TEST(Orca, FromInsideASolidTheWayIsOutThroughTheNearestSide) {
  const std::array<Vec3, 4> square{Vec3{-1, -5, 0}, Vec3{9, -5, 0}, Vec3{9, 5, 0}, Vec3{-1, 5, 0}};
  OwnedSituation e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::polygon, .vertices = square}};
  const Command command = decide<TypeParam>(e);
  EXPECT_EQ(command.mode, Mode::infeasible);  // 2 m in 0.1 s
  EXPECT_LT((command.velocity - Vec3(-1.5, 0.0, 0.0)).norm(), 1e-9);
}

}  // namespace
}  // namespace fairway
