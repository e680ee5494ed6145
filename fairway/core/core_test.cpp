// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fairway/core/rng.hpp"
#include "fairway/core/shapes.hpp"
#include "fairway/core/state.hpp"

namespace fairway {
namespace {

TEST(Rng, ACopyHasTheSameFuture) {
  Rng a{42};
  a.next();
  Rng b = a;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.next(), b.next());
}

TEST(Rng, StreamsOfOtherNamesAndIndicesDiffer) {
  const Rng rng{7};
  Rng a = rng.stream("sonar", 1), b = rng.stream("sonar", 2), c = rng.stream("dvl", 1);
  const auto x = a.next(), y = b.next(), z = c.next();
  EXPECT_NE(x, y);
  EXPECT_NE(x, z);
  EXPECT_NE(y, z);
}

TEST(Rng, NormalDrawsHaveMeanZeroAndDeviationOne) {
  Rng rng{3};
  constexpr int n = 200000;
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i) {
    const double x = rng.normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / n, 0.0, 4 / std::sqrt(n));  // four standard errors
  EXPECT_NEAR(squares / n, 1.0, 4 * std::sqrt(2.0 / n));
}

TEST(Angles, WrapIntoHalfATurn) {
  EXPECT_NEAR(wrap_angle(3 * pi + 0.1), -pi + 0.1, 1e-12);
  EXPECT_NEAR(wrap_angle(-0.5), -0.5, 0.0);
}

TEST(Angles, WrapToTheBitsOfTheRemainder) {
  const auto expect_remainder = [](double angle) {
    const double wrapped = wrap_angle(angle), remainder = std::remainder(angle, 2 * pi);
    EXPECT_EQ(wrapped, remainder) << angle;
    EXPECT_EQ(std::signbit(wrapped), std::signbit(remainder)) << angle;
  };
  for (int eighths = -40; eighths <= 40; ++eighths) {
    const double angle = eighths * (pi / 4);
    for (const double near : {angle, std::nextafter(angle, -100.0), std::nextafter(angle, 100.0)})
      expect_remainder(near);
  }
  Rng rng{1};
  for (int i = 0; i < 10'000; ++i) expect_remainder(rng.uniform(-20.0, 20.0));
  expect_remainder(-0.0);
  EXPECT_TRUE(std::isnan(wrap_angle(std::nan(""))));
}

TEST(State, EulerAnglesAndQuaternionAgree) {
  Rng rng{5};
  for (int i = 0; i < 1000; ++i) {
    const Euler e{rng.uniform(-3, 3), rng.uniform(-1.5, 1.5), rng.uniform(-3, 3)};
    const Euler back = euler_of(quaternion_of(e));
    EXPECT_NEAR(back.roll, e.roll, 1e-9);
    EXPECT_NEAR(back.pitch, e.pitch, 1e-9);
    EXPECT_NEAR(back.yaw, e.yaw, 1e-9);
  }
}

TEST(State, YawTurnsForwardToStarboard) {
  VehicleState x;
  x.q_nb = quaternion_of({.yaw = pi / 2});
  x.v_b = {1, 0, 0};
  EXPECT_NEAR((x.v_n() - Vec3(0, 1, 0)).norm(), 0.0, 1e-15);  // east
}

TEST(Shapes, NearestPointOfASphereLiesOnIt) {
  const Obstacle ball{.kind = Obstacle::Kind::sphere, .position = {10, 0, 0}, .radius = 2};
  const SurfacePoint near = nearest_point(ball, {0, 0, 0});
  EXPECT_NEAR((near.point - Vec3(8, 0, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(near.distance, 8.0, 1e-12);
  EXPECT_NEAR(nearest_point(ball, {10, 0, 1}).distance, -1.0, 1e-12);
}

TEST(Shapes, APrismIsSolidAtEveryDepth) {
  const std::array<Vec3, 4> corners{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{4, 4, 0}, Vec3{0, 4, 0}};
  const Obstacle box{.kind = Obstacle::Kind::polygon, .vertices = corners};
  EXPECT_NEAR(nearest_point(box, {2, 1, 30}).distance, -1.0, 1e-12);
  const SurfacePoint outside = nearest_point(box, {6, 2, 5});
  EXPECT_NEAR(outside.distance, 2.0, 1e-12);
  EXPECT_NEAR((outside.point - Vec3(4, 2, 5)).norm(), 0.0, 1e-12);
}

TEST(Shapes, ASegmentOfNoLengthIsAPoint) {
  const Obstacle post{.kind = Obstacle::Kind::segment, .from = {1, 1, 1}, .to = {1, 1, 1}};
  EXPECT_NEAR(nearest_point(post, {1, 1, 4}).distance, 3.0, 1e-12);
}

}  // namespace
}  // namespace fairway
