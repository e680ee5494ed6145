// SPDX-License-Identifier: Apache-2.0
#include "fairway/world/obstacle_field.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

ObstacleSpec sphere(const Vec3& at, const Vec3& velocity) {
  ObstacleSpec spec{.kind = Obstacle::Kind::sphere, .velocity = velocity};
  spec.position = at;
  spec.radius = 2.0;
  return spec;
}

TEST(ObstacleField, WhatDriftsIsApartFromWhatStays) {
  ObstacleField field{{sphere({1, 0, 0}, {0, 0, 0}), sphere({5, 0, 0}, {0, 0.5, 0})}};
  field.move_to(10.0);
  ASSERT_EQ(field.fixed().size(), 1U);
  ASSERT_EQ(field.drifters().size(), 1U);
  EXPECT_EQ(field.drifters()[0].number, 1U);
  EXPECT_EQ(field.drifters()[0].position, Vec3(5, 5, 0));
}

TEST(ObstacleField, ACopyLooksAtItsOwnVertices) {
  ObstacleSpec prism{.kind = Obstacle::Kind::polygon};
  prism.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  auto first = std::make_unique<ObstacleField>(std::vector{prism});
  ObstacleField copy{*first};
  first.reset();
  EXPECT_NEAR(nearest_point(copy.fixed()[0], {-3, 1, 0}).distance, 3.0, 1e-15);
}

}  // namespace
}  // namespace fairway
