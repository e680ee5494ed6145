// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/capsule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "fairway/core/rng.hpp"

namespace fairway::avoa_improved {
namespace {

Vec2 somewhere(Rng& rng) { return {rng.uniform(-5, 5), rng.uniform(-5, 5)}; }

Obstacle ball(double north, double east, double radius = 0.3) {
  return {.kind = Obstacle::Kind::sphere, .position = {north, east, 0.0}, .radius = radius};
}

TEST(AvoaImprovedSolid, IsAsFarFromALineAsTheNearestOfManyPointsOnIt) {
  Rng rng{3};
  for (int i = 0; i < 500; ++i) {
    const Vec2 from = somewhere(rng);
    const Capsule solid{from, i % 3 == 0 ? from : somewhere(rng), 0.3};
    const Vec2 p = somewhere(rng);
    const Vec2 q = somewhere(rng);
    double nearest = 1e9;
    for (int k = 0; k <= 2000; ++k)
      nearest = std::fmin(nearest, distance_to_axis(solid, p + (k / 2000.0) * (q - p)));
    EXPECT_LE(distance_to_axis(solid, p, q), nearest + 1e-12);
    EXPECT_NEAR(distance_to_axis(solid, p, q), nearest, 0.005);  // samples are 7 mm apart at most
  }
}

TEST(AvoaImprovedSolid, OfMoreThanFitTheNearestAreKeptNearestFirst) {
  Rng rng{4};
  Capsules solids;
  std::vector<double> all;
  for (int i = 0; i < 300; ++i) {
    const Vec2 p = somewhere(rng);
    solids.add_near({p, p, 0.1}, Vec2::Zero());
    all.push_back(p.norm());
  }
  std::ranges::sort(all);
  ASSERT_EQ(solids.view().size(), Capsules::capacity);
  for (std::size_t i = 0; i < Capsules::capacity; ++i) EXPECT_EQ(solids.view()[i].from.norm(), all[i]);
}

TEST(AvoaImprovedSolid, APolygonIsItsEdges) {
  const std::vector<Vec3> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  std::vector<Capsule> edges;
  for_each_solid({.kind = Obstacle::Kind::polygon, .vertices = square},
                 [&](const Capsule& edge) { edges.push_back(edge); });
  ASSERT_EQ(edges.size(), 4U);
  EXPECT_EQ(edges[3].from, Vec2(0, 2));
  EXPECT_EQ(edges[3].to, Vec2(0, 0));
}

TEST(AvoaImprovedChart, RemembersWhatIsOutOfSightAndTakesWhatIsNearForTheSame) {
  std::vector<Obstacle> seen{ball(5, 0), ball(5, 1)};
  Situation s;
  s.obstacles = seen;
  Chart chart;
  chart.enter(s, true, 0.2);
  seen = {ball(5.1, 0)};
  s.obstacles = seen;
  chart.enter(s, true, 0.2);
  ASSERT_EQ(chart.view().size(), 2U);
  EXPECT_EQ(chart.view()[0].from, Vec2(5, 1));  // by nearness: 4.80 m against 4.80 m and a bit
  EXPECT_EQ(chart.view()[1].from, Vec2(5.1, 0));
  chart.enter(s, false, 0.2);
  EXPECT_EQ(chart.view().size(), 1U);
}

}  // namespace
}  // namespace fairway::avoa_improved
