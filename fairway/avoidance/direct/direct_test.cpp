// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/direct/direct.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway {
namespace {

using encounters::decide;
TEST(Direct, RunsDownWhoeverIsInTheWay) {
  EXPECT_EQ(decide<Direct>(encounters::head_on(2.0)),
            (Command{.velocity = {1.0, 0.0, 0.0}, .mode = Mode::cruise}));
}

TEST(Direct, StopsOnTheGoal) {
  encounters::OwnedSituation e = encounters::open_water();
  e.situation.goal.position = e.situation.own.position + Vec3{0.0, 0.0, 0.04};
  EXPECT_LT((decide<Direct>(e).velocity - Vec3(0.0, 0.0, 0.4)).norm(),
            1e-12);  // there within one period of 0.1 s
}

TEST(Direct, TakesTheMissionsVelocityWhenThereIsOne) {
  encounters::OwnedSituation e = encounters::open_water();
  e.situation.goal.velocity = Vec3{0.0, -3.0, 0.0};
  EXPECT_EQ(decide<Direct>(e).velocity, Vec3(0.0, -1.5, 0.0));  // at most 1.5 m/s
}

}  // namespace
}  // namespace fairway
