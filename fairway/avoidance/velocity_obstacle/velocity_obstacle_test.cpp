// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/velocity_obstacle.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/velocity_obstacle/testing/closest_approach.hpp"
#include "fairway/avoidance/velocity_obstacle/testing/random_scenes.hpp"

namespace fairway::velocity_obstacle {
namespace {

constexpr Horizons five_seconds{5.0, 1.0};
constexpr Horizons for_ever{1e9, 1.0};

RelativeCapsule disc(const Vec2& p, double radius, const Vec2& velocity = Vec2::Zero()) {
  return {.from = p, .to = p, .radius = radius, .velocity = velocity};
}

// R / d = 3 / 5: the legs are at sine 0.6 and cosine 0.8 to the line of sight
TEST(VelocityObstacle, IsAConeOfTheTangentsFromTheOthersVelocity) {
  const VelocityObstacle vo(disc({5.0, 0.0}, 3.0, {0.2, 0.1}), for_ever);
  EXPECT_LT((vo.apex() - Vec2(0.2, 0.1)).norm(), 1e-15);
  EXPECT_LT((vo.port_leg() - Vec2(0.8, -0.6)).norm(), 1e-15);
  EXPECT_LT((vo.starboard_leg() - Vec2(0.8, 0.6)).norm(), 1e-15);
  EXPECT_NEAR(vo.depth(vo.apex() + 7.0 * vo.port_leg()), 0.0, 1e-14);
  EXPECT_NEAR(vo.depth(vo.apex() + 7.0 * vo.starboard_leg()), 0.0, 1e-14);
  EXPECT_NEAR(vo.depth(vo.apex() + Vec2(2.0, 0.1)), 0.6 * 2.0 - 0.8 * 0.1, 1e-8);
  EXPECT_LT(vo.depth(vo.apex() - Vec2(1.0, 0.0)), 0.0);
}

TEST(VelocityObstacle, IsCutOffByTheDiscAsItLooksAtTheHorizon) {
  // p / T = 1.6, R / T = 0.4: 1.2 just does not get there
  const VelocityObstacle vo(disc({8.0, 0.0}, 2.0), five_seconds);
  EXPECT_NEAR(vo.depth({1.2, 0.0}), 0.0, 1e-15);
  EXPECT_NEAR(vo.depth({1.3, 0.0}), 0.1, 1e-15);
  EXPECT_NEAR(vo.depth({1.0, 0.0}), -0.2, 1e-15);
}

TEST(VelocityObstacle, IsWhatMeetsTheSolidWithinTheHorizon) {
  int inside = 0, outside = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    Rng rng = Rng{1}.stream("solid", i);
    const RelativeCapsule solid = i % 2 == 0 ? any_disc(rng) : any_wall(rng);
    const Horizons outlook{rng.uniform(0.5, 20.0), 1.0};
    const VelocityObstacle vo(solid, outlook);
    const Vec2 v = rng.uniform(0.0, 2.0) * any_direction(rng);
    const double gap = closest_approach(solid, v - solid.velocity, outlook.horizon) - solid.radius;
    if (std::fabs(gap) < 1e-6) continue;
    EXPECT_EQ(vo.depth(v) > 0.0, gap < 0.0) << i << " " << gap << " " << vo.depth(v);
    (gap < 0.0 ? inside : outside) += 1;
  }
  EXPECT_GT(inside, 3000);
  EXPECT_GT(outside, 3000);
}

/// The three kinds in turn, of discs and walls at random; every fifth overlaps own ship.
VelocityObstacle any_obstacle(std::uint64_t i, Rng& rng) {
  RelativeCapsule solid = i % 2 == 0 ? any_disc(rng) : any_wall(rng);
  if (i % 5 == 0) solid.radius = solid.from.norm() + rng.uniform(0.1, 1.0);
  const Horizons outlook{rng.uniform(0.5, 20.0), 1.0};
  const Vec2 own = rng.uniform(0.0, 2.0) * any_direction(rng);
  if (i % 3 == 0) return VelocityObstacle::reciprocal(solid, own, outlook);
  return i % 3 == 1 ? VelocityObstacle::hybrid(solid, own, outlook) : VelocityObstacle(solid, outlook);
}

TEST(VelocityObstacle, TheOutlineRunsAlongItsBoundary) {
  int cones = 0, overlapping = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Rng rng = Rng{5}.stream("outline", i);
    const VelocityObstacle vo = any_obstacle(i, rng);
    const Outline outline = vo.outline(3.0);
    const std::span<const Vec2> points = outline.view();
    Vec2 middle = Vec2::Zero();
    for (const Vec2& p : points) middle += p / static_cast<double>(points.size());
    EXPECT_GT(vo.depth(middle), 0.0) << i;
    if (points.size() == Outline::max_points) {
      ++cones;
      for (const Vec2& p : points) EXPECT_NEAR(vo.depth(p), 0.0, 1e-6) << i;
    } else {
      ++overlapping;
      ASSERT_EQ(points.size(), 4U);
      for (const std::size_t k : {0U, 3U}) EXPECT_NEAR(vo.depth(points[k]), 6.0, 1e-9) << i;
      for (const std::size_t k : {1U, 2U}) EXPECT_NEAR(vo.depth(points[k]), 0.0, 1e-9) << i;
    }
  }
  EXPECT_GT(cones, 1000);
  EXPECT_GT(overlapping, 100);
}

