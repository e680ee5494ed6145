// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/way_round/shortest_way.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/avoidance/orca2d/orca2d.hpp"
#include "fairway/avoidance/safety_filter/safety_filter.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/avoidance/wall_following/wall_following.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;

Avoider way_round_for_direct(const ShortestWay::Params& params = {}) {
  return Avoider{ShortestWay{params}, Avoider{Direct{{}}}};
}

/// From the origin, 40 m north, at a depth of 50 m.
OwnedSituation bound_north() {
  OwnedSituation e = encounters::open_water();
  e.situation.own.position = {0.0, 0.0, 50.0};
  e.situation.own.yaw = 0.0;
  e.situation.goal = {.position = {40.0, 0.0, 50.0}, .cruise_speed = 1.0};
  return e;
}

TEST(ShortestWay, WhereNothingIsInTheWayTheInnerAvoiderDecidesAsEver) {
  OwnedSituation e = bound_north();
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {20.0, 9.0, 50.0}, .radius = 2.0}};
  EXPECT_EQ(way_round_for_direct().decide(e), Avoider{Direct{{}}}.decide(e));
}

TEST(ShortestWay, ItLeadsAlongTheTangentOfABuoy) {
  // a disc of 2 + 1 + 0.6 m at 20 m, 0.5 m to starboard: to port, asin(3.6 / d) - atan(0.5 / 20)
  OwnedSituation e = bound_north();
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {20.0, 0.5, 50.0}, .radius = 2.0}};
  const Vec3 v = way_round_for_direct().decide(e).velocity;
  const double angle = std::asin(3.6 / std::hypot(20.0, 0.5)) - std::atan2(0.5, 20.0);
  EXPECT_NEAR(std::atan2(v.y(), v.x()), -angle, 1e-9);
  EXPECT_NEAR(v.norm(), 1.0, 1e-12);
}

TEST(ShortestWay, WhoNeitherMakesWayNorMovesIsAsGoodAsABuoy) {
  OwnedSituation buoy = bound_north();
  buoy.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {20.0, 0.5, 50.0}, .radius = 2.0}};
  OwnedSituation seen = bound_north();
  seen.tracks = {{.id = TrackId{7}, .position = {20.0, 0.5, 50.0}, .radius = 2.0, .reacts = false}};
  EXPECT_EQ(way_round_for_direct().decide(seen), way_round_for_direct().decide(buoy));

  OwnedSituation moving = seen, polite = seen;
  moving.tracks[0].velocity = {0.0, 0.1, 0.0};
  polite.tracks[0].reacts = true;
  for (const OwnedSituation& s : {moving, polite})
    EXPECT_EQ(way_round_for_direct().decide(s), Avoider{Direct{{}}}.decide(s));
}

TEST(ShortestWay, ItKeepsTwiceTheMarginOfWhoeverHoldsItToSurfaces) {
  OwnedSituation e = bound_north();
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {20.0, 0.5, 50.0}, .radius = 2.0}};
  const SafetyFilter filter{.params = {.margin_m = 0.9}};
  Avoider held{ShortestWay{}, Avoider{filter, Avoider{Direct{{}}}}};
  const Vec3 v = held.decide(e).velocity;
  const double angle = std::asin(4.8 / std::hypot(20.0, 0.5)) - std::atan2(0.5, 20.0);
  EXPECT_NEAR(std::atan2(v.y(), v.x()), -angle, 1e-9);
}

TEST(ShortestWay, ItKeepsTwiceTheStandoffOfAWallFollower) {
  OwnedSituation e = bound_north();
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {20.0, 0.5, 50.0}, .radius = 2.0}};
  const WallFollowing follower{.params = {.form = WallFollowingForm::corrected, .standoff_m = 0.9}};
  const Vec3 v = Avoider{ShortestWay{}, Avoider{follower}}.decide(e).velocity;
  const double angle = std::asin(4.8 / std::hypot(20.0, 0.5)) - std::atan2(0.5, 20.0);
  EXPECT_NEAR(std::atan2(v.y(), v.x()), -angle, 1e-9);
}

