// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "fairway/avoidance/velocity_obstacle/testing/closest_approach.hpp"
#include "fairway/avoidance/velocity_obstacle/testing/random_scenes.hpp"

namespace fairway::velocity_obstacle {
namespace {

constexpr Horizons outlook{5.0, 1.0};

/// A solid, and who gives way.
struct Neighbour {
  RelativeCapsule solid;
  bool shares;
};

/// What is to be decided, with its parts as they are defined.
struct Question {
  std::vector<Neighbour> neighbours;
  std::vector<VelocityObstacle> obstacles;
  Ownship own;
  Limits limits;
  Wish wish;

  ReachableSet reachable() const { return {own, limits, outlook.interval}; }
  ChosenVelocity answer() const { return choose(obstacles, reachable(), wish); }

  bool is_clear(const Vec2& v, double slack) const {
    return std::all_of(neighbours.begin(), neighbours.end(), [&](const Neighbour& n) {
      const Vec2 asked = n.shares ? Vec2{2.0 * v - own.velocity.head<2>()} : v;
      return closest_approach(n.solid, asked - n.solid.velocity, outlook.horizon) >= n.solid.radius - slack;
    });
  }
};

/// Up to 8 discs and 2 walls; all sorts of limits.
Question any_question(std::uint64_t i) {
  Rng rng = Rng{1}.stream("question", i);
  Question q;
  q.own.yaw = rng.uniform(-pi, pi);
  q.own.velocity.head<2>() = rng.uniform(0.0, 1.0) *
                             turned({std::cos(q.own.yaw), std::sin(q.own.yaw)}, 0.98, rng.uniform(-0.2, 0.2));
  q.limits.max_speed = 1.5;
  if (i % 2 == 1) q.limits.max_acceleration = rng.uniform(0.1, 1.5);
  if (i % 4 >= 2) q.limits.max_turn_rate = rng.uniform(0.0, 3.0);
  q.wish.velocity = rng.uniform(0.0, 1.4) * any_direction(rng);
  q.wish.ahead = q.wish.velocity.normalized();
  q.wish.starboard_bias = i % 3 == 0 ? 0.0 : rng.uniform(0.0, 0.5);
  q.wish.collision_weight = 10.0;
  for (std::uint64_t k = 0; k < 1 + rng.index(8); ++k)
    q.neighbours.push_back({any_disc(rng), rng.index(2) == 0});
  for (std::uint64_t k = 0; k < rng.index(3); ++k) q.neighbours.push_back({any_wall(rng), false});
  for (const Neighbour& n : q.neighbours) {
    q.obstacles.push_back(n.shares ? VelocityObstacle::reciprocal(n.solid, q.own.velocity.head<2>(), outlook)
                                   : VelocityObstacle(n.solid, outlook));
  }
  return q;
}

TEST(ChosenVelocity, IsNoWorseThanAnyOfManySamplesAndAlwaysClear) {
  constexpr int side = 120;
  int feasible = 0, infeasible = 0, deviating = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Question q = any_question(i);
    const ReachableSet reachable = q.reachable();
    const ChosenVelocity choice = q.answer();
    EXPECT_TRUE(reachable.contains(choice.velocity, 1e-8)) << i;
    (choice.is_feasible ? feasible : infeasible) += 1;
    if (choice.is_feasible) {
      EXPECT_TRUE(q.is_clear(choice.velocity, 1e-6)) << i;
      deviating += (choice.velocity - q.wish.velocity).norm() > 1e-3 ? 1 : 0;
    }

    // evenly over all speeds, and where acceleration is limited over what that leaves
    const double cost = choice.is_feasible ? q.wish.cost(choice.velocity) : Limits::none;
    const double extent = std::min(q.limits.max_speed, reachable.max_change());
    const Vec2 middle = extent < q.limits.max_speed ? reachable.middle() : Vec2{Vec2::Zero()};
    for (int row = 0; row <= side; ++row) {
      for (int column = 0; column <= side; ++column) {
        const Vec2 v = middle + extent * Vec2{2.0 * row / side - 1.0, 2.0 * column / side - 1.0};
        if (q.wish.cost(v) >= cost - 1e-8 || !reachable.contains(v, 0.0)) continue;
        EXPECT_FALSE(q.is_clear(v, 0.0)) << i << " cheaper by " << cost - q.wish.cost(v);
      }
    }
  }
  EXPECT_GT(infeasible, 50);
  EXPECT_GT(deviating, 300);
  EXPECT_GT(feasible, 500);
}

TEST(ChosenVelocity, TakesTheWishIfItIsClear) {
  Question q = any_question(0);
  q.obstacles.clear();
  EXPECT_EQ(q.answer().velocity, q.wish.velocity);
  EXPECT_TRUE(q.answer().is_feasible);
}

/// Northbound at 1 m/s, of at most 1.5 m/s, towards a disc of R = 3 m at 5 m that stands.
Question dead_ahead() {
  Question q;
  q.own.velocity = {1.0, 0.0, 0.0};
  q.limits.max_speed = 1.5;
  q.wish = {.velocity = {1.0, 0.0}, .ahead = {1.0, 0.0}, .starboard_bias = 1e-3, .collision_weight = 10.0};
  const RelativeCapsule solid{.from = {5.0, 0.0}, .to = {5.0, 0.0}, .radius = 3.0};
  q.obstacles = {VelocityObstacle(solid, {1e9, 1.0})};
  return q;
}

TEST(ChosenVelocity, OfTwoTangentsThatAreEquallyFarItTakesStarboard) {
  // the legs are at cosine 0.8, sine 0.6; the wish's feet on them at 0.8 along
  EXPECT_LT((dead_ahead().answer().velocity - Vec2(0.64, 0.48)).norm(), 1e-14);
}

TEST(ChosenVelocity, ABiasOutweighsADeviationThatIsLittleLarger) {
  Question q = dead_ahead();
  q.wish.velocity = turned({1.0, 0.0}, std::cos(0.01), -std::sin(0.01));
  q.wish.ahead = q.wish.velocity;
  EXPECT_LT(q.answer().velocity.y(), 0.0);  // 0.593 to port, 0.607 to starboard
  q.wish.starboard_bias = 0.05;
  EXPECT_GT(q.answer().velocity.y(), 0.0);
}

TEST(ChosenVelocity, StaysWithinWhatAccelerationAllows) {
  // 0.3 m/s of change do not reach the leg 0.6 m/s away: nothing is clear, and slowing down gives most time
  Question q = dead_ahead();
  q.limits.max_acceleration = 0.3;
  const ChosenVelocity choice = q.answer();
  EXPECT_FALSE(choice.is_feasible);
  EXPECT_NEAR((choice.velocity - Vec2(1.0, 0.0)).norm(), 0.3, 1e-9);
  EXPECT_LT(choice.velocity.x(), 0.9);
}

TEST(ChosenVelocity, WithoutAnyLimitItStillAnswers) {
  Question q = dead_ahead();
  q.limits = {};
  EXPECT_LT((q.answer().velocity - Vec2(0.64, 0.48)).norm(), 1e-14);
  const RelativeCapsule here{.from = {0.0, 0.0}, .to = {0.0, 0.0}, .radius = 3.0};
  q.obstacles = {VelocityObstacle(here, {5.0, 1.0})};
  EXPECT_GT(q.answer().velocity.x(), 3.0 - 1e-9);
}

TEST(ChosenVelocity, PressedFromAllSidesItGainsTime) {
  // eight at 3.5 m, R = 2, closing at 1 m/s: any way is 1.5 s of time at rest and less elsewhere
  Question q = dead_ahead();
  q.own.velocity = Vec3::Zero();
  q.obstacles.clear();
  for (int k = 0; k < 8; ++k) {
    const Vec2 out = turned({1.0, 0.0}, std::cos(pi / 4 * k), std::sin(pi / 4 * k));
    const RelativeCapsule solid{.from = 3.5 * out, .to = 3.5 * out, .radius = 2.0, .velocity = -out};
    q.obstacles.push_back(VelocityObstacle(solid, outlook));
  }
  const ChosenVelocity choice = q.answer();
  EXPECT_FALSE(choice.is_feasible);
  EXPECT_LT(choice.velocity.norm(), 0.3);
}

TEST(ChosenVelocity, AsManyAsThereIsRoomForAreAnswered) {
  Rng rng{9};
  Question q = dead_ahead();
  q.obstacles.clear();
  while (q.obstacles.size() < max_obstacles) q.obstacles.emplace_back(any_wall(rng), outlook);
  const ChosenVelocity choice = q.answer();
  EXPECT_TRUE(choice.velocity.allFinite());
  EXPECT_LE(choice.velocity.norm(), 1.5 + 1e-8);
}

}  // namespace
}  // namespace fairway::velocity_obstacle
