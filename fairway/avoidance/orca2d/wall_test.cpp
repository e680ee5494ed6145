// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/orca2d/wall.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fairway/avoidance/orca2d/cone.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::orca2d {
namespace {

const Vec2 north = Vec2::UnitX();

/// Radius 1, horizon 5 s, period 0.1 s.
Mariner mariner(const Vec2& velocity, double radius = 1.0, double horizon = 5.0) {
  return {velocity, radius, horizon, 0.1, north};
}

Wall free_wall(const Vec2& starboard, const Vec2& port) { return {{starboard}, {port}}; }

void expect_half_plane(const std::optional<HalfPlane>& h, const Vec2& normal, double offset) {
  ASSERT_TRUE(h.has_value());
  EXPECT_LT((h->normal - normal).norm(), 1e-14) << h->normal.transpose();
  EXPECT_NEAR(h->offset, offset, 1e-14);
}

TEST(OrcaWall, AheadItLimitsTheSpeedTowardsIt) {
  // 6 m ahead, radius 1: 5 m in 5 s, whether we are slower or faster now
  const Wall wall = free_wall({6.0, 10.0}, {6.0, -10.0});
  for (const double speed : {0.0, 0.5, 1.0, 2.0})
    expect_half_plane(half_plane(wall, mariner({speed, 0.3})), -north, -1.0);
}

TEST(OrcaWall, AbeamItLimitsTheDriftTowardsIt) {
  // 2 m to starboard: 1 m in 5 s
  const Wall wall = free_wall({-10.0, 2.0}, {10.0, 2.0});
  expect_half_plane(half_plane(wall, mariner({1.0, 0.0})), {0.0, -1.0}, -0.2);
}

TEST(OrcaWall, FastPastItsEndsIsHeldOffByTheLegs) {
  // end (4, 3), d = 5, radius 3: the tangent is (4 (4, 3) + 3 (-3, 4)) / 25 = (7, 24) / 25
  const Wall wall = free_wall({4.0, 3.0}, {4.0, -3.0});
  const Vec2 leg{0.28, 0.96};
  const Vec2 outward{-0.96, 0.28};
  for (const double inside : {-0.2, 0.0, 0.1}) {
    const Vec2 v = 3.0 * leg - inside * outward;
    expect_half_plane(half_plane(wall, mariner(v, 3.0)), outward, 0.0);
    expect_half_plane(half_plane(wall, mariner({v.x(), -v.y()}, 3.0)), {outward.x(), -outward.y()}, 0.0);
  }
}

TEST(OrcaWall, BesideItsEndsTheBoundaryIsRound) {
  // the end lies at (2, 1.5) one horizon away, the disc there has radius 0.5; the normal (-0.8, 0.6) is
  // between those of the front, (-1, 0), and of the leg, (-0.75, 0.66)
  const Wall wall = free_wall({4.0, 3.0}, {4.0, -3.0});
  expect_half_plane(half_plane(wall, mariner({1.52, 1.86}, 1.0, 2.0)), {-0.8, 0.6}, -0.2);
  expect_half_plane(half_plane(wall, mariner({1.52, -1.86}, 1.0, 2.0)), {-0.8, -0.6}, -0.2);
}

TEST(OrcaWall, SeenAlongItsLengthItIsItsNearerEnd) {
  // sin 3/5, cos 4/5, as for a disc of radius 3 at 5 m
  for (const Wall& wall : {free_wall({5.0, 0.0}, {15.0, 0.0}), free_wall({15.0, 0.0}, {5.0, 0.0}),
                           free_wall({15.0, 1.0}, {5.0, 0.0}), free_wall({5.0, 0.0}, {15.0, -1.0})})
    expect_half_plane(half_plane(wall, mariner({2.0, 0.1}, 3.0)), {-0.6, 0.8}, 0.0);
}

TEST(OrcaWall, OnTheAxisOfAPostTheWayIsToStarboard) {
  expect_half_plane(half_plane(free_wall({5.0, 0.0}, {5.0, 0.0}), mariner({2.0, 0.0}, 3.0)), {-0.6, 0.8},
                    0.0);
}

TEST(OrcaWall, APostIsADiscOfNoRadius) {
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Rng rng = Rng{1}.stream("post", i);
    const Vec2 p{rng.uniform(-6.0, 6.0), rng.uniform(-6.0, 6.0)};
    const Mariner own = mariner({rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0)}, rng.uniform(0.1, 5.0));
    const auto post = half_plane(free_wall(p, p), own);
    ASSERT_TRUE(post.has_value());
    if (p.norm() <= own.radius) continue;  // a disc is left in the direction of the present velocity
    const Change change = least_change({p, own.velocity, own.radius, north}, own.horizon, own.period);
    const HalfPlane disc = half_plane(change, own.velocity, 1.0);
    EXPECT_LT((post->normal - disc.normal).norm(), 1e-11) << i;
    EXPECT_NEAR(post->offset, disc.offset, 1e-11);
  }
}