struct Watches {
  static constexpr AlgorithmInfo info{.name = "watches", .title = "Says whether it is led", .source = "test"};
  struct Params {
    static consteval auto fields() { return std::tuple{}; }
  };
  struct Memory {};
  Params params;
  Command decide(const Situation& s, Memory& /*memory*/, Context& /*context*/) const noexcept {
    return {.velocity = s.preferred_velocity(), .note = s.is_led ? "led" : "alone"};
  }
};

TEST(ShortestWay, ItSaysThatItLeadsWhereTheWayIsStraightToo) {
  EXPECT_EQ(Avoider(ShortestWay{}, Avoider{Watches{}}).decide(bound_north()).note, "led");
  EXPECT_EQ(Avoider{Watches{}}.decide(bound_north()).note, "alone");
}

TEST(ShortestWay, ItKeepsWhatItsNavigationStatesToo) {
  OwnedSituation e = bound_north();
  e.situation.own.position_sigma = 0.6;
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {20.0, 0.5, 50.0}, .radius = 2.0}};
  const Vec3 v = way_round_for_direct().decide(e).velocity;
  const double angle = std::asin((3.6 + 2 * 0.6) / std::hypot(20.0, 0.5)) - std::atan2(0.5, 20.0);
  EXPECT_NEAR(std::atan2(v.y(), v.x()), -angle, 1e-9);
}

TEST(ShortestWay, ItLeadsOutOfAPocketInWhichTheStraightWayEnds) {
  OwnedSituation e = bound_north();
  const auto wall = [](const Vec3& from, const Vec3& to) {
    return Obstacle{.kind = Obstacle::Kind::segment, .from = from, .to = to};
  };
  e.obstacles = {wall({10, -8, 50}, {10, 6, 50}), wall({10, -8, 50}, {-5, -8, 50}),
                 wall({10, 6, 50}, {-5, 6, 50})};
  EXPECT_LT(way_round_for_direct().decide(e).velocity.x(), 0.0);
  EXPECT_GT(Avoider{Direct{{}}}.decide(e).velocity.x(), 0.9);
}

TEST(ShortestWay, WhatHasBeenSeenIsRemembered) {
  OwnedSituation e = bound_north();
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {20.0, 0.5, 50.0}, .radius = 2.0}};
  Avoider avoider = way_round_for_direct();
  const Command seen = avoider.decide(e);
  e.obstacles.clear();
  EXPECT_EQ(avoider.decide(e), seen);
}

TEST(ShortestWay, WhatTheWayPassesOverIsNotGoneRoundButByWhoThinksInThePlane) {
  OwnedSituation e = bound_north();
  Avoider in_space = way_round_for_direct();
  Avoider in_plane{ShortestWay{}, Avoider{Orca2d{{}}}};
  const auto turns = [&](Avoider& avoider) { return std::abs(avoider.decide(e).velocity.y()) > 1e-3; };
  // as seen from above it is in the way, and 2 + 1 + 0.6 m are just more, or less, than what lies between
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {20.0, 0.5, 53.5}, .radius = 2.0}};
  EXPECT_TRUE(turns(in_space));
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {20.0, 0.5, 53.7}, .radius = 2.0}};
  EXPECT_FALSE(turns(in_space)) << "it was in the way before";
  EXPECT_TRUE(turns(in_plane));
  e.situation.goal.position.z() = 55.0;
  EXPECT_TRUE(turns(in_space)) << "it dives by it";
}

TEST(ShortestWay, WithoutAnyWayItIsTheStraightOne) {
  OwnedSituation e = bound_north();
  e.add_polygon({{-5, -5, 50}, {5, -5, 50}, {5, 5, 50}, {-5, 5, 50}});  // all round
  e.situation.own.radius = 0.1;
  EXPECT_EQ(way_round_for_direct().decide(e), Avoider{Direct{{}}}.decide(e));
}

}  // namespace
}  // namespace fairway
