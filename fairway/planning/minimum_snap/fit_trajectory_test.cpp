// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/minimum_snap/fit_trajectory.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "fairway/core/error.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/planning/path_planner.hpp"
#include "fairway/planning/testing/four_obstacles.hpp"

namespace fairway {
namespace {

constexpr TrajectoryLimits limits{.max_speed_mps = 0.3, .max_acceleration_mps2 = 0.05};

/// Clearance by sampling alone, apart from the search under test.
double sampled_clearance(const Trajectory& trajectory, const PlanarMap& map) {
  constexpr int samples = 20000;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= samples; ++i) {
    least = std::fmin(least, map.clearance(trajectory.sample(trajectory.duration() * i / samples).position));
  }
  return least;
}

std::vector<double> equal_times() { return std::vector<double>(10, 28.0); }

TEST(LeastClearance, OfThePublishedWaypointsIsThatOfTheReference) {
  // Table 7 with equal times 4.52 m from the centres, with times by length 4.15 m (computed independently)
  const std::vector<Vec2> waypoints = four_obstacles::published_waypoints();
  const PlanarMap map = four_obstacles::map();
  const double grown = four_obstacles::grown_radius_m;
  EXPECT_NEAR(grown + least_clearance(minimum_snap(waypoints, equal_times()), map), 4.52, 0.005);
  EXPECT_NEAR(grown + least_clearance(minimum_snap(waypoints, durations_by_length(waypoints)), map), 4.15,
              0.005);
}

TEST(LeastClearance, IsThatOfDenseSamplingToItsTolerance) {
  for (std::uint64_t i = 0; i < 40; ++i) {
    Rng rng = Rng{21}.stream("walk", i);
    std::vector<Vec2> waypoints;
    for (int k = 0; k < 6; ++k) waypoints.emplace_back(rng.uniform(0, 35), rng.uniform(0, 35));
    const Trajectory trajectory = minimum_snap(waypoints, durations_by_length(waypoints));
    const double found = least_clearance(trajectory, four_obstacles::map());
    const double sampled = sampled_clearance(trajectory, four_obstacles::map());
    EXPECT_LE(found, sampled + clearance_tolerance_m);
    EXPECT_GE(found, sampled - 0.02);  // samples are up to 0.03 m apart
  }
}

TEST(LeastClearance, AGrazeBetweenSamplesIsNotMissed) {
  // a straight run past a needle that reaches 2 mm into the way
  const std::vector<Vec2> waypoints{{0, 0}, {1000, 0}};
  const std::vector<double> durations{100.0};
  const std::array needle{
      Obstacle{.kind = Obstacle::Kind::segment, .from = {314.159, 0.998, 0}, .to = {314.159, 9, 0}}};
  EXPECT_NEAR(least_clearance(minimum_snap(waypoints, durations), PlanarMap{needle, 1.0}), -0.002, 1e-3);
}

TEST(FitTrajectory, KeepsTheClearanceOfTheFourObstacleCaseForFiftySeeds) {
  const PlanarMap map = four_obstacles::map();
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    const PathResult path = plan_path(map, {.start = four_obstacles::start,
                                            .goal = four_obstacles::goal,
                                            .iterations_count = 500,
                                            .seed = seed});
    ASSERT_EQ(path.status, PathStatus::found);
    const FittedTrajectory fitted = fit_trajectory(path.waypoints, map, {.limits = limits});
    EXPECT_NE(fitted.status, FitStatus::violates);
    // from the centres; measured at least 4.2000
    EXPECT_GE(four_obstacles::grown_radius_m + sampled_clearance(fitted.trajectory, map),
              4.2 - clearance_tolerance_m);
    EXPECT_LT(fitted.trajectory.length(), 1.08 * path.length_m);  // measured 1.039
    EXPECT_LE(fitted.trajectory.peak_speed(), limits.max_speed_mps * (1 + 1e-12));
    EXPECT_LE(fitted.trajectory.peak_acceleration(), limits.max_acceleration_mps2 * (1 + 1e-12));
  }
}

TEST(FitTrajectory, LeavesThePublishedWaypointsWithEqualTimesAsTheyAre) {
  const std::vector<Vec2> waypoints = four_obstacles::published_waypoints();
  const FittedTrajectory fitted =
      fit_trajectory(waypoints, four_obstacles::map(), {.limits = limits, .segment_time_s = 28.0});
  EXPECT_EQ(fitted.status, FitStatus::as_given);
  EXPECT_EQ(fitted.waypoints, waypoints);
  EXPECT_DOUBLE_EQ(fitted.trajectory.duration(), 280.0);
}

TEST(FitTrajectory, RepairsThePublishedWaypointsWithTimesByLength) {
  const PlanarMap map = four_obstacles::map();
  const FittedTrajectory fitted =
      fit_trajectory(four_obstacles::published_waypoints(), map, {.limits = limits});
  EXPECT_EQ(fitted.status, FitStatus::repaired);
  EXPECT_GT(fitted.waypoints.size(), 11U);
  EXPECT_GE(sampled_clearance(fitted.trajectory, map), 0.0);  // measured 0.67
}

