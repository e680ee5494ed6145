// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/avoider_gate.hpp"

#include <gtest/gtest.h>

namespace fairway::ros1 {
namespace {

bridge::Motion motion_at(double time) {
  bridge::Motion motion;
  motion.time = time;
  return motion;
}

TEST(AvoiderGate, opens_once_when_the_last_of_an_instant_has_come) {
  AvoiderGate gate{3};
  EXPECT_FALSE(gate.opens());
  gate.hear(2, motion_at(0.0));
  gate.hear(0, motion_at(0.0));
  EXPECT_FALSE(gate.opens());
  EXPECT_FALSE(gate.is_open());
  gate.hear(1, motion_at(0.0));
  EXPECT_TRUE(gate.opens());
  EXPECT_FALSE(gate.opens());
  EXPECT_TRUE(gate.is_open());
}

TEST(AvoiderGate, waits_for_whoever_is_behind) {
  AvoiderGate gate{2};
  gate.hear(1, motion_at(5.0));
  for (const double time : {1.0, 2.0, 3.0, 4.0}) {
    gate.hear(0, motion_at(time));
    EXPECT_FALSE(gate.opens());
  }
  gate.hear(0, motion_at(5.0));
  EXPECT_TRUE(gate.opens());
  EXPECT_EQ(gate.motion(1).time, 5.0);
}

TEST(AvoiderGate, opens_again_when_a_run_begins_again) {
  AvoiderGate gate{1};
  gate.hear(0, motion_at(7.0));
  EXPECT_TRUE(gate.opens());
  gate.hear(0, motion_at(0.0));
  EXPECT_FALSE(gate.is_open());
  EXPECT_TRUE(gate.opens());
}

}  // namespace
}  // namespace fairway::ros1
