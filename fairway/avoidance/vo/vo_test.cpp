// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/vo/vo.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/velocity_obstacle/testing/meeting.hpp"

namespace fairway {
namespace {

using encounters::decide;
using encounters::OwnedSituation;
using velocity_obstacle::Tally;

TEST(Vo, HeadOnTakesTheWholeWayToTheTangentToStarboard) {
  // p = 8 north, R = 2, v_o = -1: the legs leave -1 at sine 1/4, v_d = 1 is 2 cos along from there
  const double cosine = std::sqrt(15.0) / 4.0;
  const Vec3 foot = Vec3(-1.0, 0.0, 0.0) + 2.0 * cosine * Vec3(cosine, 0.25, 0.0);
  EXPECT_LT((decide<Vo>(encounters::head_on(8.0)).velocity - foot).norm(), 1e-14);
}

TEST(Vo, MeetingBeyondTheHorizonChangesNothing) {
  // 8 m at 2 m/s with R = 2: they touch after 3 s
  const OwnedSituation e = encounters::head_on(8.0);
  EXPECT_EQ(decide<Vo>(e, {.time_horizon_s = 2.9}).velocity, Vec3(1.0, 0.0, 0.0));
  EXPECT_NE(decide<Vo>(e, {.time_horizon_s = 3.1}).velocity, Vec3(1.0, 0.0, 0.0));
}

TEST(Vo, SlowApproachBrakesAtTheArcOfTheHorizon) {
  // p / T = 1.6, R / T = 0.4; v_d = 1.3 north is nearest to 1.2
  OwnedSituation e = encounters::open_water(1.3);
  e.tracks = {encounters::track(1, {8.0, 0.0, 50.0}, Vec3::Zero())};
  EXPECT_LT((decide<Vo>(e).velocity - Vec3(1.2, 0.0, 0.0)).norm(), 1e-14);
}

// Both do all of it, see in the next moment that it was too much, and go back: the paper's concussive
// avoidance. It grazes, since whoever returns touches the boundary anew in each step.
TEST(Vo, TwoThatBothUseItGrazeEachOther) {
  const Tally all = velocity_obstacle::tally(1000, Vo{});
  EXPECT_GT(all.least_gap, -0.02);  // measured -0.0094
  EXPECT_GT(all.touched, 200);      // measured 386
  EXPECT_EQ(all.arrived, 1000);
}

}  // namespace
}  // namespace fairway
