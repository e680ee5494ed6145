// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/hrvo/hrvo.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/velocity_obstacle/testing/meeting.hpp"

namespace fairway {
namespace {

using encounters::decide;
using encounters::OwnedSituation;
using velocity_obstacle::Tally;

TEST(Hrvo, HeadOnItIsRvoToStarboard) {
  const double cosine = std::sqrt(15.0) / 4.0;
  const Vec3 foot = cosine * Vec3(cosine, 0.25, 0.0);
  EXPECT_LT((decide<Hrvo>(encounters::head_on(8.0)).velocity - foot).norm(), 1e-14);
}

TEST(Hrvo, TheSideOnWhichTheyPassAnywayIsKept) {
  // the other is 0.5 m to port, so both pass to starboard of each other; a wish to port does not change it
  OwnedSituation e = encounters::head_on(8.0);
  e.tracks[0].position.y() = -0.5;
  e.situation.goal.velocity = Vec3{0.99, -0.1, 0.0};
  EXPECT_GT(decide<Hrvo>(e).velocity.y(), 0.1);
  e.tracks[0].position.y() = 0.5;
  e.situation.goal.velocity = Vec3{0.99, 0.1, 0.0};
  EXPECT_LT(decide<Hrvo>(e).velocity.y(), -0.1);
}

TEST(Hrvo, TwoThatBothUseItNeverTouch) {
  const Tally all = velocity_obstacle::tally(1000, Hrvo{});
  EXPECT_EQ(all.touched, 0);
  EXPECT_GT(all.least_gap, -1e-9);  // measured 1e-9
  EXPECT_EQ(all.arrived, 1000);
}

TEST(Hrvo, TwoAlikeHeadOnPassPortToPort) { velocity_obstacle::expect_port_to_port(Hrvo{}); }

}  // namespace
}  // namespace fairway
