// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/explain/decision_facts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(ClosestApproach, IsThatOfTheClosedForm) {
  // head-on with an offset of 3 m: abeam after 20 m at 2 m/s
  const ClosestApproach met = closest_approach({20, 3, 0}, {-2, 0, 0});
  EXPECT_DOUBLE_EQ(met.time, 10.0);
  EXPECT_DOUBLE_EQ(met.distance, 3.0);
  // at right angles, each 10 m from the crossing at 1 and 0.5 m/s: |(10 - t, 10 - t / 2)| is least at t = 12
  const ClosestApproach crossing = closest_approach({10, 10, 0}, {-1, -0.5, 0});
  EXPECT_DOUBLE_EQ(crossing.time, 12.0);
  EXPECT_DOUBLE_EQ(crossing.distance, std::sqrt(20.0));
  // drawing apart, and side by side
  EXPECT_EQ(closest_approach({5, 0, 0}, {1, 0, 0}).time, 0.0);
  EXPECT_EQ(closest_approach({5, 0, 0}, {1, 0, 0}).distance, 5.0);
  EXPECT_EQ(closest_approach({0, 4, 3}, {0, 0, 0}).distance, 5.0);
}

TEST(ClosestApproach, IsNearerThanAnyOtherInstant) {
  Rng rng{7};
  const auto draw = [&](double size) {
    return Vec3{size * rng.normal(), size * rng.normal(), size * rng.normal()};
  };
  for (int k = 0; k < 200; ++k) {
    const Vec3 p = draw(10.0);
    const Vec3 v = draw(1.0);
    const ClosestApproach met = closest_approach(p, v);
    EXPECT_NEAR((p + met.time * v).norm(), met.distance, 1e-12);
    for (int i = 0; i < 20; ++i) EXPECT_LE(met.distance, (p + rng.uniform(0.0, 60.0) * v).norm() + 1e-12);
  }
}

/// At 5 m depth, heading east at 1 m/s to a goal 50 m east; a neighbour comes 20 m ahead, 2 m to starboard.
struct Encountered {
  std::array<Track, 1> tracks{
      Track{.id = TrackId{1}, .position = {2, 20, 6}, .velocity = {0, -1, 0}, .radius = 2, .priority = 3}};
  std::array<Obstacle, 2> obstacles{
      Obstacle{.kind = Obstacle::Kind::sphere, .position = {0, -30, 5}, .radius = 2},
      Obstacle{.kind = Obstacle::Kind::segment, .from = {-9, -5, 5}, .to = {-9, 5, 5}}};
  Situation s{
      .time = 3,
      .period = 0.5,
      .own = {.position = {0, 0, 5}, .velocity = {0, 1, 0}, .yaw = pi / 2, .radius = 1, .priority = 2},
      .goal = {.position = {0, 50, 5}, .cruise_speed = 1},
      .limits = {.max_speed = 1.2, .max_climb_rate = 0.3, .min_depth = 0, .max_depth = 5.1},
      .tracks = tracks,
      .obstacles = obstacles};
};