/// The velocity obstacle is convex, so how far outside of it a velocity lies is the most, over all
/// directions n, of n . v - h(n), where h(n) is how far it reaches along n: that of the nearer end's
/// disc one horizon away, where n points away from both discs. Searched in long double.
struct SearchedTangent {
  long double outside;
  long double bearing;
};

SearchedTangent searched(const Wall& wall, const Mariner& own) {
  const auto along = [](const Vec2& a, long double bearing) {
    return static_cast<long double>(a.x()) * std::cos(bearing) +
           static_cast<long double>(a.y()) * std::sin(bearing);
  };
  const auto outside = [&](long double bearing) {
    const long double nearest =
        std::max(along(wall.starboard.p, bearing), along(wall.port.p, bearing)) + own.radius;
    if (nearest > 0.0L) return -1e9L * (1.0L + nearest);
    return along(own.velocity, bearing) - nearest / own.horizon;
  };
  // every direction that is better than its neighbours is refined
  const int steps = 720;
  const long double step = 2.0L * static_cast<long double>(pi) / steps;
  SearchedTangent best{-1e30L, 0.0L};
  for (int i = 0; i < steps; ++i) {
    if (outside(i * step) < std::max(outside((i - 1) * step), outside((i + 1) * step))) continue;
    long double lo = (i - 1) * step, hi = (i + 1) * step;
    for (int k = 0; k < 120; ++k) {
      const long double left = lo + (hi - lo) / 3, right = hi - (hi - lo) / 3;
      (outside(left) < outside(right) ? lo : hi) = outside(left) < outside(right) ? left : right;
    }
    for (const long double bearing : {lo, hi})
      if (outside(bearing) > best.outside) best = {outside(bearing), bearing};
  }
  return best;
}

TEST(OrcaWall, AgreesWithASearchForTheNearestTangent) {
  double distance = 0.0, normal = 0.0;
  int found = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Rng rng = Rng{2}.stream("wall", i);
    const auto point = [&](double reach) {
      return Vec2{rng.uniform(-reach, reach), rng.uniform(-reach, reach)};
    };
    Wall wall = free_wall(point(6.0), point(6.0));
    if (cross(wall.port.p - wall.starboard.p, -wall.starboard.p) > 0.0) std::swap(wall.starboard, wall.port);
    const Mariner own = mariner(point(2.0), rng.uniform(0.1, 2.0), rng.uniform(0.5, 10.0));
    const SearchedTangent expected = searched(wall, own);
    if (expected.outside < -1e6L) continue;  // closer than the radius
    const auto tangent = half_plane(wall, own);
    ASSERT_TRUE(tangent.has_value());
    const Vec2 searched_normal{static_cast<double>(std::cos(expected.bearing)),
                               static_cast<double>(std::sin(expected.bearing))};
    distance = std::fmax(
        distance, std::fabs(-tangent->violation(own.velocity) - static_cast<double>(expected.outside)));
    normal = std::fmax(normal, (tangent->normal - searched_normal).norm());
    ++found;
  }
  EXPECT_LT(distance, 1e-12);  // measured 2e-15
  EXPECT_LT(normal, 1e-6);     // where the search stops
  EXPECT_GT(found, 1000);
}

TEST(OrcaWall, AtAConvexCornerNoLegPointsIntoTheNextWall) {
  // a corner 5 m ahead; its walls lead away to (9, 8) and (9, -8)
  const Vec2 to_starboard = Vec2{4.0, 8.0}.normalized();
  const Vec2 to_port = Vec2{4.0, -8.0}.normalized();
  const Wall starboard{{{9.0, 8.0}}, {{5.0, 0.0}, true, to_port}};
  const Wall port{{{5.0, 0.0}, true, to_starboard}, {{9.0, -8.0}}};

  // straight ahead the corner is round for both
  expect_half_plane(half_plane(starboard, mariner({0.5, 0.0})), -north, -0.8);
  expect_half_plane(half_plane(port, mariner({0.5, 0.0})), -north, -0.8);

  // beyond the corner each has only what is its own
  EXPECT_FALSE(half_plane(starboard, mariner({1.5, -0.9})).has_value());
  EXPECT_FALSE(half_plane(port, mariner({1.5, 0.9})).has_value());
  const Vec2 front{-std::sqrt(0.8), std::sqrt(0.2)};  // across (4, 8)
  expect_half_plane(half_plane(starboard, mariner({1.5, 0.9})), front, (front.x() * 5.0 + 1.0) / 5.0);
}

