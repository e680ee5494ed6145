// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/tangent.hpp"

#include <gtest/gtest.h>

#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::avoa_improved {
namespace {

TEST(AvoaImprovedTangent, TouchesBothCirclesInTheWayThatTheyAreGoneRound) {
  Rng rng{5};
  int found = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto turn = [&] {
      const Vec2 centre{rng.uniform(-5, 5), rng.uniform(-5, 5)};
      const double radius = rng.index(4) == 0 ? 0.0 : rng.uniform(0, 2);
      return Turn{centre, radius, rng.index(2) == 0 ? Side::to_port : Side::to_starboard};
    };
    const Turn from = turn();
    const Turn to = turn();
    const auto line = tangent(from, to);
    if (!line) continue;
    ++found;
    const Vec2 begin = from.at(line->departure);
    const Vec2 end = to.at(line->arrival);
    const Vec2 along{std::cos(line->heading), std::sin(line->heading)};
    EXPECT_LT((begin + line->length * along - end).norm(), 1e-9);
    const Vec2 to_starboard{-along.y(), along.x()};
    EXPECT_NEAR((from.centre - begin).dot(to_starboard), sign_of(from.side) * from.radius, 1e-9);
    EXPECT_NEAR((to.centre - end).dot(to_starboard), sign_of(to.side) * to.radius, 1e-9);
  }
  EXPECT_GT(found, 1500);
}

TEST(AvoaImprovedTangent, IsNoneBetweenCirclesWithinOneAnother) {
  const Turn outer{{0, 0}, 2.0, Side::to_port};
  EXPECT_FALSE(tangent(outer, {{0.5, 0}, 1.0, Side::to_port}));
  EXPECT_FALSE(tangent(outer, {{2.5, 0}, 1.0, Side::to_starboard}));  // they cross: no line between
  EXPECT_TRUE(tangent(outer, {{2.5, 0}, 1.0, Side::to_port}));
}

TEST(AvoaImprovedTangent, ASweepIsCountedInTheWayOfTheTurn) {
  const Turn starboard{{0, 0}, 1.0, Side::to_starboard};
  const Turn port{{0, 0}, 1.0, Side::to_port};
  EXPECT_NEAR(starboard.sweep(0.1, 0.6), 0.5, 1e-12);
  EXPECT_NEAR(port.sweep(0.1, 0.6), 2 * pi - 0.5, 1e-12);
  EXPECT_EQ(port.sweep(0.1, 0.1 + 1e-12), 0.0);
}

}  // namespace
}  // namespace fairway::avoa_improved
