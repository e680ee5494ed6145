// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/drawing.hpp"

#include <gtest/gtest.h>

#include <array>

namespace fairway {
namespace {

using Kind = Stroke::Kind;

const std::array points{Vec3{1.0, 2.0, 3.0}, Vec3{4.0, 5.0, 6.0}};
const std::vector<Vec3> both{points.begin(), points.end()};

TEST(Drawing, KeepsEveryKindOfStrokeInOrder) {
  Drawing drawing;
  Sketch& sketch = drawing;
  sketch.velocity(points[0], "wish");
  sketch.half_space(points[0], points[1], "allowed");
  sketch.region(points, "forbidden");
  sketch.path(points, "way");
  sketch.tree(points, "search");
  sketch.sphere(points[1], 7.0, "range");
  const std::array<std::uint32_t, 4> pixels{1, 2, 3, 4};
  sketch.image({.rgb = pixels, .side = 2, .reach = 8.0, .yaw = 9.0}, "zones");

  const std::vector<Stroke> expected{
      {.kind = Kind::velocity, .meaning = "wish", .points = {points[0]}},
      {.kind = Kind::half_space, .meaning = "allowed", .points = both},
      {.kind = Kind::region, .meaning = "forbidden", .points = both},
      {.kind = Kind::path, .meaning = "way", .points = both},
      {.kind = Kind::tree, .meaning = "search", .points = both},
      {.kind = Kind::sphere, .meaning = "range", .points = {points[1]}, .size = 7.0},
      {.kind = Kind::image, .meaning = "zones", .size = 8.0, .yaw = 9.0, .side = 2, .rgb = {1, 2, 3, 4}},
  };
  EXPECT_EQ(std::vector<Stroke>(drawing.strokes().begin(), drawing.strokes().end()), expected);
  ASSERT_EQ(expected.size(), EnumNames<Kind>::names.size());
}

TEST(Drawing, KeepsWhatItWasShownWhenThatIsGone) {
  Drawing drawing;
  {
    const std::string meaning = "a meaning that is too long to lie within a string itself";
    std::vector<std::uint32_t> pixels(9, 0xABCDEFU);
    std::vector<Vec3> way = both;
    drawing.path(way, meaning);
    drawing.image({.rgb = pixels, .side = 3}, meaning);
    way.assign(2, Vec3::Zero());
    pixels.assign(9, 0);
  }
  EXPECT_EQ(drawing.strokes()[0].points, both);
  EXPECT_EQ(drawing.strokes()[1].rgb, std::vector<std::uint32_t>(9, 0xABCDEFU));
  EXPECT_EQ(drawing.strokes()[1].meaning, "a meaning that is too long to lie within a string itself");
}

TEST(Drawing, IsEmptyOnceCleared) {
  Drawing drawing;
  drawing.velocity(points[0], "wish");
  EXPECT_EQ(drawing.strokes().size(), 1U);
  drawing.clear();
  EXPECT_TRUE(drawing.strokes().empty());
}

}  // namespace
}  // namespace fairway