TEST(OrcaWall, AtAReflexCornerTheWallRunsOnBehindTheNext) {
  // ahead at 6 m as far as 2 m to port, where the next wall comes towards us
  const Wall ahead{{{6.0, 10.0}}, {{6.0, -2.0}, false, {-1.0, 0.0}}};
  const Wall abeam{{{6.0, -2.0}, false, {0.0, 1.0}}, {{-10.0, -2.0}}};
  for (const double speed : {0.5, 3.0}) {
    expect_half_plane(half_plane(ahead, mariner({speed, -2.0})), -north, -1.0);
    expect_half_plane(half_plane(abeam, mariner({3.0, -0.1 * speed})), {0.0, 1.0}, -0.2);
  }
}

TEST(OrcaWall, PastAReflexCornerItIsHiddenByTheNext) {
  const Wall wall{{{0.5, 10.0}}, {{0.5, 2.0}, false, {-1.0, 0.0}}};
  EXPECT_FALSE(half_plane(wall, mariner({0.0, 1.0})).has_value());
}

TEST(OrcaWall, CloserThanTheRadiusItIsClearedWithinOnePeriod) {
  // radius 1, period 0.1: 0.1 m, 0.7 m and, off an end, 0.5 m too close
  const Wall wall = free_wall({0.9, 10.0}, {0.9, -10.0});
  expect_half_plane(half_plane(wall, mariner({1.0, 0.0})), -north, 1.0);
  expect_half_plane(half_plane(free_wall({-0.3, -10.0}, {-0.3, 0.4}), mariner({1.0, 0.0})), north, 7.0);
  expect_half_plane(half_plane(free_wall({-9.0, 0.0}, {-0.5, 0.0}), mariner({1.0, 0.0})), north, 5.0);
}

TEST(OrcaWall, ExactlyOnItTheWayIsToTheSideItIsSeenFrom) {
  expect_half_plane(half_plane(free_wall({0.0, 1.0}, {0.0, -1.0}), mariner({1.0, 0.0})), -north, 10.0);
  expect_half_plane(half_plane(free_wall({0.0, 0.0}, {0.0, -1.0}), mariner({1.0, 0.0})), -north, 10.0);
  expect_half_plane(half_plane(free_wall({0.0, 0.0}, {0.0, 0.0}), mariner({1.0, 0.0})), north, 10.0);
}

TEST(OrcaWall, FromInsideTheWayIsOutAndOneRadiusClear) {
  // the wall 0.2 m behind us, facing south
  const Wall wall = free_wall({-0.2, 3.0}, {-0.2, -3.0});
  const HalfPlane out = way_out(wall, mariner({1.0, 0.0}));
  EXPECT_LT((out.normal + north).norm(), 1e-15);
  EXPECT_NEAR(out.offset, 12.0, 1e-12);
  // a reflex corner astern: out through it
  const Wall corner{{{-0.2, 0.0}, false}, {{-1.2, -1.0}}};
  EXPECT_LT((way_out(corner, mariner({1.0, 0.0})).normal + north).norm(), 1e-15);
  EXPECT_NEAR(way_out(corner, mariner({1.0, 0.0})).offset, 12.0, 1e-12);
}

TEST(OrcaWall, AWallBehindOneThatIsKeptAsksForNothing) {
  const Wall front = free_wall({6.0, 10.0}, {6.0, -10.0});
  const Mariner own = mariner({0.5, 0.0});
  const HalfPlane kept = *half_plane(front, own);
  EXPECT_TRUE(covers(kept, front, own));
  EXPECT_TRUE(covers(kept, free_wall({7.0, 30.0}, {6.0, 10.0}), own));
  EXPECT_FALSE(covers(kept, free_wall({5.999, 30.0}, {6.0, 10.0}), own));
  // one that only has to be cleared covers what lies behind no velocity at all
  EXPECT_FALSE(covers({-north, 1.0}, free_wall({0.9, 10.0}, {0.9, -10.0}), own));
  EXPECT_TRUE(covers({-north, 1.0}, free_wall({1.0, 10.0}, {1.0, -10.0}), own));
}

}  // namespace
}  // namespace fairway::orca2d
