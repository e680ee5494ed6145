// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/evasion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "fairway/core/envelope.hpp"

namespace fairway::pledge {
namespace {

constexpr double apart = 4.1, turn = 5.0;  // [m], to turn round [s]
const Envelope able{.ahead = 0.6, .up = 0.3, .down = 0.3};

Situation at_depth(double depth) {
  Situation s;
  s.own.position = {0.0, 0.0, depth};
  s.own.radius = 1.5;
  s.limits.max_speed = 0.6;
  s.limits.max_climb_rate = 0.3;
  s.envelope = &able;
  return s;
}

Reference way(const std::vector<Knot>& knots) {
  Reference all;
  for (const Knot& knot : knots) all.add(knot);
  return all;
}

std::optional<Vec3> best(const Situation& s, const std::vector<Reference>& others, double turning = turn) {
  Evasion evasion{s, turning};
  for (const Reference& other : others) evasion.avoid(other, apart);
  return evasion.best();
}

/// How near they come to own ship within so many seconds, if that goes as it is told each second.
double least_within(Situation& s, double seconds, const std::vector<Reference>& others) {
  double least = never;
  while (s.time < seconds) {
    s.own.velocity = best(s, others).value_or(Vec3::Zero());
    s.own.position += s.own.velocity;
    s.time += 1.0;
    for (const Reference& other : others) least = std::min(least, (s.own.position - other.at(s.time)).norm());
  }
  return least;
}

TEST(Evasion, HoldsWhereNobodyComesNear) {
  Situation s = at_depth(10.0);
  EXPECT_FALSE(best(s, {}));
  EXPECT_FALSE(best(s, {Reference{Vec3{0.0, 4.2, 10.0}}}));
  EXPECT_FALSE(best(s, {way({{0.0, {5.0, -20.0, 10.0}}, {60.0, {5.0, 20.0, 10.0}}})}));
}

TEST(Evasion, GetsOutOfTheWayOfWhoTurnsTowardsItBeforeThatTurns) {
  Situation s = at_depth(10.0);
  const Reference corner =
      way({{0.0, {9.0, -8.0, 10.0}}, {20.0, {9.0, 0.0, 10.0}}, {60.0, {-9.0, 0.0, 10.0}}});
  EXPECT_GT(least_within(s, 60.0, {corner}), apart - 0.3);
  s = at_depth(10.0);
  s.time = 15.0;
  EXPECT_TRUE(best(s, {corner})) << "five seconds before the corner";
}

// A hull drives it from where it lies. Ahead the way is longer, to turn it has no time, up it cannot go, and
// below somebody passes, who would be gone before it comes there.
TEST(Evasion, DoesNotGoToWhereAnotherMayHaveStopped) {
  const Reference hull = way({{0.0, {-14.0, 0.0, 10.0}}, {60.0, {16.0, 0.0, 10.0}}});
  const Reference below = way({{0.0, {0.0, 1.0, 14.2}}, {60.0, {0.0, 61.0, 14.2}}});
  Situation s = at_depth(10.0);
  s.limits.min_depth = 9.5;
  const auto alone = best(s, {hull}, 1000.0), above_it = best(s, {hull, below}, 1000.0);
  ASSERT_TRUE(alone && above_it);
  EXPECT_NEAR(alone->z(), 0.3, 1e-9);
  EXPECT_NEAR(above_it->x(), 0.6, 1e-9);
}

TEST(Evasion, CannotGetOutThroughTheSurface) {
  Situation s = at_depth(0.0);
  const auto velocity = best(s, {way({{0.0, {0.0, 0.0, 6.0}}, {40.0, {0.0, 0.0, 0.0}}})});
  ASSERT_TRUE(velocity);
  EXPECT_GT(velocity->head<2>().norm(), 0.1);
}

TEST(Evasion, KeepsOffWhatStands) {
  const Reference hull = way({{0.0, {-9.0, 0.0, 10.0}}, {60.0, {9.0, 0.0, 10.0}}});
  Situation s = at_depth(10.0);
  const std::array walls{Obstacle{.position = {0.0, 0.0, 14.0}, .radius = 2.0},
                         Obstacle{.position = {0.0, 0.0, 6.0}, .radius = 2.0}};
  s.obstacles = walls;
  EXPECT_GT(least_within(s, 60.0, {hull}), apart - 1.0);
  for (const Obstacle& wall : walls)
    EXPECT_GT(nearest_point(wall, s.own.position).distance, s.own.radius - 0.2);
}

}  // namespace
}  // namespace fairway::pledge
