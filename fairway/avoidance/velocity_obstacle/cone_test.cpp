// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/cone.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "fairway/avoidance/lanes/kernel.hpp"
#include "fairway/avoidance/velocity_obstacle/testing/random_scenes.hpp"

namespace fairway::velocity_obstacle {
namespace {

constexpr Horizons usual{5.0, 1.0};

/// Every seventh overlaps own ship, and one of these is exactly there.
RelativeCapsule drawn_disc(std::uint64_t i, Rng& rng) {
  RelativeCapsule solid = any_disc(rng);
  solid.velocity = rng.uniform(0.0, 1.5) * any_direction(rng);
  if (i % 7 == 0) solid.radius = solid.from.norm() + rng.uniform(0.0, 1.0);
  if (i % 49 == 0) solid.from = solid.to = Vec2::Zero();
  return solid;
}

void expect_same_bits(const Vec2& a, const Vec2& b, const char* what) {
  for (const Eigen::Index axis : {0, 1})
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a[axis]), std::bit_cast<std::uint64_t>(b[axis])) << what;
}

void expect_same_boundaries(const VelocityObstacle& a, const VelocityObstacle& b, const char* what) {
  std::array<Boundary, VelocityObstacle::max_boundaries> of_a, of_b;
  ASSERT_EQ(a.boundaries(of_a), b.boundaries(of_b)) << what;
  for (std::size_t i = 0; i < a.boundaries(of_a); ++i) {
    expect_same_bits(of_a[i].point, of_b[i].point, what);
    expect_same_bits(of_a[i].direction, of_b[i].direction, what);
    EXPECT_EQ(of_a[i].radius, of_b[i].radius) << what;
  }
}

TEST(Cone, MadeSideBySideIsThatMadeAloneToTheBit) {
  int overlapping = 0;
  for (const lanes::Kernel* kernel : lanes::kernels()) {
    for (std::uint64_t scene = 0; scene < 400; ++scene) {
      Rng rng = Rng{1}.stream("side by side", scene);
      const Vec2 own = rng.uniform(0.0, 1.5) * any_direction(rng);
      Discs discs;
      discs.own_north = own.x();
      discs.own_east = own.y();
      discs.inverse_horizon = 1.0 / usual.horizon;
      discs.inverse_interval = 1.0 / usual.interval;
      discs.by_side = scene % 2 == 0;
      std::vector<RelativeCapsule> solids;
      for (std::uint64_t i = 0; i < 1 + scene % 19; ++i) {
        solids.push_back(drawn_disc(scene + i, rng));
        const RelativeCapsule& solid = solids.back();
        discs.north[i] = solid.from.x();
        discs.east[i] = solid.from.y();
        discs.radius[i] = solid.radius;
        discs.velocity_north[i] = solid.velocity.x();
        discs.velocity_east[i] = solid.velocity.y();
        discs.shares[i] = (scene + i) % 3 == 0 ? 0.0 : 1.0;
      }
      discs.count = solids.size();
      kernel->cones(discs);

      for (std::size_t i = 0; i < solids.size(); ++i) {
        const VelocityObstacle made(discs, i, solids[i].parting);
        const VelocityObstacle alone = discs.shares[i] == 0.0 ? VelocityObstacle(solids[i], usual)
                                       : discs.by_side ? VelocityObstacle::hybrid(solids[i], own, usual)
                                                       : VelocityObstacle::reciprocal(solids[i], own, usual);
        expect_same_boundaries(made, alone, kernel->name);
        overlapping += made.cone().overlaps ? 1 : 0;
        const Vec2 v = rng.uniform(0.0, 2.0) * any_direction(rng);
        EXPECT_EQ(made.depth(v), alone.depth(v)) << kernel->name;
        EXPECT_EQ(made.urgency(v), alone.urgency(v)) << kernel->name;
      }
    }
  }
  EXPECT_GT(overlapping, 500);
}

TEST(Cone, VelocitiesTriedTogetherAreOutsideWhereEachIsByItself) {
  int outside = 0, inside = 0;
  for (const lanes::Kernel* kernel : lanes::kernels()) {
    for (std::uint64_t scene = 0; scene < 2000; ++scene) {
      Rng rng = Rng{2}.stream("tried", scene);
      std::vector<VelocityObstacle> obstacles;
      for (std::uint64_t i = 0; i < scene % 6; ++i)
        obstacles.emplace_back(i % 2 == 0 ? drawn_disc(scene + i, rng) : any_wall(rng), usual);
      std::vector<const Cone*> cones;
      for (const VelocityObstacle& obstacle : obstacles) cones.push_back(&obstacle.cone());
      std::array<double, lanes::most_lanes> north, east;
      for (std::size_t lane = 0; lane < kernel->lanes; ++lane) {
        const Vec2 v = rng.uniform(0.0, 2.0) * any_direction(rng);
        north[lane] = v.x();
        east[lane] = v.y();
      }
      const double slack = rng.uniform(0.0, 0.1);
      const unsigned bits = kernel->outside({cones.data(), cones.size(), slack, north.data(), east.data()});
      for (std::size_t lane = 0; lane < kernel->lanes; ++lane) {
        bool is_outside = true;
        for (const VelocityObstacle& obstacle : obstacles)
          is_outside = is_outside && !(obstacle.depth({north[lane], east[lane]}) > slack);
        EXPECT_EQ((bits >> lane & 1U) != 0, is_outside) << kernel->name << ", scene " << scene;
        ++(is_outside ? outside : inside);
      }
    }
  }
  EXPECT_GT(outside, 2000);
  EXPECT_GT(inside, 2000);
}

}  // namespace
}  // namespace fairway::velocity_obstacle