TEST(VelocityObstacle, WithoutAHorizonItIsThePrintedAngles) {
  int inside = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    Rng rng = Rng{2}.stream("angles", i);
    const RelativeCapsule solid = any_disc(rng);
    const VelocityObstacle vo(solid, for_ever);
    const Vec2 v = solid.velocity + rng.uniform(0.01, 2.0) * any_direction(rng);
    const double depth = vo.depth(v);
    if (std::fabs(depth) < 1e-7) continue;
    EXPECT_EQ(depth > 0.0, is_within_printed_angles(solid.from, solid.radius, v - solid.velocity)) << i;
    inside += depth > 0.0 ? 1 : 0;
  }
  EXPECT_GT(inside, 3000);
}

TEST(VelocityObstacle, EndsNowhereButAtItsBoundaries) {
  // along a line of velocities the sign of the depth changes only where one of them is met
  int changes = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Rng rng = Rng{3}.stream("boundary", i);
    const RelativeCapsule solid = i % 2 == 0 ? any_disc(rng) : any_wall(rng);
    const VelocityObstacle vo = i % 6 == 0 ? VelocityObstacle::hybrid(solid, {0.7, 0.2}, five_seconds)
                                           : VelocityObstacle(solid, five_seconds);
    Vec2 in = rng.uniform(0.0, 2.0) * any_direction(rng);
    Vec2 out = rng.uniform(0.0, 2.0) * any_direction(rng);
    if ((vo.depth(in) > 0.0) == (vo.depth(out) > 0.0)) continue;
    ++changes;
    if (vo.depth(in) < 0.0) std::swap(in, out);
    for (int halving = 0; halving < 60; ++halving) {
      const Vec2 middle = 0.5 * (in + out);
      (vo.depth(middle) > 0.0 ? in : out) = middle;
    }
    std::array<Boundary, VelocityObstacle::max_boundaries> boundaries;
    const std::size_t count = vo.boundaries(boundaries);
    double nearest_one = 1e9;
    for (std::size_t k = 0; k < count; ++k) {
      nearest_one = std::fmin(nearest_one, (nearest(boundaries[k], in) - in).norm());
    }
    EXPECT_LT(nearest_one, 1e-9) << i;
  }
  EXPECT_GT(changes, 300);
}

TEST(VelocityObstacle, UrgencyIsTheInverseOfTheTimeToContact) {
  const VelocityObstacle ahead(disc({8.0, 0.0}, 2.0), five_seconds);
  EXPECT_NEAR(ahead.urgency({2.0, 0.0}), 1.0 / 3.0, 1e-15);
  EXPECT_EQ(ahead.urgency({-1.0, 0.0}), 0.0);
  int meeting = 0, passing = 0;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    Rng rng = Rng{4}.stream("urgency", i);
    const RelativeCapsule solid = i % 2 == 0 ? any_disc(rng) : any_wall(rng);
    const Vec2 v = rng.uniform(0.05, 2.0) * any_direction(rng);
    const double urgency = VelocityObstacle(solid, five_seconds).urgency(v);
    const Vec2 w = v - solid.velocity;
    (urgency > 0.0 ? meeting : passing) += 1;
    if (urgency == 0.0) {
      EXPECT_GT(closest_approach(solid, w, 1e4), solid.radius - 1e-6) << i;
    } else if (urgency > 1e-3) {
      EXPECT_NEAR(closest_approach(solid, w, 1.0 / urgency), solid.radius, 1e-6) << i;
    }
  }
  EXPECT_GT(meeting, 500);
  EXPECT_GT(passing, 500);
}

TEST(VelocityObstacle, ReciprocalIsItsPrintedDefinition) {
  // eq. 7: v' is in RVO if 2 v' - v_u is in VO
  for (std::uint64_t i = 0; i < 5000; ++i) {
    Rng rng = Rng{5}.stream("rvo", i);
    RelativeCapsule solid = any_disc(rng);
    if (i % 10 == 0) solid.radius = 1.2 * solid.from.norm();
    const Vec2 own = rng.uniform(0.0, 1.5) * any_direction(rng);
    const Vec2 v = rng.uniform(0.0, 2.0) * any_direction(rng);
    const VelocityObstacle vo(solid, five_seconds);
    const VelocityObstacle rvo = VelocityObstacle::reciprocal(solid, own, five_seconds);
    EXPECT_NEAR(2.0 * rvo.depth(v), vo.depth(2.0 * v - own), 1e-12);
    EXPECT_LT((rvo.apex() - 0.5 * (own + solid.velocity)).norm(), 1e-15);
    EXPECT_NEAR(rvo.urgency(v), vo.urgency(2.0 * v - own), 1e-9);
  }
}

