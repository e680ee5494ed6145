// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/avoa_improved.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "fairway/avoidance/avoa_improved/testing/unicycle.hpp"
#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

using namespace avoa_improved;

Avoider improved(const AvoaImproved::Params& params = {}) { return Avoider{AvoaImproved{params}}; }

Avoider with(bool turn_aware, bool memory) {
  AvoaImproved::Params params;
  params.turn_aware = turn_aware;
  params.memory = memory;
  return improved(params);
}

/// At the origin, northbound at 1.2 m/s.
Situation northbound() {
  Situation s{.period = 0.2};
  s.own = {.velocity = {1.2, 0, 0}, .radius = 0.75};
  s.goal = {.position = {25, 0, 0}, .cruise_speed = 1.2};
  s.limits = {.max_speed = 1.5, .max_acceleration = 0.5, .max_turn_rate = 0.3751};
  return s;
}

/// Start, buoys and heading somewhat elsewhere.
Course jittered(Course course, Rng rng) {
  course.start.position += Vec2{rng.uniform(-1, 1), rng.uniform(-1, 1)};
  course.start.yaw += rng.uniform(-0.3, 0.3);
  for (Obstacle& b : course.buoys) b.position += Vec3{rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), 0};
  return course;
}

void expect_passed(const Course& course, double latest, int most_side_changes) {
  const Passage p = passage(course, improved());
  EXPECT_GT(p.clearance, 0.2);
  EXPECT_GT(p.arrival, 0.0);
  EXPECT_LT(p.arrival, latest);
  EXPECT_LE(p.side_changes, most_side_changes);
  EXPECT_EQ(p.infeasible, 0);
}

TEST(AvoaImproved, AloneItCruisesAsTheMissionWants) {
  Situation s = northbound();
  s.own.yaw = 1.0;
  const Command command = improved().decide(s);
  EXPECT_EQ(command.mode, Mode::cruise);
  EXPECT_EQ(command.velocity, s.preferred_velocity());
}

TEST(AvoaImproved, WhatIsOutOfItsWayLeavesItCruising) {
  Situation s = northbound();
  const std::array<Obstacle, 2> gate{buoy(5, -2), buoy(5, 2)};
  s.obstacles = gate;
  const Command command = improved().decide(s);
  EXPECT_EQ(command.mode, Mode::cruise);
  EXPECT_EQ(command.velocity, s.preferred_velocity());
}

TEST(AvoaImproved, PassesEveryUWithoutTouchingOrDithering) {
  expect_passed(u_shape(6, 3, 3), 32.0, 1);   // measured 27.4 s
  expect_passed(u_shape(8, 2, 2), 32.0, 1);   // 23.0 s
  expect_passed(u_shape(10, 4, 4), 32.0, 1);  // 25.2 s
  expect_passed(u_shape(10, 4, 6), 32.0, 1);  // 27.0 s
  expect_passed(u_shape(14, 5, 10), 40.0, 1);
}

TEST(AvoaImproved, ComesOutOfAUThatItStartsIn) {
  Course deep = u_shape(8, 3, 6);
  deep.start.position = {4, 0};
  expect_passed(deep, 45.0, 1);  // measured 36.4 s
  Course narrow = u_shape(7, 2, 7);
  narrow.start.position = {3.5, 0};
  expect_passed(narrow, 45.0, 2);  // 39.2 s, turning on the spot
  Course aside = u_shape(8, 5, 4);
  aside.start.position = {5, -2};
  aside.start.yaw = 1.2;
  expect_passed(aside, 45.0, 1);  // 29.8 s
}

TEST(AvoaImproved, ComesOutOfAUThatItSeesOnlyFromWithin) {
  Course course = u_shape(6, 3, 3);
  course.sight = 4.0;
  expect_passed(course, 45.0, 1);  // measured 33.2 s
  course = u_shape(10, 4, 6);
  course.sight = 4.0;
  expect_passed(course, 50.0, 2);  // 39.6 s
}

TEST(AvoaImproved, PassesUShapesThatAreNotQuiteRegular) {
  for (std::uint64_t i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    expect_passed(jittered(u_shape(6, 3, 3), Rng{21}.stream("U", i)), 40.0, 2);
  }
}

TEST(AvoaImproved, InACurrentItKeepsClearOfTheUAhead) {
  for (int k = 0; k < 8; ++k) {
    SCOPED_TRACE(k);
    Course course = u_shape(10, 4, 4);
    course.start.current = 0.2 * Vec2{std::cos(k * pi / 4), std::sin(k * pi / 4)};
    expect_passed(course, 40.0, 2);
  }
}

TEST(AvoaImproved, WithoutTheTurnAndTheMemoryTheUIsNotPassed) {
  const auto fails = [](const Course& course, bool turn_aware, bool memory) {
    const Passage p = passage(course, with(turn_aware, memory));
    return p.clearance < 0.0 || p.arrival < 0.0;
  };
  Course inside = u_shape(8, 3, 6);
  inside.start.position = {4, 0};
  EXPECT_TRUE(fails(inside, false, false));
  EXPECT_TRUE(fails(inside, true, false));
  EXPECT_TRUE(fails(inside, false, true));
  EXPECT_FALSE(fails(inside, true, true));
}

