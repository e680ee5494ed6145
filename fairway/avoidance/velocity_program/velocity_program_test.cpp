// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_program/velocity_program.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "fairway/avoidance/velocity_program/testing/brute_force.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/core/testing/allocations.hpp"

namespace fairway {
namespace {

Vec3 direction(Rng& rng) { return unit(Vec3{rng.normal(), rng.normal(), rng.normal()}); }

struct Program {
  std::vector<HalfSpace> half_spaces;
  Vec3 preferred;
  double max_speed;
};

/// Up to ten half-spaces, a fifth of the programs infeasible; in units from 0.05 to 20 m/s.
Program random_program(std::uint64_t index, double excess = 0.0) {
  Rng rng = Rng{1}.stream("program", index);
  Program program;
  const double speed = program.max_speed = std::exp(rng.uniform(-3.0, 3.0));
  const double most = rng.uniform(-0.2, 1.0);
  const std::uint64_t count = rng.index(11);
  for (std::uint64_t i = 0; i < count; ++i) {
    program.half_spaces.push_back({direction(rng), speed * (rng.uniform(-1.0, most) + excess)});
  }
  program.preferred = rng.uniform(0.0, 1.5 * speed) * direction(rng);
  return program;
}

VelocityChoice solve(const Program& p) { return nearest_velocity(p.half_spaces, p.preferred, p.max_speed); }

/// Largest differences from the brute force over `count` programs, as fractions of the greatest speed.
struct Difference {
  double velocity = 0.0;
  double violation = 0.0;
  int infeasible = 0;
};

template <class Make>
Difference from_brute_force(int count, Make make) {
  Difference difference;
  for (int i = 0; i < count; ++i) {
    const Program p = make(static_cast<std::uint64_t>(i));
    const VelocityChoice choice = solve(p);
    const brute_force::Answer expected =
        brute_force::nearest_velocity(p.half_spaces, p.preferred, p.max_speed);
    EXPECT_EQ(choice.is_feasible(), expected.violation == 0) << "program " << i;
    EXPECT_LE(choice.velocity.norm(), p.max_speed * (1 + 1e-14)) << "program " << i;
    const auto velocity =
        static_cast<double>((choice.velocity.cast<long double>() - expected.velocity).norm());
    const auto violation = static_cast<double>(std::fabs(choice.violation - expected.violation));
    difference.velocity = std::fmax(difference.velocity, velocity / p.max_speed);
    difference.violation = std::fmax(difference.violation, violation / p.max_speed);
    difference.infeasible += choice.is_feasible() ? 0 : 1;
  }
  return difference;
}

TEST(VelocityProgram, AgreesWithEveryActiveSetTriedInLongDouble) {
  const Difference d = from_brute_force(4000, [](std::uint64_t i) { return random_program(i); });
  EXPECT_LT(d.velocity, 1e-11);   // measured 2e-13
  EXPECT_LT(d.violation, 1e-12);  // measured 3e-14
  EXPECT_GT(d.infeasible, 600);
}

TEST(VelocityProgram, AgreesWhenHalfSpacesNearlyCoincide) {
  const Difference d = from_brute_force(2000, [](std::uint64_t i) {
    Program p = random_program(i);
    Rng rng = Rng{2}.stream("nearly", i);
    for (std::size_t k = 1; k < p.half_spaces.size(); k += 2) {
      const double apart = std::pow(10.0, rng.uniform(-16.0, -1.0));
      const HalfSpace& twin = p.half_spaces[k - 1];
      p.half_spaces[k] = {unit(twin.normal + apart * direction(rng)),
                          twin.offset + apart * p.max_speed * rng.uniform(-1.0, 1.0)};
    }
    return p;
  });
  EXPECT_LT(d.velocity, 1e-10);   // measured 1e-12
  EXPECT_LT(d.violation, 1e-12);  // measured 2e-14
}

TEST(VelocityProgram, AgreesWhenHalfSpacesNearlyOppose) {
  // two planes that meet at an angle of 1e-3 or more magnify rounding a thousandfold
  const Difference d = from_brute_force(2000, [](std::uint64_t i) {
    Program p = random_program(i);
    Rng rng = Rng{3}.stream("opposed", i);
    for (std::size_t k = 1; k < p.half_spaces.size(); k += 3) {
      const double apart = std::pow(10.0, rng.uniform(-3.0, -1.0));
      const HalfSpace& other = p.half_spaces[k - 1];
      p.half_spaces[k] = {-unit(other.normal + apart * direction(rng)),
                          -other.offset + apart * p.max_speed * rng.uniform(-1.0, 1.0)};
    }
    return p;
  });
  EXPECT_LT(d.velocity, 1e-9);    // measured 2e-11
  EXPECT_LT(d.violation, 1e-11);  // measured 4e-14
}

TEST(VelocityProgram, AgreesWhenNoHalfSpaceReachesTheBall) {
  // as among vehicles that overlap deeply: offsets up to a thousand times the greatest speed
  const Difference d = from_brute_force(2000, [](std::uint64_t i) {
    return random_program(i, std::pow(10.0, Rng{4}.stream("excess", i).uniform(0.0, 3.0)));
  });
  EXPECT_LT(d.velocity, 1e-9);   // measured 9e-11
  EXPECT_LT(d.violation, 1e-9);  // measured 2e-11
}

TEST(VelocityProgram, DoesNotDependOnTheOrderOfTheHalfSpaces) {
  double largest = 0.0;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    Program p = random_program(i);
    const VelocityChoice choice = solve(p);
    Rng rng = Rng{5}.stream("shuffle", i);
    for (int trial = 0; trial < 3; ++trial) {
      for (std::size_t k = p.half_spaces.size(); k > 1; --k)
        std::swap(p.half_spaces[k - 1], p.half_spaces[rng.index(k)]);
      largest = std::fmax(largest, (solve(p).velocity - choice.velocity).norm() / p.max_speed);
    }
  }
  EXPECT_LT(largest, 3e-8);  // measured 4e-13
}

TEST(VelocityProgram, WithoutHalfSpacesOnlyTheSpeedLimitBinds) {
  EXPECT_EQ(nearest_velocity({}, {0.3, 0.4, 0.0}, 1.0).velocity, Vec3(0.3, 0.4, 0.0));
  EXPECT_LT((nearest_velocity({}, {3.0, 4.0, 0.0}, 1.0).velocity - Vec3(0.6, 0.8, 0.0)).norm(), 1e-15);
}

TEST(VelocityProgram, OneHalfSpaceIsAProjection) {
  // v_x >= 0.6: (0, 0.5, 0) goes to (0.6, 0.5, 0); (0, 3, 0) to the rim of the disc, of radius 0.8
  const std::vector<HalfSpace> half_spaces{{Vec3::UnitX(), 0.6}};
  EXPECT_LT((nearest_velocity(half_spaces, {0.0, 0.5, 0.0}, 1.0).velocity - Vec3(0.6, 0.5, 0.0)).norm(),
            1e-15);
  EXPECT_LT((nearest_velocity(half_spaces, {0.0, 3.0, 0.0}, 1.0).velocity - Vec3(0.6, 0.8, 0.0)).norm(),
            1e-15);
}

TEST(VelocityProgram, AHalfSpaceThatOnlyTouchesTheBallLeavesOnePoint) {
  const std::vector<HalfSpace> half_spaces{{Vec3::UnitX(), 1.0}};
  const VelocityChoice choice = nearest_velocity(half_spaces, {0.0, 0.5, 0.0}, 1.0);
  EXPECT_TRUE(choice.is_feasible());
  EXPECT_LT((choice.velocity - Vec3(1.0, 0.0, 0.0)).norm(), 1e-15);
}

TEST(VelocityProgram, BetweenOpposedHalfSpacesTheMiddleNearestToThePreferredIsChosen) {
  // v_x >= 0.2 and v_x <= -0.2: any velocity with v_x = 0 violates both by 0.2
  const std::vector<HalfSpace> half_spaces{{Vec3::UnitX(), 0.2}, {-Vec3::UnitX(), 0.2}};
  const VelocityChoice choice = nearest_velocity(half_spaces, {0.7, 0.3, -0.4}, 1.0);
  EXPECT_NEAR(choice.violation, 0.2, 1e-13);
  EXPECT_LT((choice.velocity - Vec3(0.0, 0.3, -0.4)).norm(), 1e-13);
}

TEST(VelocityProgram, ThreeHalfPlanesOfAPrismLeaveTheAxisFree) {
  // normals at 120 degrees, each asking for 0.1: the axis violates all by 0.1; along it, nothing is lost
  std::vector<HalfSpace> half_spaces;
  for (const double angle : {0.0, 2.0, 4.0}) {
    half_spaces.push_back({{std::cos(angle * pi / 3), std::sin(angle * pi / 3), 0.0}, 0.1});
  }
  const VelocityChoice choice = nearest_velocity(half_spaces, {0.2, 0.2, 0.5}, 1.0);
  EXPECT_NEAR(choice.violation, 0.1, 1e-13);
  EXPECT_LT((choice.velocity - Vec3(0.0, 0.0, 0.5)).norm(), 1e-13);
}

TEST(VelocityProgram, RepeatedAndOppositeHalfSpacesAreFeasible) {
  const Vec3 n = unit(Vec3{1.0, 2.0, 3.0});
  const std::vector<HalfSpace> half_spaces{{n, 0.5}, {n, 0.5}, {-n, -0.5}, {n, 0.4}, {-n, -0.5}};
  const VelocityChoice choice = nearest_velocity(half_spaces, Vec3::Zero(), 1.0);
  EXPECT_TRUE(choice.is_feasible());
  EXPECT_LT((choice.velocity - 0.5 * n).norm(), 1e-13);
}

TEST(VelocityProgram, ManyPlanesThroughOnePointAreFeasible) {
  // a degenerate corner: a cone of 40 half-spaces with its apex at v = (0.3, 0, 0)
  std::vector<HalfSpace> half_spaces;
  for (int i = 0; i < 40; ++i) {
    const double angle = i * pi / 20;
    half_spaces.push_back(
        HalfSpace::through({0.3, 0.0, 0.0}, unit(Vec3{1.0, std::cos(angle), std::sin(angle)})));
  }
  const VelocityChoice choice = nearest_velocity(half_spaces, {-0.5, 0.0, 0.0}, 1.0);
  EXPECT_TRUE(choice.is_feasible());
  EXPECT_LT((choice.velocity - Vec3(0.3, 0.0, 0.0)).norm(), 1e-12);
}

TEST(VelocityProgram, WhoCannotMoveStaysAndReportsTheViolation) {
  const std::vector<HalfSpace> half_spaces{{Vec3::UnitX(), 0.25}, {Vec3::UnitY(), -0.1}};
  const VelocityChoice choice = nearest_velocity(half_spaces, {1.0, 0.0, 0.0}, 0.0);
  EXPECT_EQ(choice.velocity, Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(choice.violation, 0.25);
  EXPECT_TRUE(nearest_velocity(std::span{half_spaces}.last(1), {1.0, 0.0, 0.0}, 0.0).is_feasible());
}

TEST(VelocityProgram, HorizontalNormalsNeverAddAVerticalVelocity) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Program p = random_program(i);
    for (HalfSpace& h : p.half_spaces) h.normal = unit(Vec3{h.normal.x(), h.normal.y(), 0.0});
    p.preferred.z() = 0.0;
    EXPECT_EQ(solve(p).velocity.z(), 0.0) << "program " << i;
  }
}

TEST(VelocityProgram, FiveHundredHalfSpacesAreKeptOrReportedWithoutAllocating) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Rng rng = Rng{6}.stream("many", i);
    std::vector<HalfSpace> half_spaces;
    const double most = i % 2 == 0 ? -0.05 : 0.5;
    for (int k = 0; k < 500; ++k) half_spaces.push_back({direction(rng), rng.uniform(-1.0, most)});

    const long before = allocation_count();
    const VelocityChoice choice = nearest_velocity(half_spaces, direction(rng), 1.0);
    EXPECT_EQ(allocation_count(), before);

    EXPECT_EQ(choice.is_feasible(), i % 2 == 0);
    double worst = 0.0;
    for (const HalfSpace& h : half_spaces) worst = std::fmax(worst, h.violation(choice.velocity));
    EXPECT_NEAR(worst, choice.violation, 1e-12);
  }
}

}  // namespace
}  // namespace fairway
