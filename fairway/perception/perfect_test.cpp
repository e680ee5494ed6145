// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/perfect.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

Message message(std::uint32_t id, const Vec3& at) {
  Message m{.from = VehicleId{id}};
  m.position = at;
  m.radius = 1.0;
  return m;
}

TEST(PerfectPerception, DriftersAreTracksAmongTheOthersNearestFirst) {
  const Mailbox mailbox{message(0, {0, 0, 0}), message(1, {10, 0, 0}), message(2, {30, 0, 0})};
  const std::vector<Drifter> drifters{
      {.number = 3, .position = {20, 0, 0}, .velocity = {0, 1, 0}, .radius = 2}};
  PerfectPerception perception{4};
  std::vector<Track> tracks;
  perception.perceive(mailbox, drifters, 0, {.vehicles = 100, .obstacles = 100}, tracks);

  ASSERT_EQ(tracks.size(), 3U);
  EXPECT_TRUE(tracks[0].reacts);
  EXPECT_FALSE(tracks[1].reacts);
  EXPECT_EQ(tracks[1].position, Vec3(20, 0, 0));
  EXPECT_EQ(tracks[1].velocity, Vec3(0, 1, 0));
  EXPECT_LT(tracks[1].priority, tracks[0].priority);
}

TEST(PerfectPerception, ADrifterIsPerceivedFromSurfaceToSurface) {
  const Mailbox mailbox{message(0, {0, 0, 0})};  // sphere of 1 m
  PerfectPerception perception{1};
  std::vector<Track> tracks;
  const auto seen = [&](double distance) {
    const std::vector<Drifter> drifters{{.position = {distance, 0, 0}, .radius = 2}};
    perception.perceive(mailbox, drifters, 0, {.vehicles = 1e9, .obstacles = 5}, tracks);
    return !tracks.empty();
  };
  EXPECT_TRUE(seen(8.0));  // 5 + 1 + 2
  EXPECT_FALSE(seen(8.001));
}

TEST(PerfectPerception, WhatIsChartedIsKnownAndTheRestOnceNear) {
  Obstacle charted{.kind = Obstacle::Kind::sphere, .position = {100, 0, 0}, .radius = 1};
  Obstacle uncharted = charted;
  uncharted.charted = false;
  const std::vector<Obstacle> all{charted, uncharted};
  std::vector<Obstacle> known;
  perceive_obstacles(all, {0, 0, 0}, 3.0, {.obstacles = 10}, known);
  ASSERT_EQ(known.size(), 1U);
  EXPECT_TRUE(known[0].charted);
  perceive_obstacles(all, {86, 0, 0}, 3.0, {.obstacles = 10}, known);
  EXPECT_EQ(known.size(), 2U);
}

}  // namespace
}  // namespace fairway