TEST(AvoaImproved, MeetsAVesselEndOnWithoutTouching) {
  Course course;
  course.vessels = {{.id = TrackId{1}, .position = {16, 0, 0}, .velocity = {-0.55, 0, 0}, .radius = 0.75}};
  const Passage p = passage(course, improved());
  EXPECT_GT(p.clearance, 0.2);
  EXPECT_LT(p.arrival, 25.0);
  EXPECT_GT(p.arrival, 0.0);
  double farthest = 0.0;
  for (const Vec2& at : p.path) farthest = std::fmax(farthest, at.y());
  EXPECT_GT(farthest, 1.0) << "to starboard";
}

TEST(AvoaImproved, TheSideIsKeptWhenTheOtherBecomesALittleShorterAndFreeAgainBehindIt) {
  Situation s = northbound();
  s.own.velocity = Vec3::Zero();
  std::vector<Obstacle> wall;
  for (int e = -3; e <= 3; ++e) wall.push_back(buoy(8, e + 0.2));
  s.obstacles = wall;
  const AvoaImproved method{};
  AvoaImproved::Memory memory;
  Rng rng{1};
  Context context{rng};
  const auto side = [&] {
    const double heading = std::atan2(memory.committed->y(), memory.committed->x());
    return heading > 0.0 ? 1 : -1;
  };
  (void)method.decide(s, memory, context);
  ASSERT_TRUE(memory.committed);
  const int chosen = side();
  EXPECT_EQ(chosen, -1);  // the shorter one

  // a little nearer to the other end
  s.own.position = {0, 0.6, 0};
  (void)method.decide(s, memory, context);
  EXPECT_EQ(side(), chosen);
  AvoaImproved::Memory fresh;
  (void)method.decide(s, fresh, context);
  EXPECT_GT(fresh.committed->y(), 0.0) << "who comes anew takes the other side";

  // past it
  s.own.position = {10, -5, 0};
  (void)method.decide(s, memory, context);
  EXPECT_FALSE(memory.committed);
}

TEST(AvoaImproved, InADeadEndItTurnsOnTheSpot) {
  Situation s = northbound();
  s.own.velocity = Vec3::Zero();
  std::vector<Obstacle> pen;
  for (const Obstacle& b : u_shape(2, 2, 5).buoys) pen.push_back(b);
  s.obstacles = pen;
  const Command command = improved().decide(s);
  EXPECT_EQ(command.mode, Mode::avoid);
  ASSERT_TRUE(command.turn_rate);
  EXPECT_NEAR(std::abs(*command.turn_rate), 0.3751, 1e-12);
  EXPECT_LE(command.velocity.x(), 0.0);
}

TEST(AvoaImproved, AVehicleThatGoesSidewaysAsWellNeedNotTurn) {
  const auto command = [](double sideways) {
    Situation s = northbound();
    s.own.velocity = Vec3::Zero();
    s.own.yaw = 1.5;
    const std::vector<Obstacle> beside{buoy(3.0, 1.0)};
    s.obstacles = beside;
    const Envelope envelope{.ahead = 1.2,
                            .sideways = sideways,
                            .acceleration = 0.5,
                            .deceleration = 0.5,
                            .turn_acceleration = 0.5,
                            .turn_rates = {0.4, 0.4, 0.4, 0.4}};
    s.envelope = &envelope;
    return improved().decide(s);
  };
  const Command turns = command(0.0), as_it_is = command(1.0);
  EXPECT_TRUE(turns.turn_rate) << "it turns on the spot first";
  EXPECT_FALSE(as_it_is.turn_rate);
  EXPECT_GT(as_it_is.velocity.x(), 1.0);
}

TEST(AvoaImproved, WhatItsNavigationStatesIsKeptAsIfItsSphereWereLarger) {
  const auto beside = [](double sigma, double radius) {
    Situation s = northbound();
    s.own.position_sigma = sigma;
    s.own.radius = radius;
    const std::array buoys{buoy(8, 1.5)};
    s.obstacles = buoys;
    return improved().decide(s);
  };
  EXPECT_EQ(beside(0.25, 0.75), beside(0.0, 1.25));
  EXPECT_NE(beside(0.25, 0.75), beside(0.0, 0.75));
}

TEST(AvoaImproved, WhereNothingIsFreeItBrakesAndSaysSo) {
  Situation s = northbound();
  std::vector<Obstacle> ahead;
  for (int e = -4; e <= 4; ++e) ahead.push_back(buoy(1.6, 0.5 * e));
  s.obstacles = ahead;
  const Command command = improved().decide(s);
  EXPECT_EQ(command.mode, Mode::infeasible);
  EXPECT_LT(command.velocity.x(), 0.01);
}

TEST(AvoaImproved, WithinAPolygonOrOverAnObstacleItAnswersAtOnce) {
  Situation s = northbound();
  const std::array<Vec3, 4> square{Vec3{-5, -5, 0}, Vec3{5, -5, 0}, Vec3{5, 5, 0}, Vec3{-5, 5, 0}};
  std::vector<Obstacle> solids{{.kind = Obstacle::Kind::polygon, .vertices = square}, buoy(0, 0)};
  s.obstacles = solids;
  const Command command = improved().decide(s);
  EXPECT_TRUE(is_finite(command));
  EXPECT_NE(command.mode, Mode::cruise);
}

}  // namespace
}  // namespace fairway
