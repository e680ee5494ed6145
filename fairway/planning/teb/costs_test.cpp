// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/teb/costs.hpp"

#include <gtest/gtest.h>

#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::teb {
namespace {

const TebParams params;  // 0.4 m/s ahead, 0.2 astern, 0.3 rad/s, 0.5 m/s2, 0.5 rad/s2, margin 0.1

using Window = std::array<double, 12>;

/// Three knots half a metre or less apart, with any headings.
Window random_window(Rng& rng) {
  Window x{};
  for (std::size_t i = 0; i < 12; i += 4) {
    x[i] = rng.uniform(-0.3, 0.3);
    x[i + 1] = rng.uniform(-0.3, 0.3);
    x[i + 2] = rng.uniform(-pi, pi);
    x[i + 3] = rng.uniform(0.1, 0.5);
  }
  return x;
}

/// Compares the slopes of `cost_at(x)` with central differences in random windows, where neither side of a
/// difference is beyond a kink; how many slopes were not zero.
template <class CostAt>
int check_slopes(const CostAt& cost_at, std::uint64_t seed) {
  using C = decltype(cost_at(nullptr));
  constexpr double h = 1e-7;
  Rng rng{seed};
  int active = 0;
  for (int trial = 0; trial < 400; ++trial) {
    Window x = random_window(rng);
    Residual<C::rows, C::width> here;
    cost_at(x.data())(here);
    for (std::size_t i = 0; i < static_cast<std::size_t>(C::width); ++i) {
      Values<C::rows> above, below;
      const double middle = x[i];
      x[i] = middle + h;
      cost_at(x.data())(above);
      x[i] = middle - h;
      cost_at(x.data())(below);
      x[i] = middle;
      for (int row = 0; row < C::rows; ++row) {
        const double ahead = (above.value[row] - here.value[row]) / h;
        const double behind = (here.value[row] - below.value[row]) / h;
        const double scale = 1.0 + std::abs(ahead) + std::abs(behind);
        if (std::abs(ahead - behind) > 1e-3 * scale) continue;  // a kink
        const double slope = here.slope(row, static_cast<int>(i));
        EXPECT_NEAR(slope, 0.5 * (ahead + behind), 1e-4 * scale) << "row " << row << ", variable " << i;
        active += slope != 0.0 ? 1 : 0;
      }
    }
  }
  return active;
}

KinematicsCost kinematics_at(const double* x) {
  return {params, {x[4] - x[0], x[5] - x[1]}, math::sin_cos(x[2]), math::sin_cos(x[6])};
}

TEST(Costs, SlopesAreThoseOfTheValues) {
  Twist motion, next;  // that a cost refers to
  const auto move = [&](const double* x) {
    motion = motion_between(x);
    next = motion_between(x + 4);
  };
  const auto on_motion = [&](auto cost) {
    return [&move, cost](const double* x) {
      move(x);
      return cost;
    };
  };
  EXPECT_GT(check_slopes(on_motion(VelocityCost{params, motion}), 1), 1000);
  EXPECT_GT(check_slopes(on_motion(AccelerationCost{params, motion, next}), 2), 1000);
  EXPECT_GT(check_slopes(on_motion(EndAccelerationCost{params, motion, 0.3, -0.1, false}), 3), 1000);
  EXPECT_GT(check_slopes(on_motion(EndAccelerationCost{params, motion, 0.0, 0.0, true}), 4), 1000);
  EXPECT_GT(check_slopes(kinematics_at, 5), 1000);
  EXPECT_EQ(check_slopes([](const double* x) { return TimeCost{params, x[0]}; }, 6), 400);

  const BandObstacle still{Obstacle{.kind = Obstacle::Kind::sphere, .position = {0.5, 0.2, 3}, .radius = 0.1},
                           0.2};
  const BandObstacle wall{
      Obstacle{.kind = Obstacle::Kind::segment, .from = {-1, 0.4, 0}, .to = {0.1, 0.4, 0}}, 0.2};
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const BandObstacle solid{Obstacle{.kind = Obstacle::Kind::polygon, .vertices = corners}, 0.2};
  const BandObstacle moving{Track{.position = {-1, 0, 0}, .velocity = {0.5, 0.1, 0}, .radius = 0.1}, 0.2,
                            true};
  for (const BandObstacle& barrier : {still, wall, solid, moving}) {
    const auto at = [&](const double* x) { return BarrierCost{params, barrier, {x[0], x[1]}, 1.7, 50.0}; };
    EXPECT_GT(check_slopes(at, 7), 300);
  }
}

TEST(Costs, MotionIsWayAndTurnOverTime) {
  const Window x{0, 0, 0, 0.5, 0.2, 0, 0.1};
  const Twist ahead = motion_between(x.data());
  EXPECT_NEAR(ahead.speed, 0.4 * 20.0 / 21.0, 1e-12);  // smoothed sign: 100 * 0.2 / (1 + 100 * 0.2)
  EXPECT_NEAR(ahead.yaw_rate, 0.2, 1e-12);
  const Window back{0, 0, pi, 0.5, 0.2, 0, -pi + 0.1};
  const Twist astern = motion_between(back.data());
  EXPECT_NEAR(astern.speed, -0.4 * 20.0 / 21.0, 1e-12);
  EXPECT_NEAR(astern.yaw_rate, 0.2, 1e-12) << "the short way round";
}

TEST(Costs, StandingStillHasNoSlopesThatAreNotNumbers) {
  const Window x{1, 1, 0.3, 0.3, 1, 1, 0.3, 0.3, 1, 1, 0.3, 0.3};
  Residual<2, 11> out;
  const Twist before = motion_between(x.data()), after = motion_between(x.data() + 4);
  AccelerationCost{params, before, after}(out);
  EXPECT_TRUE(before.speed_slope().allFinite());
  EXPECT_TRUE(out.value.isZero());
  EXPECT_TRUE(out.slope.allFinite());
}

TEST(Costs, ExcessIsMeasuredFromTheMargin) {
  EXPECT_EQ(excess(0.0, -0.2, 0.4, 0.1).value, 0.0);
  EXPECT_NEAR(excess(0.5, -0.2, 0.4, 0.1).value, 0.2, 1e-15);
  EXPECT_EQ(excess(0.5, -0.2, 0.4, 0.1).sign, 1.0);
  EXPECT_NEAR(excess(-0.15, -0.2, 0.4, 0.1).value, 0.05, 1e-15);
  EXPECT_EQ(excess(-0.15, -0.2, 0.4, 0.1).sign, -1.0);
}

TEST(Costs, AnArcCostsNothingToTurnAlong) {
  // a quarter of a circle of radius 1: chord at 45 degrees
  const Window x{0, 0, 0, 1, 1, 1, pi / 2};
  Values<2> out;
  kinematics_at(x.data())(out);
  EXPECT_NEAR(out.value[0], 0.0, 1e-12);
  EXPECT_EQ(out.value[1], 0.0);
  const Window sideways{0, 0, 0, 1, 0, 0.1, 0};
  kinematics_at(sideways.data())(out);
  EXPECT_NEAR(std::abs(out.value[0]), std::sqrt(1000.0) * 0.2, 1e-12);  // (cos 0 + cos 0) * 0.1
}

TEST(Costs, ABarrierCostsBelowTheLeastDistanceAndALittleBelowTheInflation) {
  // least distance 0.5 and margin 0.1, inflation 0.6: 0.45 between the surfaces
  const BandObstacle barrier{Obstacle{.kind = Obstacle::Kind::sphere, .position = {1.5, 0, 0}, .radius = 0.3},
                             0.75};
  Residual<2, 2> out;
  BarrierCost{params, barrier, Vec2::Zero(), 0.0, 50.0}(out);
  EXPECT_NEAR(out.value[0], std::sqrt(50.0) * 0.15, 1e-12);
  EXPECT_NEAR(out.value[1], std::sqrt(0.1) * 0.15, 1e-12);
  BarrierCost{params, barrier, {-0.2, 0.0}, 0.0, 50.0}(out);
  EXPECT_TRUE(out.value.isZero());
}

TEST(Costs, AtTheCentreOfADiscThereIsNoWayOut) {
  const BandObstacle barrier{Obstacle{.kind = Obstacle::Kind::sphere, .radius = 0.3}, 0.75};
  Residual<2, 2> out;
  BarrierCost{params, barrier, Vec2::Zero(), 0.0, 50.0}(out);
  EXPECT_TRUE(out.value.allFinite());
  EXPECT_TRUE(out.slope.isZero());
}

}  // namespace
}  // namespace fairway::teb
