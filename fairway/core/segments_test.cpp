// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/segments.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

TEST(Segments, NearestIsAnEndOrBetween) {
  const Vec3 a{0, 0, 0}, b{10, 0, 0};
  EXPECT_EQ(nearest_on_segment<Vec3>(a, b, {-3, 4, 0}), a);
  EXPECT_EQ(nearest_on_segment<Vec3>(a, b, {4, 4, 3}), Vec3(4, 0, 0));
  EXPECT_EQ(nearest_on_segment<Vec3>(a, a, {4, 4, 3}), a) << "a segment may be a point";
  EXPECT_EQ(distance_to_segment<Vec3>(a, b, {4, 4, 3}), 5.0);
}

TEST(Segments, InAPlaneTheirDistanceIsThatOfAnEndOrNoneWhereTheyCross) {
  EXPECT_EQ(distance_between(Vec2{-1, 0}, Vec2{1, 0}, Vec2{0, -1}, Vec2{0, 1}), 0.0);
  EXPECT_EQ(distance_between(Vec2{-1, 0}, Vec2{1, 0}, Vec2{0, 2}, Vec2{0, 5}), 2.0);
  EXPECT_EQ(distance_between(Vec2{-1, 0}, Vec2{1, 0}, Vec2{-5, 3}, Vec2{9, 3}), 3.0);
}

TEST(Segments, InSpaceTheyPassEachOtherWithinBoth) {
  EXPECT_EQ(distance_between(Vec3{-1, 0, 0}, Vec3{1, 0, 0}, Vec3{0, -1, 2}, Vec3{0, 1, 2}), 2.0);
  EXPECT_EQ(distance_between(Vec3{-1, 0, 0}, Vec3{1, 0, 0}, Vec3{-1, 0, 4}, Vec3{1, 0, 4}), 4.0)
      << "parallel";
  EXPECT_EQ(distance_between(Vec3{0, 0, 0}, Vec3{0, 0, 0}, Vec3{0, 3, 4}, Vec3{0, 3, 4}), 5.0) << "points";
}

TEST(Segments, InSpaceTheirDistanceIsTheLeastOfManyPoints) {
  Rng rng{1};
  const auto drawn = [&] { return Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)}; };
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = drawn(), b = drawn(), c = drawn();
    const Vec3 d = i % 4 == 0 ? Vec3{c + (b - a) + 1e-9 * drawn()} : drawn();  // some are almost parallel
    double least = std::numeric_limits<double>::infinity();
    constexpr int parts = 400;
    for (int k = 0; k <= parts; ++k)
      least = std::min(least, distance_to_segment<Vec3>(c, d, a + (b - a) * k / parts));
    const double found = distance_between(a, b, c, d);
    EXPECT_LE(found, least + 1e-12);
    EXPECT_GE(found, least - (b - a).norm() / parts);
  }
}

}  // namespace
}  // namespace fairway
