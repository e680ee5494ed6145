// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/explain/stroke_facts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fairway {
namespace {

TEST(StrokeFacts, CountHalfSpacesThatForbidAndThatAreActive) {
  Drawing drawing;
  drawing.half_space({0.3, 0, 0}, {-1, 0, 0}, "ahead");  // no faster than 0.3 m/s north
  drawing.half_space({0.1, 0, 0}, {1, 0, 0}, "astern");  // no slower than 0.1 m/s north
  drawing.half_space({0, 0.2, 0}, {0, 1, 0}, "ahead");   // 0.2 m/s east at least
  const auto facts = facts_of(drawing.strokes(), {0.5, 0, 0}, {0.3, 0.1, 0});
  ASSERT_EQ(facts.size(), 2u);
  EXPECT_EQ(facts[0].meaning, "ahead");
  EXPECT_EQ(facts[0].count, 2u);
  EXPECT_EQ(facts[0].forbids_preferred, 2u);
  EXPECT_EQ(facts[0].active, 1u);
  EXPECT_EQ(facts[0].forbids_commanded, 1u);
  EXPECT_EQ(facts[1].forbids_preferred, 0u);
  EXPECT_EQ(facts[1].active, 0u);
  EXPECT_DOUBLE_EQ(margin_of(drawing.strokes()[0], {0.5, 0, 0}), -0.2);
}

TEST(StrokeFacts, SeeWhichVelocitiesAreInsideARegion) {
  Drawing drawing;
  // an L: the notch in its corner is outside
  drawing.region(
      std::array{Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{2, 1, 0}, Vec3{1, 1, 0}, Vec3{1, 2, 0}, Vec3{0, 2, 0}},
      "forbidden");
  const Stroke& region = drawing.strokes()[0];
  EXPECT_TRUE(contains(region, {0.5, 0.5, 0}));
  EXPECT_TRUE(contains(region, {1.5, 0.5, 0}));
  EXPECT_TRUE(contains(region, {0.5, 1.5, 3}));
  EXPECT_FALSE(contains(region, {1.5, 1.5, 0}));
  EXPECT_FALSE(contains(region, {-0.5, 0.5, 0}));
  EXPECT_FALSE(contains(region, {2.5, 0.5, 0}));
  const auto facts = facts_of(drawing.strokes(), {0.5, 0.5, 0}, {1.5, 1.5, 0});
  EXPECT_EQ(facts[0].forbids_preferred, 1u);
  EXPECT_EQ(facts[0].forbids_commanded, 0u);
}

TEST(StrokeFacts, MeasurePathsAndTrees) {
  Drawing drawing;
  const std::array points{Vec3{0, 0, 0}, Vec3{3, 4, 0}, Vec3{3, 4, 1}, Vec3{3, 6, 1}};
  drawing.path(points, "trajectory");
  drawing.tree(points, "tree");
  const auto facts = facts_of(drawing.strokes(), Vec3::Zero(), Vec3::Zero());
  ASSERT_EQ(facts.size(), 2u);
  EXPECT_DOUBLE_EQ(facts[0].length, 8.0);
  EXPECT_DOUBLE_EQ(facts[1].length, 7.0) << "two edges; what is between them is none";
}

}  // namespace
}  // namespace fairway