TEST(VelocityObstacle, HybridTakesTheLegOfEach) {
  // the legs are lines that VO and RVO have too: its apex is on both
  int cuts = 0;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    Rng rng = Rng{6}.stream("hrvo", i);
    const RelativeCapsule solid = any_disc(rng);
    const Vec2 own = rng.uniform(0.0, 1.5) * any_direction(rng);
    const VelocityObstacle vo(solid, five_seconds);
    const VelocityObstacle rvo = VelocityObstacle::reciprocal(solid, own, five_seconds);
    const VelocityObstacle hrvo = VelocityObstacle::hybrid(solid, own, five_seconds);
    const bool to_starboard = cross(solid.from, own - solid.velocity) > 0.0;
    const Vec2 kept = to_starboard ? rvo.starboard_leg() : rvo.port_leg();
    const Vec2 other = to_starboard ? rvo.port_leg() : rvo.starboard_leg();
    const double scale = 1.0 + hrvo.apex().norm();
    EXPECT_NEAR(cross(kept, hrvo.apex() - rvo.apex()), 0.0, 1e-12 * scale) << i;
    EXPECT_NEAR(cross(other, hrvo.apex() - vo.apex()), 0.0, 1e-12 * scale) << i;

    // and the cut meets the leg of RVO where that of RVO does
    const double tangent = std::sqrt(solid.from.squaredNorm() - solid.radius * solid.radius);
    const Vec2 cut = rvo.apex() + tangent / 10.0 * kept;
    EXPECT_NEAR(rvo.depth(cut), 0.0, 1e-12);
    if ((cut - hrvo.apex()).dot(kept) > 0.0) {
      EXPECT_NEAR(hrvo.depth(cut), 0.0, 1e-9 * scale) << i;
      ++cuts;
    }
  }
  EXPECT_GT(cuts, 1000);
}

TEST(VelocityObstacle, HeadToHeadTheHybridPassesToStarboard) {
  // p = 10 north, R = 2, both at 1 m/s: RVO's apex is 0, and to port reaches that of VO at -1
  const VelocityObstacle hrvo =
      VelocityObstacle::hybrid(disc({10.0, 0.0}, 2.0, {-1.0, 0.0}), {1.0, 0.0}, for_ever);
  EXPECT_LT(hrvo.depth({0.0, 0.01}), 0.0);
  EXPECT_GT(hrvo.depth({0.0, -0.01}), 0.0);
}

TEST(VelocityObstacle, WhoOverlapsIsToBeApartAfterOneInterval) {
  // 1.5 m apart, R = 2, 1 s: 0.5 m/s backwards; each does half of it
  const RelativeCapsule solid = disc({1.5, 0.0}, 2.0, {0.2, 0.0});
  const VelocityObstacle vo(solid, five_seconds);
  EXPECT_NEAR(vo.depth({-0.3, 0.7}), 0.0, 1e-15);
  EXPECT_NEAR(vo.depth({0.0, 0.0}), 0.3, 1e-15);
  const VelocityObstacle rvo = VelocityObstacle::reciprocal(solid, {0.0, 0.0}, five_seconds);
  EXPECT_NEAR(rvo.depth({-0.15, 0.7}), 0.0, 1e-15);
}

TEST(VelocityObstacle, FromExactlyTheSamePlaceTheWayIsTheParting) {
  RelativeCapsule solid = disc({0.0, 0.0}, 2.0);
  solid.parting = {0.0, 1.0};
  const VelocityObstacle vo(solid, five_seconds);
  EXPECT_NEAR(vo.depth({0.0, 2.0}), 0.0, 1e-15);
  EXPECT_NEAR(vo.depth({2.0, 0.0}), 2.0, 1e-15);
}

TEST(VelocityObstacle, FromInsideASolidTheWayIsOutThroughTheNearestSide) {
  RelativeCapsule side = disc({-1.0, 0.0}, 1.0);
  side.within = true;
  EXPECT_NEAR(VelocityObstacle(side, five_seconds).depth({-2.0, 3.0}), 0.0, 1e-15);
}

TEST(VelocityObstacle, PointsHaveNone) {
  const VelocityObstacle vo(disc({5.0, 0.0}, 0.0), five_seconds);
  EXPECT_LE(vo.depth({2.0, 0.0}), 0.0);
  EXPECT_LE(VelocityObstacle::hybrid(disc({5.0, 0.0}, 0.0), {1.0, 0.0}, five_seconds).depth({2.0, 0.0}), 0.0);
}

}  // namespace
}  // namespace fairway::velocity_obstacle
