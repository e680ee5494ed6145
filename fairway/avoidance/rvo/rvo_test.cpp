// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/rvo/rvo.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/velocity_obstacle/testing/meeting.hpp"

namespace fairway {
namespace {

using encounters::decide;
using velocity_obstacle::Tally;

TEST(Rvo, HeadOnTakesHalfOfTheWayToTheTangentToStarboard) {
  // p = 8 north, R = 2, the apex is 0: the foot of v_d = 1 on the leg at sine 1/4
  const double cosine = std::sqrt(15.0) / 4.0;
  const Vec3 foot = cosine * Vec3(cosine, 0.25, 0.0);
  EXPECT_LT((decide<Rvo>(encounters::head_on(8.0)).velocity - foot).norm(), 1e-14);
}

// One of 1000 dances: both choose the same side, see it and choose the other, until they brake.
TEST(Rvo, TwoThatBothUseItHardlyEverTouch) {
  const Tally all = velocity_obstacle::tally(1000, Rvo{});
  EXPECT_LE(all.touched, 1);       // measured 1
  EXPECT_GT(all.least_gap, -0.1);  // measured -0.081
  EXPECT_EQ(all.arrived, 1000);
}

TEST(Rvo, TwoAlikeHeadOnPassPortToPort) { velocity_obstacle::expect_port_to_port(Rvo{}); }

}  // namespace
}  // namespace fairway
