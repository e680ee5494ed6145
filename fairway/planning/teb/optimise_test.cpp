// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/teb/optimise.hpp"

#include <gtest/gtest.h>

#include "fairway/core/angles.hpp"
#include "fairway/planning/teb/testing/courses.hpp"

namespace fairway::teb {
namespace {

using courses::disc;

Band straight(const TebParams& params, double length) {
  const std::vector<Vec2> path{{0, 0}, {length, 0}};
  return band_along(params, path, {{0, 0}, 0.0}, {{length, 0}, 0.0});
}

std::vector<BandObstacle> barriers_of(std::initializer_list<Obstacle> obstacles) {
  std::vector<BandObstacle> barriers;
  for (const Obstacle& obstacle : obstacles) barriers.emplace_back(obstacle, 0.75);
  return barriers;
}

double clearance(std::span<const BandObstacle> barriers, const Band& band) {
  double least = 1e9;
  for (std::size_t i = 0; i < band.size(); ++i) {
    for (const BandObstacle& barrier : barriers)
      least = std::fmin(least, barrier.from(band.position(i)).distance);
  }
  return least;
}

/// As in closed loop: again and again from the same start.
Cost settled(const TebParams& params, std::span<const BandObstacle> barriers, Band& band) {
  Cost cost;
  for (int i = 0; i < 10; ++i) cost = optimise(params, barriers, 0.0, 0.0, band);
  return cost;
}

/// Every number that a limit is about, along a band from rest to rest.
void expect_within_limits(const TebParams& params, const Band& band) {
  const double margin = params.penalty_epsilon_ratio;
  Twist before{};
  for (std::size_t i = 0; i + 1 < band.size(); ++i) {
    ASSERT_GT(band.time(i), 0.0);
    const Twist m = motion_between(band.knots[i].data());
    EXPECT_LE(m.speed, params.max_vel_x_mps + margin);
    EXPECT_GE(m.speed, -params.max_vel_x_backwards_mps - margin);
    EXPECT_LE(std::abs(m.yaw_rate), params.max_vel_theta_radps + margin);
    const double time = i == 0 ? band.time(0) : 0.5 * (band.time(i - 1) + band.time(i));
    // the costs are soft: with its small weight the acceleration goes 0.03 m/s2 beyond the margin
    EXPECT_LE(std::abs(m.speed - before.speed) / time, params.acc_lim_x_mps2 + margin + 0.04) << i;
    before = m;
  }
}

TEST(Optimise, InOpenWaterTheBandIsStraightAndKeepsTheLimits) {
  for (const double speed : {0.4, 1.5}) {
    TebParams params;
    params.max_vel_x_mps = speed;
    Band band = straight(params, 3.0);
    settled(params, {}, band);
    expect_within_limits(params, band);
    for (std::size_t i = 0; i < band.size(); ++i) EXPECT_NEAR(band.position(i).y(), 0.0, 1e-9);
  }
}

TEST(Optimise, ADiscBesideTheWayIsPassedAtTheLeastDistance) {
  TebParams params;
  params.max_vel_x_mps = 1.5;
  const auto barriers = barriers_of({disc(4.0, 0.4)});
  Band band = straight(params, 8.0);
  settled(params, barriers, band);
  expect_within_limits(params, band);
  EXPECT_GT(clearance(barriers, band), params.min_obstacle_dist_m);
  EXPECT_LT(clearance(barriers, band), params.min_obstacle_dist_m + params.penalty_epsilon_ratio + 0.01);
  for (std::size_t i = 0; i < band.size(); ++i)
    EXPECT_LT(band.position(i).y(), 1e-3) << "on the shorter side";
}

TEST(Optimise, NeighbouringPosesAreOneStepApart) {
  TebParams params;
  const auto barriers = barriers_of({disc(4.0, 0.8), disc(6.0, -3.0)});
  Band band = straight(params, 8.0);
  settled(params, barriers, band);
  for (std::size_t i = 0; i + 1 < band.size(); ++i) {
    EXPECT_LE((band.position(i + 1) - band.position(i)).norm(),
              (params.max_vel_x_mps + params.penalty_epsilon_ratio) * band.time(i));
    EXPECT_LE(std::abs(wrap_angle(band.pose(i + 1).heading - band.pose(i).heading)),
              (params.max_vel_theta_radps + params.penalty_epsilon_ratio) * band.time(i));
  }
}

TEST(Optimise, AnotherSolverComesToTheSameBand) {
  struct Reference {
    double offset, cost, duration, clearance;
  };
  // Ceres Solver 2.1 (sparse Cholesky factors, its own trust region) from the same band with the same costs
  for (const auto& [offset, cost, duration, least] : {Reference{0.4, 2.6942819, 7.4527473, 0.59740315},
                                                      {-0.7, 2.2829899, 7.2795673, 0.5986247},
                                                      {1.2, 2.2003513, 7.0684877, 0.5997472}}) {
    TebParams params;
    params.max_vel_x_mps = 1.5;
    const auto barriers = barriers_of({disc(4.0, offset)});
    Band band = straight(params, 8.0);
    settled(params, barriers, band);
    Problem problem{.params = params, .speed = 0.5, .yaw_rate = 0.0, .close = {}};
    associate(barriers, band, 200.0, problem);
    improve(problem, 300, band);
    EXPECT_NEAR(cost_of(problem, band).sum(), cost, 1e-4);
    EXPECT_NEAR(band.duration(), duration, 1e-4);
    EXPECT_NEAR(clearance(barriers, band), least, 1e-4);
  }
}

TEST(Optimise, NoIterationMakesItWorse) {
  TebParams params;
  const auto barriers = barriers_of({disc(1.5, 0.2), disc(2.5, -1.2)});
  Band band = straight(params, 3.0);
  resize(params, band);
  Problem problem{.params = params, .speed = 0.1, .yaw_rate = 0.0, .close = {}};
  associate(barriers, band, 50.0, problem);
  double before = cost_of(problem, band).sum();
  for (int i = 0; i < 10; ++i) {
    improve(problem, 1, band);
    const double after = cost_of(problem, band).sum();
    EXPECT_LE(after, before * (1.0 + 1e-12));
    before = after;
  }
}

TEST(Optimise, TheEndsStayWhereTheyAre) {
  TebParams params;
  const auto barriers = barriers_of({disc(1.5, 0.2)});
  Band band = straight(params, 3.0);
  const Pose start = band.pose(0), end = band.pose(band.size() - 1);
  optimise(params, barriers, 0.3, 0.1, band);
  EXPECT_EQ(band.position(0), start.position);
  EXPECT_EQ(band.pose(0).heading, start.heading);
  EXPECT_EQ(band.position(band.size() - 1), end.position);
  EXPECT_EQ(band.pose(band.size() - 1).heading, end.heading);
}

TEST(Optimise, TheRobustVariantKeepsEveryTimePositiveEvenAgainstAWall) {
  TebParams params;
  params.robust = true;
  params.max_vel_x_mps = 1.5;
  std::vector<BandObstacle> barriers;
  for (const Obstacle& buoy : courses::u_wall().buoys) barriers.emplace_back(buoy, 0.75);
  for (const double length : {3.0, 5.0, 6.0, 7.0, 9.0}) {
    Band band = straight(params, length);
    for (int i = 0; i < 10; ++i) {
      optimise(params, barriers, 1.0, 0.0, band);
      for (std::size_t k = 0; k + 1 < band.size(); ++k) EXPECT_GE(band.time(k), 1e-3);
    }
  }
}

TEST(Optimise, AssociatesAllThatIsNearAndTheNearestOnEitherSideFartherOff) {
  TebParams params;  // all within 0.75 m; to either side within 2.5 m
  Band band;
  for (const double n : {0.0, 10.0, 20.0}) band.knots.push_back({n, 0.0, 0.0, 0.3});
  // distances from the pose at (10, 0) less radii: 0.45, 0.65; 1.45 and 1.95 to starboard; 2.15 to port; 3.95
  const auto barriers =
      barriers_of({disc(11.5, 0), disc(8.3, 0), disc(10, 2.5), disc(10, 3), disc(10, -3.2), disc(10, -5)});
  Problem problem{.params = params, .speed = 0.0, .yaw_rate = 0.0, .close = {}};
  associate(barriers, band, 50.0, problem);
  std::vector<std::ptrdiff_t> found;
  for (const Closeness& c : problem.close) {
    EXPECT_EQ(c.knot, 1U);
    found.push_back(c.barrier - barriers.data());
  }
  std::ranges::sort(found);
  EXPECT_EQ(found, (std::vector<std::ptrdiff_t>{0, 1, 2, 4}));
}

TEST(Optimise, WhatMovesCountsForEveryPoseWhereItWillBeThen) {
  TebParams params;
  params.include_dynamic_obstacles = true;
  const Band band = straight(params, 3.0);
  const std::vector<BandObstacle> barriers{
      {Track{.position = {50, 0, 0}, .velocity = {-1, 0, 0}, .radius = 0.75}, 0.75, true}};
  Problem problem{.params = params, .speed = 0.0, .yaw_rate = 0.0, .close = {}};
  associate(barriers, band, 50.0, problem);
  ASSERT_EQ(problem.close.size(), band.size() - 2);
  EXPECT_NEAR(problem.close[4].time, 5 * band.time(0), 1e-12);
  EXPECT_NEAR(barriers[0].from({0, 0}, 10.0).distance, 40.0 - 1.5, 1e-12);
}

}  // namespace
}  // namespace fairway::teb
