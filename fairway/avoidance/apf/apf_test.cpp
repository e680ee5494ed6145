// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/apf/apf.hpp"

#include <gtest/gtest.h>

#include <array>

#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway {
namespace {

using encounters::decide;
using encounters::OwnedSituation;

/// Northbound with somebody at `position` relative to own ship.
OwnedSituation beside(const Vec3& position) {
  OwnedSituation e = encounters::open_water();
  e.tracks = {encounters::track(1, e.situation.own.position + position, Vec3::Zero())};
  return e;
}

TEST(Apf, GoesWhereItWasGoingWhenNobodyIsInRange) {
  const Command expected{.velocity = {1.0, 0.0, 0.0}, .mode = Mode::cruise};
  EXPECT_EQ(decide<Apf>(encounters::open_water()), expected);
  EXPECT_EQ(decide<Apf>(beside({6.001, 0.0, 0.0})), expected);
}

TEST(Apf, RepulsionGrowsLinearlyFromNothingAtTheRange) {
  // 1.5 m to starboard of 6 m: V_i = (6 - 1.5) / 6 = 0.75, so V_f = (1, -0.5 * 0.75, 0), which is longer
  // than 1 m/s and is shortened
  const Command command = decide<Apf>(beside({0.0, 1.5, 0.0}));
  EXPECT_LT((command.velocity - unit(Vec3{1.0, -0.375, 0.0})).norm(), 1e-15);
  EXPECT_EQ(command.mode, Mode::avoid);
  EXPECT_TRUE(command.astern);
  // at the range itself it is in range, and nothing
  EXPECT_EQ(decide<Apf>(beside({0.0, 6.0, 0.0})),
            (Command{.velocity = {1.0, 0.0, 0.0}, .mode = Mode::avoid, .astern = true}));
}

TEST(Apf, PushesOfAllNeighboursAddUp) {
  // 3 m ahead, twice: V_f = 1 - 2 * (2 * 0.5 ) = -1 with W2 = 2
  OwnedSituation e = beside({3.0, 0.0, 0.0});
  e.tracks.push_back(e.tracks[0]);
  EXPECT_LT((decide<Apf>(e, {.w2_ratio = 2.0}).velocity - Vec3(-1.0, 0.0, 0.0)).norm(), 1e-15);
}

TEST(Apf, DoesNotRememberThePushes) {
  Avoider avoider{Apf{{}}};
  const OwnedSituation e = beside({3.0, 1.0, 0.0});
  const Command first = avoider.decide(e);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(avoider.decide(e), first);
}

TEST(Apf, TheWeakestForceIsAStandstillOneOfTheKnownTraps) {
  // dead ahead at W2 (6 - d) / 6 = 1, which W2 = 2 gives at d = 3
  EXPECT_LT(decide<Apf>(beside({3.0, 0.0, 0.0}), {.w2_ratio = 2.0}).velocity.norm(), 1e-15);
}

TEST(Apf, TheClampedLawLimitsHorizontalAndVerticalSeparately) {
  // 1.5 m below, W2 = 4: V_f = (1, 0, -3)
  EXPECT_LT((decide<Apf>(beside({0.0, 0.0, 1.5}), {.w2_ratio = 4.0}).velocity - Vec3(1.0, 0.0, -1.0)).norm(),
            1e-15);
  // a weak push stays weak: W2 = 0.4 gives -0.3
  EXPECT_LT((decide<Apf>(beside({0.0, 0.0, 1.5}), {.w2_ratio = 0.4}).velocity - Vec3(1.0, 0.0, -0.3)).norm(),
            1e-15);
}

TEST(Apf, TheBangBangLawKnowsOnlyFullSpeed) {
  const Apf::Params params{.w2_ratio = 0.4, .speed_law = ApfSpeedLaw::bang_bang};
  EXPECT_LT((decide<Apf>(beside({0.0, 0.0, 1.5}), params).velocity - Vec3(1.0, 0.0, -1.0)).norm(), 1e-15);
  // in a horizontal scene it does not dive
  EXPECT_EQ(decide<Apf>(beside({0.0, 1.5, 0.0}), params).velocity.z(), 0.0);
}

TEST(Apf, AttractionFollowsTheMissionsVelocityAndIsAlwaysOne) {
  OwnedSituation e = beside({-3.0, 0.0, 0.0});
  e.situation.goal.velocity = Vec3{0.0, 0.1, 0.0};
  EXPECT_LT((decide<Apf>(e).velocity - Vec3(0.25, 1.0, 0.0) / std::sqrt(1.0625)).norm(), 1e-15);
  // with nowhere to go only the push is left: half of (6 - 3) / 6
  e.situation.goal.velocity = Vec3::Zero();
  EXPECT_LT((decide<Apf>(e).velocity - Vec3(0.25, 0.0, 0.0)).norm(), 1e-15);
}

TEST(Apf, TwoAtTheSamePlacePartByTheirIds) {
  OwnedSituation e = beside(Vec3::Zero());
  e.situation.goal.velocity = Vec3::Zero();
  const Vec3 first = decide<Apf>(e).velocity;
  e.situation.own.id = VehicleId{1};
  e.tracks[0].id = TrackId{0};
  EXPECT_LT((first - Vec3(0.5, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_EQ(decide<Apf>(e).velocity, -first);
}

TEST(Apf, ObstaclesPushFromTheirNearestSurfacePoint) {
  // a sphere whose surface is 3 m to starboard pushes like a vehicle at 3 m
  OwnedSituation e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {0.0, 5.0, 50.0}, .radius = 2.0}};
  EXPECT_LT((decide<Apf>(e).velocity - decide<Apf>(beside({0.0, 3.0, 0.0})).velocity).norm(), 1e-15);

  // from inside, a full push out through the nearest side, which is 1 m to port
  const std::array<Vec3, 4> square{Vec3{-5, -1, 0}, Vec3{5, -1, 0}, Vec3{5, 9, 0}, Vec3{-5, 9, 0}};
  e.obstacles = {{.kind = Obstacle::Kind::polygon, .vertices = square}};
  EXPECT_LT((decide<Apf>(e).velocity - unit(Vec3{1.0, -0.5, 0.0})).norm(), 1e-15);
}

}  // namespace
}  // namespace fairway
