// SPDX-License-Identifier: Apache-2.0
// What stands on the chart: references keep off it, whoever departs and wherever somebody stops.
#include <gtest/gtest.h>

#include <vector>

#include "fairway/avoidance/pledge/agreement.hpp"
#include "fairway/avoidance/pledge/testing/fleet.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::pledge {
namespace {

constexpr double off = 1.5 + 1.0;  // sphere and tube [m]

Obstacle rock(const Vec3& place, double radius) {
  return {.kind = Obstacle::Kind::sphere, .position = place, .radius = radius};
}
Obstacle wall(const Vec3& from, const Vec3& to) {
  return {.kind = Obstacle::Kind::segment, .from = from, .to = to};
}

struct Pier {
  std::array<Vec3, 4> corners;
  Pier(double north, double east, double length, double width)
      : corners{Vec3{north, east, 0},
                {north + length, east, 0},
                {north + length, east + width, 0},
                {north, east + width, 0}} {}
  Obstacle obstacle() const { return {.kind = Obstacle::Kind::polygon, .vertices = corners}; }
};

double nearest(const std::vector<Obstacle>& chart, const Vec3& place) {
  double least = never;
  for (const Obstacle& obstacle : chart) least = std::min(least, nearest_point(obstacle, place).distance);
  return least;
}

TEST(PledgeObstacles, WhatKeepsOffIsWhatManySamplesKeep) {
  Rng rng = Rng{1}.stream("obstacles");
  const auto place = [&] { return Vec3{rng.uniform(-20, 20), rng.uniform(-20, 20), rng.uniform(0, 20)}; };
  int kept = 0, refused = 0;
  for (int i = 0; i < 1500; ++i) {
    const Pier pier{rng.uniform(-15, 15), rng.uniform(-15, 15), 6.0, 3.0};
    const std::vector<Obstacle> chart{i % 3 == 0   ? rock(place(), rng.uniform(0.5, 5))
                                      : i % 3 == 1 ? wall(place(), place())
                                                   : pier.obstacle()};
    Plan plan{.epoch = {.tenths = 100}, .scale = static_cast<std::uint8_t>(i % 4)};
    const Member member = crossing(place(), place());
    if (nearest(chart, member.anchor) < off) continue;
    const Reference way =
        reference_of(member, plan, Code::of(static_cast<std::uint8_t>(rng.uniform(0, 256))));
    double least = never;
    for (int k = 0; 0.02 * k < way.end(); ++k) least = std::min(least, nearest(chart, way.at(0.02 * k)));
    if (std::fabs(least - off) < 0.03) continue;
    EXPECT_EQ(keeps_off(way, chart, off), least > off) << i << ", " << least;
    ++(least > off ? kept : refused);
  }
  EXPECT_GT(kept, 100);
  EXPECT_GT(refused, 100);
}

TEST(PledgeObstacles, WhoLiesTooNearToOneGoesAwayFromItAndNotPastIt) {
  const std::vector<Obstacle> chart{rock({0, 0, 5}, 2.0)};
  const auto straight = [](const Vec3& to) {
    return reference_of(crossing({-4, 0, 5}, to), Plan{.epoch = {.tenths = 0}}, Code{});
  };
  EXPECT_TRUE(keeps_off(straight({-20, 0, 5}), chart, off));
  EXPECT_FALSE(keeps_off(straight({20, 0, 5}), chart, off));
}

/// Groups that cross among what is drawn, half of their words lost.
TEST(PledgeObstacles, AGroupKeepsOffThemAndArrives) {
  int rounds = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Rng rng = Rng{seed}.stream("fleet");
    Fleet fleet{cube(rng), 3.2};
    const double loss = seed % 2 == 0 ? 0.5 : 0.0;
    std::vector<Obstacle> chart;
    while (chart.size() < 3) {
      const std::vector<Obstacle> one{
          rock({rng.uniform(-5, 5), rng.uniform(-5, 5), rng.uniform(3, 17)}, rng.uniform(0.5, 2.0))};
      const bool is_clear = std::ranges::all_of(
          fleet.places, [&](const Vec3& place) { return nearest(one, place) > off + 0.1; });
      if (is_clear) chart.push_back(one[0]);
    }
    for (std::vector<Obstacle>& own : fleet.charts) own = chart;
    double least = never;
    while (!fleet.is_done() && fleet.time < 2000.0) {
      fleet.go_on([&](std::size_t, std::size_t) { return rng.uniform(0, 1) >= loss; });
      for (const Vec3& place : fleet.places) least = std::min(least, nearest(chart, place));
    }
    EXPECT_TRUE(fleet.is_done()) << "seed " << seed;
    EXPECT_GE(fleet.least, 5.0) << "seed " << seed;
    EXPECT_GE(least, off) << "seed " << seed;
    rounds += least < off + 0.5 ? 1 : 0;
  }
  EXPECT_GT(rounds, 3) << "or nothing was in the way";
}

TEST(PledgeObstacles, RoundAWallAndRoundAPierLeadWiderRings) {
  const Pier pier{-2.0, -12.0, 4.0, 24.0};
  for (const std::vector<Obstacle>& chart :
       {std::vector{wall({0, -12, 5}, {0, 12, 5})}, std::vector{pier.obstacle()}}) {
    Fleet fleet{{crossing({-25, -3, 5}, {25, -3, 5}), crossing({25, 4, 5}, {-25, 4, 5})}, 3.0};
    for (std::vector<Obstacle>& own : fleet.charts) own = chart;
    double least = never;
    while (!fleet.is_done() && fleet.time < 600.0) {
      fleet.go_on(always);
      for (const Vec3& place : fleet.places) least = std::min(least, nearest(chart, place));
    }
    EXPECT_TRUE(fleet.is_done());
    EXPECT_GE(least, off);
    EXPECT_GE(fleet.least, 5.0);
  }
}

// A5 of README.md: another chart costs liveness, not safety.
TEST(PledgeObstacles, NobodyGoesByAPlanThatLeadsItTooNearToWhatItsOwnChartShows) {
  Fleet fleet{three_in_a_plane(), 3.0};
  const Obstacle only_here = rock({1.0, 0.5, 5.0}, 4.0);
  fleet.charts[2] = {only_here};
  double least = never;
  while (!fleet.is_done() && fleet.time < 600.0) {
    fleet.go_on(always);
    least = std::min(least, nearest_point(only_here, fleet.places[2]).distance);
  }
  EXPECT_GE(least, off);
  EXPECT_GE(fleet.least, 5.0);
}

TEST(PledgeObstacles, WhoseDestinationIsHemmedInStaysAndTheOthersGo) {
  Fleet fleet{three_in_a_plane(), 3.0};
  const Obstacle there = rock(fleet.members[1].member(1).destination, 3.0);
  for (std::vector<Obstacle>& own : fleet.charts) own = {there};
  while (fleet.time < 300.0) fleet.go_on(always);
  EXPECT_EQ(fleet.members[0].status(), Status::arrived);
  EXPECT_EQ(fleet.members[1].status(), Status::held);
  EXPECT_EQ(fleet.members[2].status(), Status::arrived);
}

}  // namespace
}  // namespace fairway::pledge
