// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/wall_following/corrected.hpp"

#include <gtest/gtest.h>

#include <array>

#include "fairway/avoidance/testing/boat.hpp"
#include "fairway/avoidance/testing/passage.hpp"
#include "fairway/core/testing/allocations.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;
using encounters::sphere;
using encounters::wall;

WallFollowing::Params corrected(WallFollowing::Params params = {}) {
  params.form = WallFollowingForm::corrected;
  return params;
}

Avoider follower() { return Avoider{WallFollowing{corrected()}}; }

/// Own ship of radius 1 m at the surface, northbound at 1 m/s, 40 m from its goal.
OwnedSituation northbound() {
  OwnedSituation e = encounters::shifted(encounters::open_water(), {0.0, 0.0, -50.0});
  e.situation.goal.position = {40.0, 0.0, 0.0};
  return e;
}

encounters::Passage passage(const OwnedSituation& e, double duration, double lag = 0.0) {
  return encounters::passage(e, follower(), {.duration = duration, .lag = lag, .reach = 0.2});
}

/// It arrives by `latest` [s] and keeps the standoff of 1 m, less `intrusion` [m].
void expect_passed(const encounters::Passage& p, double latest, double intrusion = 0.0) {
  EXPECT_GT(p.clearance, 1.0 - intrusion);
  EXPECT_LT(p.arrival.value_or(1e9), latest);
  EXPECT_LT(p.fastest, 1.5 + 1e-12);
}

TEST(WallFollowingCorrected, GoesRoundASphereAtTheStandoff) {
  OwnedSituation e = northbound();
  e.obstacles = {sphere(20.0, 0.0, 5.0)};
  const encounters::Passage p = passage(e, 100);
  expect_passed(p, 45.0);  // measured 43.7 s and 1.05 m; 39.8 s if nothing were there
  EXPECT_LT(p.clearance, 1.1);
  EXPECT_EQ(p.changes, 2);  // into following and out of it
  EXPECT_LT(p.fastest, 1.0 + 1e-12);
  expect_passed(passage(e, 100, 1.0), 46.0);  // measured 44.6 s and 1.41 m with a lag of 1 s
}

TEST(WallFollowingCorrected, WhoIsLedAndForeseenIsNotTurnedAsideByWhatItPasses) {
  OwnedSituation e = northbound();
  e.obstacles = {sphere(3.0, 5.0, 2.5)};  // closing at 0.51 m/s, 2.3 m off
  const Envelope envelope = encounters::of_a_boat();
  e.situation.is_led = true;
  EXPECT_EQ(follower().decide(e).mode, Mode::avoid);
  e.situation.envelope = &envelope;
  EXPECT_EQ(follower().decide(e).mode, Mode::cruise);
  e.situation.is_led = false;
  EXPECT_EQ(follower().decide(e).mode, Mode::avoid);
}

TEST(WallFollowingCorrected, AvoidsWhatIsExactlyOnTheDiagonal) {
  OwnedSituation e = northbound();
  e.situation.own.radius = 3.2;
  e.situation.goal.position = {40.0, 40.0, 0.0};
  e.obstacles = {sphere(20.0, 20.0, 1.0)};
  expect_passed(passage(e, 100), 60.0);  // measured 58.8 s and 1.13 m
}

TEST(WallFollowingCorrected, GoesRoundAWallAndAPolygon) {
  OwnedSituation e = northbound();
  e.obstacles = {wall({20.0, -10.0, 0.0}, {20.0, 6.0, 0.0})};
  expect_passed(passage(e, 100), 48.0);       // measured 46.6 s and 1.16 m
  expect_passed(passage(e, 100, 1.0), 50.0);  // measured 48.5 s and 1.03 m
  const std::array<Vec3, 4> square{Vec3{15, -8, 0}, Vec3{25, -8, 0}, Vec3{25, 6, 0}, Vec3{15, 6, 0}};
  e.obstacles = {{.kind = Obstacle::Kind::polygon, .vertices = square}};
  expect_passed(passage(e, 100), 50.0);       // measured 48.0 s and 1.06 m
  expect_passed(passage(e, 100, 1.0), 52.0);  // measured 50.1 s and 1.12 m
}