TEST(FitTrajectory, RepairSharesAGivenTimeAmongThePartsOfASegment) {
  // a taut path has legs of very different lengths, which equal times do not suit
  const PlanarMap map = four_obstacles::map();
  const PathResult path = plan_path(
      map,
      {.start = four_obstacles::start, .goal = four_obstacles::goal, .iterations_count = 500, .seed = 1});
  const FittedTrajectory fitted =
      fit_trajectory(path.waypoints, map, {.limits = limits, .segment_time_s = 28.0});
  EXPECT_EQ(fitted.status, FitStatus::repaired);
  EXPECT_NEAR(fitted.trajectory.duration(), 28.0 * static_cast<double>(path.waypoints.size() - 1), 1e-9);
  EXPECT_GE(sampled_clearance(fitted.trajectory, map), -clearance_tolerance_m);
}

TEST(FitTrajectory, DoesNotSwingOutBesideAShortSegment) {
  // with nothing done about it the curve of this path is eighty times as long as the path
  const std::vector<Vec2> path{{0, 0}, {140, 0}, {142, 2}};
  const FittedTrajectory fitted = fit_trajectory(path, PlanarMap{{}, 1.0}, {.limits = limits});
  EXPECT_EQ(fitted.status, FitStatus::repaired);
  EXPECT_LT(fitted.trajectory.length(), 1.1 * length_of(path));
}

TEST(FitTrajectory, KeepsClearInCrowdedRandomWaters) {
  int repaired = 0, tried = 0;
  double longest = 0.0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    Rng rng = Rng{9}.stream("map", i);
    std::vector<std::array<Vec3, 4>> corners(30);
    std::vector<Obstacle> obstacles;
    const auto count = 3 + rng.index(25);
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3 p{rng.uniform(5, 95), rng.uniform(5, 95), 0};
      const double a = rng.uniform(2, 8), b = rng.uniform(2, 8);
      corners[k] = {p, p + Vec3{a, 0, 0}, p + Vec3{a, b, 0}, p + Vec3{0, b, 0}};
      const std::array kinds{
          Obstacle{.kind = Obstacle::Kind::sphere, .position = p, .radius = 0.7 * a},
          Obstacle{.kind = Obstacle::Kind::segment, .from = p, .to = p + 3 * Vec3{a - 5, b - 5, 0}},
          Obstacle{.kind = Obstacle::Kind::polygon, .vertices = corners[k]}};
      obstacles.push_back(kinds[rng.index(3)]);
    }
    const PlanarMap map{obstacles, rng.uniform(0.2, 3.0)};
    const PathResult path = plan_path(map, {.goal = {100, 100}, .iterations_count = 500, .seed = 1});
    if (path.status != PathStatus::found) continue;
    ++tried;
    const FittedTrajectory fitted = fit_trajectory(path.waypoints, map, {.limits = limits});
    EXPECT_NE(fitted.status, FitStatus::violates) << i;
    EXPECT_GE(sampled_clearance(fitted.trajectory, map), -clearance_tolerance_m - 1e-9);
    longest = std::fmax(longest, fitted.trajectory.length() / path.length_m);
    repaired += fitted.status == FitStatus::repaired ? 1 : 0;
  }
  EXPECT_GT(tried, 90);
  EXPECT_GT(repaired, 10);
  EXPECT_LT(longest, 1.2);  // measured 1.04
}

TEST(FitTrajectory, SaysSoWhereThePathItselfIsBlocked) {
  const std::vector<Vec2> through{{0, 0}, {20, 24}};
  EXPECT_EQ(
      fit_trajectory(through, four_obstacles::map(), {.limits = limits, .joining = Joining::rest_to_rest})
          .status,
      FitStatus::violates);
  const std::array wall{Obstacle{.kind = Obstacle::Kind::segment, .from = {10, -9, 0}, .to = {10, 9, 0}}};
  const std::vector<Vec2> across{{0, 0}, {20, 0}};
  const FittedTrajectory fitted = fit_trajectory(across, PlanarMap{wall, 1.0}, {.limits = limits});
  EXPECT_EQ(fitted.status, FitStatus::violates);
}

TEST(FitTrajectory, APathOfOnePointIsRest) {
  const std::vector<Vec2> here{{3, 4}};
  const FittedTrajectory fitted = fit_trajectory(here, four_obstacles::map(), {.limits = limits});
  EXPECT_EQ(fitted.trajectory.sample(5.0).position, Vec2(3, 4));
  EXPECT_THROW(fit_trajectory({}, four_obstacles::map(), {.limits = limits}), InputError);
}

}  // namespace
}  // namespace fairway
