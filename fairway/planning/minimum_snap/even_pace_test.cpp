// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/minimum_snap/even_pace.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "fairway/planning/minimum_snap/fit_trajectory.hpp"
#include "fairway/planning/testing/four_obstacles.hpp"

namespace fairway {
namespace {

const PlanarMap open_water{{}, 1.0};

TEST(EvenPace, AlongALongStraightLineItNearlyKeepsTheSpeedLimit) {
  const std::vector<Vec2> line{{0, 0}, {60, 80}};
  const TrajectoryLimits limits{.max_speed_mps = 0.5, .max_acceleration_mps2 = 0.05};
  const auto even = evenly_paced(line, open_water, limits);
  ASSERT_TRUE(even);
  EXPECT_LE(even->trajectory.peak_speed(), 0.5 * (1 + 1e-12));
  EXPECT_LE(even->trajectory.peak_acceleration(), 0.05 * (1 + 1e-12));
  // 100 m at 0.5 m/s, and one constant acceleration to that speed and one from it, are 210 s
  EXPECT_GT(even->trajectory.duration(), 210.0);
  EXPECT_LT(even->trajectory.duration(), 1.15 * 210.0);  // measured 1.07
}

TEST(EvenPace, IsQuickerThanOnePaceForAllSegments) {
  const std::vector<Vec2> path = four_obstacles::published_waypoints();
  const TrajectoryLimits limits{.max_speed_mps = 0.3, .max_acceleration_mps2 = 0.05};
  const auto even = evenly_paced(path, open_water, limits);
  ASSERT_TRUE(even);
  const double by_length = paced(minimum_snap(path, durations_by_length(path)), limits).duration();
  EXPECT_LT(even->trajectory.duration(), 0.8 * by_length);  // measured 0.57
}

TEST(EvenPace, OnlyAClearCurveCounts) {
  const std::array wall{Obstacle{.kind = Obstacle::Kind::segment, .from = {5, -9, 0}, .to = {5, 9, 0}}};
  const std::vector<Vec2> across{{0, 0}, {10, 0}};
  EXPECT_FALSE(evenly_paced(across, PlanarMap{wall, 1.0}, {0.3, 0.05}));
  const auto even = evenly_paced(four_obstacles::published_waypoints(), four_obstacles::map(), {0.3, 0.05});
  ASSERT_TRUE(even);
  EXPECT_GE(least_clearance(even->trajectory, four_obstacles::map()), 0.0);
}

TEST(EvenPace, WithoutALimitOfAccelerationSpeedAloneCounts) {
  const std::vector<Vec2> line{{0, 0}, {10, 0}};
  const auto even = evenly_paced(line, open_water, {0.5, std::numeric_limits<double>::infinity()});
  ASSERT_TRUE(even);
  EXPECT_NEAR(even->trajectory.peak_speed(), 0.5, 1e-6);
}

TEST(EvenPace, APathWithoutLengthHasNoPace) {
  const std::vector<Vec2> here{{3, 4}};
  EXPECT_FALSE(evenly_paced(here, open_water, {0.3, 0.05}));
}

}  // namespace
}  // namespace fairway