TEST(WallFollowingCorrected, LeavesAUWhereItIsNearerToTheGoalThanWhereItHit) {
  OwnedSituation e = northbound();
  e.obstacles = {wall({20.0, -10.0, 0.0}, {20.0, 10.0, 0.0}), wall({0.0, -10.0, 0.0}, {20.0, -10.0, 0.0}),
                 wall({0.0, 10.0, 0.0}, {20.0, 10.0, 0.0})};
  e.situation.own.position = {5.0, 0.0, 0.0};
  expect_passed(passage(e, 200), 86.0);             // measured 83.9 s and 1.0007 m
  expect_passed(passage(e, 200, 1.0), 91.0, 0.01);  // measured 89.2 s and 0.993 m
  const std::array<Vec3, 8> u{Vec3{22, 12, 0},  Vec3{0, 12, 0},  Vec3{0, 10, 0},  Vec3{20, 10, 0},
                              Vec3{20, -10, 0}, Vec3{0, -10, 0}, Vec3{0, -12, 0}, Vec3{22, -12, 0}};
  e.obstacles = {{.kind = Obstacle::Kind::polygon, .vertices = u}};
  expect_passed(passage(e, 200), 91.0);  // measured 89.0 s and 1.001 m
}

TEST(WallFollowingCorrected, PassesWhatMoves) {
  OwnedSituation e = northbound();
  e.tracks = {encounters::track(1, {30.0, 0.0, 0.0}, {-0.5, 0.0, 0.0}, 2.0)};
  expect_passed(passage(e, 100), 44.0);  // measured 42.6 s and 1.50 m
  e.tracks = {encounters::track(1, {20.0, 10.0, 0.0}, {0.0, -0.5, 0.0}, 2.0)};
  expect_passed(passage(e, 100), 44.0);  // measured 42.6 s and 1.15 m
  e.tracks = {encounters::track(1, {8.0, 0.0, 0.0}, {0.3, 0.0, 0.0}, 2.0)};
  expect_passed(passage(e, 50), 43.0);  // measured 41.1 s and 1.08 m
}

TEST(WallFollowingCorrected, LetsGoOfWhatDriftsAwayFromTheGoal) {
  // in 7 of these 100 it would circle what drifts for good if it waited to be nearer than where it met it
  for (std::uint64_t i = 0; i < 100; ++i) {
    Rng rng = Rng{21}.stream("drifters", i);
    OwnedSituation e = northbound();
    for (std::uint32_t k = 1; k <= 6; ++k) {
      const Vec3 place{rng.uniform(8.0, 36.0), rng.uniform(-8.0, 8.0), 0.0};
      const Vec3 drift{rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4), 0.0};
      e.tracks.push_back(encounters::track(k, place, drift, rng.uniform(0.3, 1.2)));
    }
    const encounters::Passage p = passage(e.sorted(), 150, 0.5);
    EXPECT_TRUE(p.arrival) << i;
    EXPECT_GT(p.clearance, 0.0) << i;
  }
}

TEST(WallFollowingCorrected, GoesFasterThanTheMissionWantsToGetOutOfTheWay) {
  OwnedSituation e = northbound();
  e.tracks = {encounters::track(1, {-8.0, 0.0, 0.0}, {1.4, 0.0, 0.0}, 2.0)};
  const encounters::Passage p = passage(e, 100);
  expect_passed(p, 46.0);  // measured 43.8 s and 1.28 m
  EXPECT_NEAR(p.fastest, 1.5, 1e-9);
}

