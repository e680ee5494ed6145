// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/teb/homotopy.hpp"

#include <gtest/gtest.h>

#include "fairway/planning/teb/testing/courses.hpp"

namespace fairway::teb {
namespace {

using courses::disc;

TebParams dynamic_params() {
  TebParams params;
  params.include_dynamic_obstacles = true;
  return params;
}

Band along(const TebParams& params, const std::vector<Vec2>& path) {
  return band_along(params, path, {path.front(), 0.0}, {path.back(), 0.0});
}

TEST(Homotopy, WaysOnOneSideAreAlikeAndOnTwoAreNot) {
  const TebParams params{.include_dynamic_obstacles = false};
  const std::vector<BandObstacle> barriers{{disc(3, 0), 0.75}, {disc(6, 1), 0.75}};
  const auto turns = [&](double at_first, double at_second) {
    return signature_of(barriers, along(params, {{0, 0}, {3, at_first}, {6, at_second}, {9, 0}}));
  };
  EXPECT_TRUE(are_alike(params, turns(2, 3), turns(1, 1.5)));
  EXPECT_TRUE(are_alike(params, turns(-2, -3), turns(-1, 0.5)));
  EXPECT_FALSE(are_alike(params, turns(2, 3), turns(-2, 3)));
  EXPECT_FALSE(are_alike(params, turns(2, 3), turns(2, 0)));
  EXPECT_FALSE(are_alike(params, turns(-2, 3), turns(2, 0)));
}

TEST(Homotopy, AWayAllRoundABarrierIsOfAnotherClass) {
  const TebParams params{.include_dynamic_obstacles = false};
  const std::vector<BandObstacle> barriers{{disc(3, 0), 0.75}};
  const Signature past = signature_of(barriers, along(params, {{0, 0}, {3, 2}, {6, 0}}));
  const Signature round =
      signature_of(barriers, along(params, {{0, 0}, {3, 2}, {5, 0}, {3, -2}, {1, 0}, {3, 2}, {6, 0}}));
  EXPECT_FALSE(are_alike(params, past, round));
  EXPECT_NEAR(std::abs(past[0] - round[0]), 1.0, 1e-12);
}

TEST(Homotopy, ManyBarriersDoNotHideOne) {
  // the original's sum of 1 / products of distances vanishes with so many
  const TebParams params{.include_dynamic_obstacles = false};
  std::vector<BandObstacle> barriers;
  for (int i = 0; i < 100; ++i) barriers.emplace_back(disc(3.0 + 0.1 * i, 20.0), 0.75);
  barriers.emplace_back(disc(3, 0), 0.75);
  const Signature port = signature_of(barriers, along(params, {{0, 0}, {3, -2}, {6, 0}}));
  const Signature starboard = signature_of(barriers, along(params, {{0, 0}, {3, 2}, {6, 0}}));
  EXPECT_FALSE(are_alike(params, port, starboard));
}

TEST(Homotopy, PassingAheadOfAMoverIsNotPassingAsternOfIt) {
  // it crosses from port; own ship is at 3 m after 7.5 s
  const TebParams params = dynamic_params();
  const auto past = [&](double crosses_after) {
    const Track track{.position = {3, -0.5 * crosses_after, 0}, .velocity = {0, 0.5, 0}, .radius = 0.75};
    const std::vector<BandObstacle> barriers{{track, 0.75, true}};
    return signature_of(barriers, along(params, {{0, 0}, {6, 0}}));
  };
  EXPECT_TRUE(are_alike(params, past(10), past(12)));
  EXPECT_TRUE(are_alike(params, past(5), past(3)));
  EXPECT_FALSE(are_alike(params, past(10), past(5)));
}

TEST(Homotopy, TurnsAboutAMoverBelowTheThresholdAreNoSide) {
  const TebParams params = dynamic_params();
  EXPECT_TRUE(are_alike(params, {0.05}, {-0.4}));
  EXPECT_FALSE(are_alike(params, {0.2}, {-0.4}));
}

TEST(Homotopy, TheRoadmapFindsBothSidesOfADisc) {
  const TebParams params{.include_dynamic_obstacles = false};
  const std::vector<BandObstacle> barriers{{disc(1.5, 0), 0.75}};
  int both = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng{seed};
    std::vector<Signature> known;
    const auto ways = ways_of_new_classes(params, barriers, {0, 0}, {3, 0}, 5, known, rng);
    ASSERT_EQ(ways.size(), known.size());
    if (ways.size() != 2) continue;
    ++both;
    EXPECT_FALSE(are_alike(params, known[0], known[1]));
    for (const auto& way : ways) {
      EXPECT_EQ(way.front(), Vec2(0, 0));
      EXPECT_EQ(way.back(), Vec2(3, 0));
    }
  }
  EXPECT_GE(both, 18) << "fifteen points at random miss one side now and then";
}

TEST(Homotopy, TheRoadmapLeavesOutClassesThatAreKnownAndKeepsToTheirNumber) {
  const TebParams params{.include_dynamic_obstacles = false};
  const std::vector<BandObstacle> barriers{{disc(1.5, 0), 0.75}};
  std::vector<Signature> known{signature_of(barriers, along(params, {{0, 0}, {1.5, 2}, {3, 0}}))};
  Rng rng{3};
  const auto ways = ways_of_new_classes(params, barriers, {0, 0}, {3, 0}, 5, known, rng);
  ASSERT_EQ(ways.size(), 1U);
  EXPECT_LT(ways[0][1].y(), 0.0);

  known.clear();
  EXPECT_EQ(ways_of_new_classes(params, barriers, {0, 0}, {3, 0}, 1, known, rng).size(), 1U);
  known.clear();
  EXPECT_TRUE(ways_of_new_classes(params, barriers, {0, 0}, {3, 0}, 0, known, rng).empty());
}

TEST(Homotopy, WithoutAWayThereIsNoClass) {
  const TebParams params{.include_dynamic_obstacles = false};
  const std::vector<BandObstacle> around_the_end{{disc(3, 0, 1.0), 0.75}};
  const std::vector<BandObstacle> wall{
      {Obstacle{.kind = Obstacle::Kind::segment, .from = {1.5, -9, 0}, .to = {1.5, 9, 0}}, 0.75}};
  for (const auto& barriers : {around_the_end, wall}) {
    Rng rng{3};
    std::vector<Signature> known;
    EXPECT_TRUE(ways_of_new_classes(params, barriers, {0, 0}, {3, 0}, 5, known, rng).empty());
  }
}

}  // namespace
}  // namespace fairway::teb
