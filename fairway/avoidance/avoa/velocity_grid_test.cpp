// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/velocity_grid.hpp"

#include <gtest/gtest.h>

namespace fairway::avoa {
namespace {

TEST(VelocityGrid, BeginsWithTheFastestAheadAndToPort) {
  const VelocityGrid grid{101, 1.5};
  EXPECT_EQ(grid.velocity(0), Vec2(1.5, -1.5));
  EXPECT_EQ(grid.velocity(100), Vec2(1.5, 1.5));
  EXPECT_EQ(grid.velocity(grid.cell_count() - 1), Vec2(-1.5, 1.5));
  EXPECT_DOUBLE_EQ(grid.spacing(), 0.03);
}

TEST(VelocityGrid, HasStandingStillInItsMiddleIfOdd) {
  for (const int side : {3, 51, 101, 401}) {
    const VelocityGrid grid{side, 1.5};
    EXPECT_EQ(grid.velocity(grid.cell_count() / 2), Vec2(0.0, 0.0)) << side;
  }
}

TEST(VelocityGrid, EveryCellIsNearestToItsVelocityAndToWhatIsLessThanHalfAStepAway) {
  for (const int side : {2, 3, 50, 101}) {
    const VelocityGrid grid{side, 0.7};
    const double almost_half = 0.499 * grid.spacing();
    for (int cell = 0; cell < grid.cell_count(); ++cell) {
      const Vec2 v = grid.velocity(cell);
      EXPECT_EQ(grid.cell_at(v), cell);
      const Vec2 inwards{v.x() > 0.0 ? -almost_half : almost_half, v.y() > 0.0 ? -almost_half : almost_half};
      EXPECT_EQ(grid.cell_at(v + inwards), cell);
    }
  }
}

TEST(VelocityGrid, KnowsWhatIsOutside) {
  const VelocityGrid grid{101, 1.5};
  for (const Vec2& v : {Vec2{1.51, 0.0}, Vec2{0.0, -1.51}, Vec2{1e300, 0.0}, Vec2{0.0, std::nan("")}}) {
    EXPECT_EQ(grid.cell_at(v), VelocityGrid::outside);
  }
}

TEST(PolarVelocity, IsSpeedAndHeadingFromTheBow) {
  const PolarVelocity abeam = PolarVelocity::of({0.0, 0.5});
  EXPECT_DOUBLE_EQ(abeam.speed, 0.5);
  EXPECT_DOUBLE_EQ(abeam.heading, pi / 2.0);
  EXPECT_LT((abeam.cartesian() - Vec2{0.0, 0.5}).norm(), 1e-15);
  EXPECT_EQ(PolarVelocity::of({0.0, 0.0}).heading, 0.0);
}

TEST(PolarVelocity, HeadingsTurnTheShortWayRound) {
  EXPECT_EQ(wrapped(3.0), 3.0);
  EXPECT_NEAR(wrapped(4.0), 4.0 - 2.0 * pi, 1e-15);
  EXPECT_NEAR(wrapped(-15.0), -15.0 + 4.0 * pi, 1e-14);
}

}  // namespace
}  // namespace fairway::avoa