TEST(DecisionFacts, OfANeighbourAreRelativeToTheBow) {
  const Encountered e;
  const DecisionFacts facts = facts_of(e.s, {.velocity = {0, 0, 0}});
  ASSERT_EQ(facts.neighbours.size(), 1u);
  const NeighbourFacts& n = facts.neighbours[0];
  EXPECT_DOUBLE_EQ(n.range, std::sqrt(4.0 + 400.0 + 1.0));
  EXPECT_NEAR(n.bearing, -std::atan2(2.0, 20.0), 1e-12) << "north of a vehicle that heads east is to port";
  EXPECT_DOUBLE_EQ(n.below, 1.0);
  EXPECT_DOUBLE_EQ(n.closing, 2.0 * 20.0 / n.range);
  EXPECT_DOUBLE_EQ(n.radii, 3.0);
  EXPECT_DOUBLE_EQ(n.at_present.time, 10.0);
  EXPECT_DOUBLE_EQ(n.at_present.distance, std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(n.commanded.time, 20.0);
  EXPECT_EQ(n.precedence, Precedence::own);
  EXPECT_DOUBLE_EQ(facts.goal_distance, 50.0);
  EXPECT_NEAR(facts.goal_bearing, 0.0, 1e-12);
}

TEST(DecisionFacts, OfObstaclesAreThoseOfTheirSurfaceNearestFirst) {
  const Encountered e;
  const DecisionFacts facts = facts_of(e.s, {});
  ASSERT_EQ(facts.obstacles.size(), 2u);
  EXPECT_EQ(facts.obstacles[0].kind, Obstacle::Kind::segment);
  EXPECT_DOUBLE_EQ(facts.obstacles[0].distance, 9.0);
  EXPECT_NEAR(facts.obstacles[0].bearing, pi / 2, 1e-12)
      << "south of a vehicle that heads east is to starboard";
  EXPECT_DOUBLE_EQ(facts.obstacles[1].distance, 28.0);
  EXPECT_NEAR(std::abs(facts.obstacles[1].bearing), pi, 1e-12);
}

TEST(DecisionFacts, OfTheDeviationAreCourseSpeedAndClimb) {
  const Encountered e;
  const Deviation slower = facts_of(e.s, {.velocity = {0, 0.4, 0}}).deviation;
  EXPECT_NEAR(slower.speed, -0.6, 1e-12);
  EXPECT_NEAR(*slower.turn, 0.0, 1e-12);
  EXPECT_NEAR(slower.size, 0.6, 1e-12);
  const Deviation south = facts_of(e.s, {.velocity = {-1, 0, -0.2}}).deviation;
  EXPECT_NEAR(*south.turn, pi / 2, 1e-12) << "from east to south is to starboard";
  EXPECT_NEAR(south.climb, 0.2, 1e-12);
  EXPECT_FALSE(facts_of(e.s, {.velocity = {0, 0, 0.1}}).deviation.turn);
}

TEST(DecisionFacts, SayWhoGoesAsternAndWhoTurnsRound) {
  Encountered e;
  e.s.limits.sway = false;
  EXPECT_TRUE(facts_of(e.s, {.velocity = {0, -0.4, 0}, .turn_rate = 0.1}).deviation.astern);
  EXPECT_FALSE(facts_of(e.s, {.velocity = {0, 0.4, 0}, .turn_rate = 0.1}).deviation.astern);
  EXPECT_FALSE(facts_of(e.s, {.velocity = {0, -0.4, 0}}).deviation.astern);
  e.s.limits.sway = true;
  EXPECT_FALSE(facts_of(e.s, {.velocity = {0, -0.4, 0}, .turn_rate = 0.1}).deviation.astern);
}

TEST(DecisionFacts, NameTheLimitsThatTheCommandIsAt) {
  const Encountered e;
  EXPECT_THAT(facts_of(e.s, {.velocity = {0, 1, 0}}).binding, IsEmpty());
  EXPECT_THAT(facts_of(e.s, {.velocity = {0, 1.2, 0}}).binding, ElementsAre("the speed limit of 1.200 m/s"));
  EXPECT_THAT(facts_of(e.s, {.velocity = {0, 0, -0.3}}).binding,
              ElementsAre("the climb rate limit of 0.300 m/s"));
  EXPECT_THAT(facts_of(e.s, {.velocity = {0, 0.5, (5.1 - 5.0) / 0.5}}).binding,
              ElementsAre("the floor at a depth of 5.10 m"));
  Encountered surfaced;
  surfaced.s.own.position.z() = 0.0;
  surfaced.s.goal.position.z() = 0.0;
  EXPECT_THAT(facts_of(surfaced.s, {.velocity = {0, 1, 0}}).binding, IsEmpty()) << "nobody wants to fly";
}

}  // namespace
}  // namespace fairway
