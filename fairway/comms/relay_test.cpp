// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fairway/comms/testing/acoustic_sea.hpp"
#include "fairway/core/error.hpp"

namespace fairway {
namespace {

using namespace acoustic_sea;

TEST(Relay, ARelayRepeatsWhatItHearsAndReachesTwiceAsFar) {
  // 75 m to the relay and 75 m on: 0.32 + 0.05 s each, 0.74 s in all, first whole tick at 0.75 s
  const std::vector<Vec3> apart = pair(150);
  Sea direct{{}, apart}, relayed{{.relay = true, .relay_east_m = 75}, apart};
  for (int i = 0; i < 15; ++i) relayed.tick();
  EXPECT_FALSE(relayed.heard(1, 0).told);
  relayed.tick();
  EXPECT_TRUE(relayed.heard(1, 0).told);
  EXPECT_EQ(relayed.heard(1, 0).sent, Tick{0});
  direct.run(60);
  EXPECT_EQ(direct.counts().received, 0);

  // a slot holds both: twice 0.32 s and the way over 80 m, 0.747 s
  EXPECT_DOUBLE_EQ(relayed.channel.slot_time(), 0.75);
  relayed.run(120);
  EXPECT_EQ(relayed.counts().drowned, 0);
  EXPECT_EQ(relayed.counts().lost, 0);
}

TEST(Relay, WhoIsOutOfTheRelaysRangeIsNotHeardThoughTheOtherIsNear) {
  Sea sea{{.relay = true, .relay_east_m = -79}, pair(2)};  // 79 m and 81 m from it
  sea.run(60);
  EXPECT_EQ(sea.counts().received, 0);
  EXPECT_EQ(sea.counts().out_of_range, sea.counts().sent);
}

TEST(Relay, WhatIsLostOnTheWayToTheRelayIsLostForAll) {
  Sea sea{{.update_rate_hz = 1, .relay = true, .loss_ratio = 0.3}, row(4)};
  sea.run(20000);
  // each of the two ways lets 0.7 through
  const AcousticCounts& counts = sea.counts();
  EXPECT_NEAR(static_cast<double>(counts.received) / static_cast<double>(counts.received + counts.lost), 0.49,
              0.02);
}

TEST(Relay, ARelayNeedsSlots) { EXPECT_THROW((Sea{{.slots = false, .relay = true}, pair(10)}), InputError); }

}  // namespace
}  // namespace fairway