TEST(WallFollowingCorrected, BacksOffFromWhatItCannotOutrunAndSaysSo) {
  OwnedSituation e = northbound();
  e.tracks = {encounters::track(1, {-4.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, 2.0)};
  const Command command = follower().decide(e);
  EXPECT_EQ(command.mode, Mode::infeasible);
  EXPECT_FALSE(command.note.empty());
  EXPECT_LT((command.velocity - Vec3(1.5, 0.0, 0.0)).norm(), 1e-9);
}

TEST(WallFollowingCorrected, FollowsTheEdgeOfWhatIsForbidden) {
  // a wall ahead allows no speed towards it: the way is along it, to the side that `turn` tells
  const std::array<HalfPlane, 1> ahead{HalfPlane{{-1.0, 0.0}, 0.0}};
  EXPECT_LT((wall::way_along(ahead, {1.0, 0.0}, 1.0, 1.0)->direction - Vec2(0.0, 1.0)).norm(), 1e-9);
  EXPECT_LT((wall::way_along(ahead, {1.0, 0.0}, -1.0, 1.0)->direction - Vec2(0.0, -1.0)).norm(), 1e-9);
  EXPECT_LT((wall::way_along(ahead, {-0.6, 0.8}, 1.0, 1.0)->direction - Vec2(0.0, 1.0)).norm(), 1e-9);
  // in a corner it is back along the other wall
  const std::array<HalfPlane, 2> corner{ahead[0], HalfPlane{{0.0, -1.0}, 0.0}};
  EXPECT_LT((wall::way_along(corner, {1.0, 0.0}, 1.0, 1.0)->direction - Vec2(-1.0, 0.0)).norm(), 1e-9);
  // away from every wall there is none to follow, and between two that close there is no way
  EXPECT_FALSE(wall::way_along(ahead, {-1.0, -0.1}, 1.0, 1.0)->has_wall);
  const std::array<HalfPlane, 2> jaws{HalfPlane{{1.0, 0.0}, 0.1}, HalfPlane{{-1.0, 0.0}, 0.1}};
  EXPECT_FALSE(wall::way_along(jaws, {0.0, 1.0}, 1.0, 1.0).has_value());
}

TEST(WallFollowingCorrected, NeverCommandsIntoWhatIsWithinTheStandoff) {
  int within = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Rng rng = Rng{1}.stream("field", i);
    OwnedSituation e = northbound();
    const double bearing = rng.uniform(-pi, pi);
    e.situation.goal.position = {40 * std::cos(bearing), 40 * std::sin(bearing), 0.0};
    const double other = rng.uniform(-pi, pi);
    const double range = 4.0 + rng.uniform(-0.5, 3.0);
    e.obstacles = {sphere(range * std::cos(other), range * std::sin(other), 3.0)};
    const Command command = follower().decide(e);
    const SurfacePoint nearest = nearest_point(e.obstacles[0], Vec3::Zero());
    if (nearest.distance - 1.0 > 1.0) continue;
    ++within;
    EXPECT_LE(command.velocity.dot(nearest.point), 1e-12) << i;
  }
  EXPECT_GT(within, 500);
}

TEST(WallFollowingCorrected, TheHeadingOfTheFrameDoesNotMatter) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    OwnedSituation e = encounters::crowd(static_cast<int>(i % 12), Rng{2}.stream("crowd", i));
    for (Track& t : e.tracks) t.position.z() = e.situation.own.position.z();
    const Vec3 expected = follower().decide(e.sorted()).velocity;
    const Vec3 turned = follower().decide(encounters::turned(e, 0.7)).velocity;
    EXPECT_LT((turned - Eigen::AngleAxisd(0.7, Vec3::UnitZ()) * expected).norm(), 1e-6) << i;
  }
}

TEST(WallFollowingCorrected, AllocatesNothing) {
  OwnedSituation e = northbound();
  e.obstacles = {sphere(6.0, 0.5, 2.0), wall({4.0, -3.0, 0.0}, {4.0, 3.0, 0.0})};
  Avoider avoider = follower();
  const long before = allocation_count();
  EXPECT_EQ(avoider.decide(e).mode, Mode::avoid);
  EXPECT_EQ(allocation_count(), before);
}

TEST(WallFollowingCorrected, NoNumberOfPebblesHidesAVessel) {
  OwnedSituation e = northbound();
  e.tracks = {encounters::track(1, {4.0, 0.0, 0.0}, {-1.0, 0.0, 0.0})};
  const double range = corrected().sensor_range_m;
  for (int i = 0; i < 300; ++i) e.obstacles.push_back(sphere(-0.9 * range, 0.001 * i, 0.1));
  const Command command = follower().decide(e);
  EXPECT_NE(command.mode, Mode::cruise);
  EXPECT_NE(command.note, "");
}

}  // namespace
}  // namespace fairway
